#pragma once

#include <glm/vec4.hpp>

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
    if (!is_used_) return;
    add(sum);
    replace(sum);
  }

 private:
  // Not inline: where these doubles are not used, they are not even to be cleared.
  void add(const RadianceLanes& sum);
  void replace(RadianceLanes& sum) const;

  bool is_used_ = false;
  Lanes<glm::dvec4> large_;
};

}  // namespace restframe
