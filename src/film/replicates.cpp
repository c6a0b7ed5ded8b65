#include "film/replicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace restframe {
namespace {

double luminance(const glm::dvec3& rgb) {
  return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));  // Rec. 709
}

}  // namespace

void Replicates::add(int replicate, const RadianceLanes& radiance, float scale) {
  Lanes<glm::dvec4>& sum = sums_[static_cast<std::size_t>(replicate)];
  for (int i = 0; i < packet_size; ++i) sum[i] += glm::dvec4(scale * radiance[i]);
}

int Replicates::samples() const {
  return std::accumulate(counts_.begin(), counts_.end(), 0);
}

Vec4f Replicates::mean(int lane) const {
  glm::dvec4 sum(0);
  for (const Lanes<glm::dvec4>& part : sums_) sum += part[lane];
  return Vec4f(sum / static_cast<double>(samples()));
}

Replicates::Vec3d Replicates::mean_of(int lane) const {
  Vec3d sum(0);
  for (const Lanes<glm::dvec4>& part : sums_) sum += Vec3d(part[lane]);
  return sum / static_cast<double>(samples());
}

// With n_r samples in set r, its mean has the variance v / n_r, of which
// sum of n_r (mean of set r - mean)^2 over (sets - 1) is an unbiased estimate; the mean of all n
// samples has v / n.
template <class Quantity>
auto Replicates::variance_of(int lane, const Quantity& of) const {
  const auto mean = of(mean_of(lane));
  auto sum = mean - mean;
  int sets = 0;
  for (std::size_t r = 0; r < sums_.size(); ++r) {
    if (counts_[r] == 0) continue;
    const double n = counts_[r];
    const auto deviation = of(Vec3d(sums_[r][lane]) / n) - mean;
    sum += n * deviation * deviation;
    ++sets;
  }
  return sum / (static_cast<double>(std::max(1, sets - 1)) * samples());
}

Vec3f Replicates::variance(int lane) const {
  return Vec3f(variance_of(lane, [](const Vec3d& rgb) { return rgb; }));
}

double Replicates::noise(const Lanes<std::int32_t>& active) const {
  double sum = 0;
  int pixels = 0;
  for (int i = 0; i < packet_size; ++i) {
    if (active[i] == 0) continue;
    const double judged = std::max(luminance(mean_of(i)), least_judged_luminance);
    sum += variance_of(i, luminance) / (judged * judged);
    ++pixels;
  }
  return pixels == 0 ? 0.0 : std::sqrt(sum / pixels);
}

}  // namespace restframe
