#include <algorithm>
#include <cmath>

#include "tracer/emitter_spectrum.h"

namespace restframe {
namespace {

// From D of 1/16 to 16; others are summed when they are met.
constexpr double octaves = 4;
constexpr int steps_an_octave = 128;
constexpr int size = static_cast<int>(2 * octaves) * steps_an_octave + 1;

}  // namespace

ShiftedDaylight::ShiftedDaylight(const Observer& observer) : observer_(observer) {
  for (int i = 0; i < size; ++i) {
    matrices_.push_back(matrix_at(std::exp2(static_cast<double>(i) / steps_an_octave - octaves)));
  }
}

glm::mat3 ShiftedDaylight::matrix_at(double doppler) const {
  const EmitterSpectrum daylight;
  glm::mat3 columns;
  for (int i = 0; i < 3; ++i) {
    Vec3f color(0);
    color[i] = 1;
    columns[i] = daylight.seen(observer_, color, 0.0F, doppler);
  }
  return columns;
}

Vec3f ShiftedDaylight::operator()(const Vec3f& color, double doppler) const {
  const double at = (std::log2(doppler) + octaves) * steps_an_octave;
  if (!(at >= 0 && at < size - 1)) return matrix_at(doppler) * color;
  const auto index = static_cast<std::size_t>(at);
  const auto fraction = static_cast<float>(at - static_cast<double>(index));
  return glm::mix(matrices_[index] * color, matrices_[index + 1] * color, fraction);
}

}  // namespace restframe
