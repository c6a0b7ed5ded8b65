#include "tracer/film_samples.h"

namespace restframe {

std::vector<Vec2f> film_offsets(int samples) {
  constexpr double plastic = 1.32471795724474602596;  // x^3 = x + 1
  std::vector<Vec2f> offsets;
  offsets.reserve(static_cast<std::size_t>(samples));
  for (int i = 0; i < samples; ++i) {
    const double u = std::fmod(0.5 + i / plastic, 1.0);
    const double v = std::fmod(0.5 + i / (plastic * plastic), 1.0);
    offsets.emplace_back(tent_quantile(u), tent_quantile(v));
  }
  return offsets;
}

}  // namespace restframe
