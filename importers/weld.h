#pragma once

#include <cstdint>
#include <vector>

#include "importers/index_table.h"
#include "scene/mesh.h"

namespace restframe {

// The same for equal positions, and for no others: 0 and -0 are equal.
IndexTable::Key position_key(const Vec3f& position);

// Vertices that lie at exactly the same place as one: seams of texture coordinates do not show.
struct Weld {
  std::vector<std::uint32_t> place_of_vertex;
  std::uint32_t places = 0;
};
Weld weld(const std::vector<Vec3f>& positions);

// The mesh's triangles over places instead of vertices.
std::vector<Triangle> welded_triangles(const Mesh& mesh, const Weld& weld);

}  // namespace restframe
