#include "film/part_totals.h"

#include "physics/clones.h"

namespace restframe {

RESTFRAME_CLONES void PartTotals::add_sample() {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const Vec3fLanes& next = sample_->at(columns_[column]);
    Vec3Lanes& sum = sums_[column];
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      sum.x[i] += static_cast<double>(next.x[i]);
      sum.y[i] += static_cast<double>(next.y[i]);
      sum.z[i] += static_cast<double>(next.z[i]);
    }
  }
}

// Light of exposures adds up, unless their mean is asked for; a surface's colour does not.
void PartTotals::take(int lane, int samples, std::span<Vec3f> colors) const {
  const double of_mean = 1.0 / (static_cast<double>(samples) * settings_.count);
  const double of_light = settings_.combine == Combine::sum ? 1.0 / samples : of_mean;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const bool is_light = columns_[column] != SampleParts::albedo;
    colors[column] = Vec3f(sums_[column].at(lane) * (is_light ? of_light : of_mean));
  }
}

}  // namespace restframe
