#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "frames/packet.h"
#include "physics/spectrum_table.h"

namespace restframe {

// What a path's light has gone through so far, so that it can be told for any wavelength: emission
// lines are not among those that the path was begun with. Without initial values, but for counts:
// most scenes have no lines.
class LineHistory {
 public:
  void clear() {
    count_.fill(0);
    most_left_.fill(1.0F);
  }

  // A fraction, by a colour, of light that has `omega` times the camera's frequency.
  void weigh(int lane, const Vec3f& weight, double omega) {
    most_left_[lane] *= std::max({weight.x, weight.y, weight.z});
    if (count_[lane] == most) return;
    steps_[static_cast<std::size_t>(count_[lane]++)][lane] = {weight, static_cast<float>(omega)};
  }
  // The path stands for others, too.
  void scale(int lane, float factor) {
    most_left_[lane] *= factor;
    if (count_[lane] > 0) steps_[static_cast<std::size_t>(count_[lane] - 1)][lane].weight *= factor;
  }

  // At most as much is left of any wavelength: each weight is a mix of its components.
  float most_left(int lane) const { return most_left_[lane]; }

  // What is left of light of a wavelength of the camera's.
  float left(int lane, float wavelength, const SpectrumTable& table) const {
    float left = 1;
    for (std::int32_t i = 0; i < count_[lane]; ++i) {
      const Step& step = steps_[static_cast<std::size_t>(i)][lane];
      left *= glm::dot(step.weight, Vec3f(table(wavelength / step.omega)));
    }
    return left;
  }

 private:
  struct Step {
    Vec3f weight;
    float omega;
  };
  // A path has at most 64 scatterings, each with a way through a medium before it, and one after.
  static constexpr std::int32_t most = 2 * 64 + 2;
  std::array<Lanes<Step>, most> steps_;
  Lanes<std::int32_t> count_;
  Lanes<float> most_left_;
};

}  // namespace restframe
