#pragma once

// Tangents for normal maps, generated as MikkTSpace does (Mikkelsen, "Simulation of Wrinkled
// Surfaces Revisited", 2008, and his reference's rules for which triangles share a tangent).

#include <array>
#include <cstdint>
#include <vector>

#include "scene/material.h"
#include "scene/mesh.h"

namespace restframe {

// The tangent at a triangle's corner, as mesh.h has it: unit length in units of 1/32767, and the
// sign of the bitangent. All 0 where the texture coordinates give no direction.
using CornerTangent = std::array<std::int16_t, 4>;

CornerTangent packed_tangent(const Vec4f& tangent);
inline Vec4f unpacked(const CornerTangent& t) {
  constexpr float unit = 1.0F / 32767.0F;
  return {unit * t[0], unit * t[1], unit * t[2], t[3]};
}

// Three a triangle, along +U of the coordinates that `transform` makes of that UV set. None if the
// mesh has no such set. Takes linear time, on all threads.
std::vector<CornerTangent> corner_tangents(const Mesh& mesh, int uv_set,
                                           const UvTransform& transform);

}  // namespace restframe
