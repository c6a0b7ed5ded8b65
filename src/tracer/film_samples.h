#pragma once

#include <vector>

#include "physics/vectors.h"

namespace restframe {

// Where on the film a pixel's samples lie, as offsets from the pixel's centre, in pixels.
//
// They are distributed as the reconstruction filter (a tent of radius one pixel), so a pixel is the
// plain mean of its own samples: no sample belongs to two pixels, and no order of adding matters.
// The points are a Kronecker sequence of the plastic number (Roberts' R2) that starts at the
// centre: sample 0 always is the pixel's centre, and data layers hold it. All pixels have the same offsets: neighbours then agree along an edge.
std::vector<Vec2f> film_offsets(int samples);

}  // namespace restframe
