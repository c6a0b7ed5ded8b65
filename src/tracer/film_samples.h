#pragma once

#include <cmath>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

// Where on the film a pixel's samples lie, as offsets from the pixel's centre, in pixels.
//
// They are distributed as the reconstruction filter (a tent of radius one pixel), so a pixel is the
// plain mean of its own samples: no sample belongs to two pixels, and no order of adding matters.
// The points are a Kronecker sequence of the plastic number (Roberts' R2) that starts at the
// centre: sample 0 always is the pixel's centre, and data layers hold it. All pixels have the same
// offsets: neighbours then agree along an edge.
std::vector<Vec2f> film_offsets(int samples);

// Inverse of the filter's cumulative distribution along one axis, on [-1, 1].
inline double tent_quantile(double u) {
  return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 * (1.0 - u));
}

}  // namespace restframe
