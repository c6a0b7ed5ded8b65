#pragma once

#include <glm/vec4.hpp>
#include <optional>

#include "tracer/sample.h"

namespace restframe {

// Sums of many samples of 16 pixels. Floats that are added one by one lose digits: sums of so many
// are put together in double.
class SampleSum {
 public:
  static constexpr int subtotal_samples = 64;

  // After sample `index` was added to `sum`: starts `sum` anew now and then.
  void take_subtotal(int index, RadianceLanes& sum) {
    if ((index + 1) % subtotal_samples != 0) return;
    add(sum);
    sum.fill(Vec4f(0));
  }
  // After the last sample: `sum` becomes that of all.
  void complete(RadianceLanes& sum) {
    if (!large_) return;
    add(sum);
    for (int i = 0; i < packet_size; ++i) sum[i] = Vec4f((*large_)[i]);
  }

 private:
  void add(const RadianceLanes& sum) {
    if (!large_) large_.emplace().fill(glm::dvec4(0));
    for (int i = 0; i < packet_size; ++i) (*large_)[i] += glm::dvec4(sum[i]);
  }

  std::optional<Lanes<glm::dvec4>> large_;
};

}  // namespace restframe
