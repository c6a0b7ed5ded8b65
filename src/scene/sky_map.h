#pragma once

#include <string>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

// Radiance from all directions at infinity, as a latitude-longitude picture (the convention of
// Blender and of glTF's viewers): the middle column looks along the map's +X, the column a quarter
// to the right of it along +Z, a quarter to the left along -Z; row 0 is at the zenith, +Y.
struct SkyMap {
  std::string name;
  int width = 0, height = 0;
  std::vector<Vec3f> pixels;  // linear Rec. 709, 0 or more, row by row
};

// Where a direction (unit, the map's axes) lies in the map, in pixels from its top left corner.
struct SkyPlace {
  double x = 0, y = 0;
};
SkyPlace sky_place(const SkyMap& map, const Vec3& direction);
Vec3 sky_direction(const SkyMap& map, const SkyPlace& place);

// Four neighbouring pixels, around a place that lies between their centres: columns wrap around,
// and beyond the poles' rows there are those rows again.
struct SkyCell {
  int column = 0, row = 0;  // of the upper left pixel: -1 to width - 1, -1 to height - 1
};
struct SkyCorners {
  Vec3f upper_left{0}, upper_right{0}, lower_left{0}, lower_right{0};
};
SkyCorners corners(const SkyMap& map, const SkyCell& cell);

// Between the four pixels around it (bilinear).
Vec3f radiance_at(const SkyMap& map, const SkyPlace& place);

}  // namespace restframe
