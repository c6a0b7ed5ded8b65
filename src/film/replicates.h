#pragma once

// How sure a pixel's mean is. Samples of a low-discrepancy sequence are no independent numbers: their
// mean is better than their spread says. So they come as a few sets ("replicates"), each a sequence
// with scramblings of its own: the means of the sets are independent of each other, and their spread
// gives the variance of the mean of all without bias (Owen 1997, "Monte Carlo variance of scrambled net
// quadrature").

#include <array>

#include "frames/packet.h"
#include "tracer/sample.h"

namespace restframe {

inline constexpr int replicate_count = 4;

// Below this luminance errors count as if it were this bright.
inline constexpr double least_judged_luminance = 0.05;

// The samples of 16 pixels. All sets get equally many, or one more.
class Replicates {
 public:
  // Adds `scale` times what one sample of an exposure saw.
  void add(int replicate, const RadianceLanes& radiance, float scale);
  // Once a sample, however many exposures it has: they add up to one number.
  void count(int replicate) { ++counts_[static_cast<std::size_t>(replicate)]; }

  int samples() const;
  Vec4f mean(int lane) const;
  // Of the mean of red, green and blue. At least two sets must have samples.
  Vec3f variance(int lane) const;

  // The root mean square, over the active pixels, of the standard error of a pixel's luminance over
  // that luminance (at least least_judged_luminance).
  double noise(const Lanes<std::int32_t>& active) const;

 private:
  using Vec3d = glm::dvec3;
  Vec3d mean_of(int lane) const;
  // `of` maps linear Rec. 709 to what the variance is of.
  template <class Quantity>
  auto variance_of(int lane, const Quantity& of) const;

  std::array<Lanes<glm::dvec4>, replicate_count> sums_{};
  std::array<int, replicate_count> counts_{};
};

}  // namespace restframe
