#pragma once

#include <cstdint>
#include <vector>

#include "physics/vectors.h"
#include "scene/mesh.h"

namespace restframe {

// A mesh for the purpose of normals: vertices of one position are one.
struct Surface {
  std::vector<Triangle> triangles;  // of positions
  std::uint32_t positions = 0;
  std::vector<Vec3> face_normals;  // unit length; zero for triangles without area
};

// Sectors: the corners around a position between two creases, which share a normal. `sector` holds
// one number a corner (three a triangle, in order), below `count`.
struct Sectors {
  std::vector<std::uint32_t> sector;
  std::uint32_t count = 0;
};

// Whether a half-edge structure can hold the surface: at most two faces at an edge, wound alike;
// one fan of faces at a position; and not so many at one position that building it takes long.
bool fits_half_edges(const Surface& surface);

// Walks a half-edge structure. The surface must fit.
Sectors half_edge_sectors(const Surface& surface, double cos_crease);

// For any surface: joins corners across each edge that has just two faces, wound alike. The same
// sectors where the surface fits.
Sectors edge_map_sectors(const Surface& surface, double cos_crease);

// Whether the surface is smooth across an edge between faces of these normals.
inline bool is_smooth(const Vec3& normal_a, const Vec3& normal_b, double cos_crease) {
  return glm::dot(normal_a, normal_b) > cos_crease && normal_a != Vec3(0) && normal_b != Vec3(0);
}

}  // namespace restframe
