#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

using Triangle = std::array<std::uint32_t, 3>;  // vertex indices, counter-clockwise from the front

// From triangle `first_triangle` on, up to the next range's, the mesh uses this material slot of
// its asset.
struct MaterialRange {
  std::uint32_t first_triangle = 0;
  int slot = 0;
};

// Triangles as Embree reads them, in the asset's own coordinates. Attributes are empty or one a
// vertex.
struct Mesh {
  std::string name;
  std::vector<Vec3f> positions;  // capacity of one more than size: Embree reads 16 bytes a vertex
  std::vector<Triangle> triangles;
  std::vector<Vec3f> normals;  // unit length; empty: the triangles' own
  // Along +U of the first UV set, unit length; w is 1 where -V (an image's upper side) is along
  // cross(normal, tangent), -1 where against. 0 where a part has none. Only with normals.
  std::vector<Vec4f> tangents;
  // As many sets as the file gives, any of them empty; the first two are always there.
  std::vector<std::vector<Vec2f>> uvs = std::vector<std::vector<Vec2f>>(2);
  std::vector<Vec4f> colors;             // linear RGBA, multiplied with the base colour
  std::vector<MaterialRange> materials;  // at least one; sorted, the first at triangle 0
};

// Beyond, in any of a vertex's coordinates, Embree loses triangles.
inline constexpr double largest_coordinate = 1e15;

struct Bounds {
  Vec3 lower{1e300}, upper{-1e300};

  bool empty() const { return lower.x > upper.x; }
  Vec3 center() const { return 0.5 * (lower + upper); }
  Vec3 extent() const { return upper - lower; }
  void add(const Vec3& p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
};

Bounds bounds_of(const Mesh& mesh);

// What its vertices and triangles take.
std::size_t bytes_of(const Mesh& mesh);

// Triangles without area.
std::size_t count_degenerate(const Mesh& mesh);

// Gives `to` the vertices `which` of `from`, with all their attributes and room for Embree's reads;
// its triangles stay. Both may be the same mesh.
void take_vertices(const Mesh& from, const std::vector<std::uint32_t>& which, Mesh& to);

// The material slot of a triangle: of many ranges by bisection, of the usual few without a call.
int find_material_slot(const Mesh& mesh, std::uint32_t triangle);
inline int material_slot(const Mesh& mesh, std::uint32_t triangle) {
  constexpr std::size_t few = 4;
  std::size_t range = mesh.materials.size() - 1;
  if (range >= few) return find_material_slot(mesh, triangle);
  while (range > 0 && triangle < mesh.materials[range].first_triangle) --range;
  return mesh.materials[range].slot;
}

// Appends `part` to `mesh`, its triangles using `slot`. Attributes that one of the two lacks are
// filled in: UVs and tangents with 0, colours with white, normals with those of the triangles'
// corners.
void append(Mesh& mesh, const Mesh& part, int slot);

// Makes room for Embree's reads past the last vertex. Whoever builds a mesh calls it at the end.
void pad_for_embree(Mesh& mesh);

}  // namespace restframe
