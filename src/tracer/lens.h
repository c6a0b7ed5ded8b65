#pragma once

#include <cmath>
#include <numbers>

#include "physics/vectors.h"

namespace restframe {

// The unit square's points spread evenly over the unit disc, squares to rings, so that what is well
// distributed stays so (Shirley and Chiu 1997).
inline Vec2 on_unit_disc(double u, double v) {
  const double a = 2.0 * u - 1.0;
  const double b = 2.0 * v - 1.0;
  constexpr double eighth = 0.25 * std::numbers::pi;
  if (std::abs(a) > std::abs(b)) {
    const double angle = eighth * (b / a);
    return {a * std::cos(angle), a * std::sin(angle)};
  }
  if (b == 0.0) return {0.0, 0.0};
  const double angle = eighth * (a / b);
  return {b * std::sin(angle), b * std::cos(angle)};
}

}  // namespace restframe
