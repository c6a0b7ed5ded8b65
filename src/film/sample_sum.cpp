#include "film/sample_sum.h"

namespace restframe {

void SampleSum::add(const RadianceLanes& sum) {
  if (!is_used_) large_.fill(glm::dvec4(0));
  is_used_ = true;
  for (int i = 0; i < packet_size; ++i) large_[i] += glm::dvec4(sum[i]);
}

void SampleSum::replace(RadianceLanes& sum) const {
  for (int i = 0; i < packet_size; ++i) sum[i] = Vec4f(large_[i]);
}

}  // namespace restframe
