#pragma once

#include <cstdint>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

// Where on the film a pixel's samples lie, as offsets from the pixel's centre, in pixels.
//
// They are distributed as the reconstruction filter (a tent of radius one pixel), so a pixel is the
// plain mean of its own samples: no sample belongs to two pixels, and no order of adding matters.
// The points are a Kronecker sequence of the plastic number (Roberts' R2) that starts at the
// centre: sample 0 always is the pixel's centre, and data layers hold it.
std::vector<Vec2f> film_offsets(int samples);

// One of the square's eight symmetries, chosen by `bits`, so that neighbouring pixels differ. The
// centre stays in place.
inline Vec2f turned(const Vec2f& offset, std::uint64_t bits) {
  const float x = (bits & 1) != 0 ? -offset.x : offset.x;
  const float y = (bits & 2) != 0 ? -offset.y : offset.y;
  return (bits & 4) != 0 ? Vec2f(y, x) : Vec2f(x, y);
}

}  // namespace restframe
