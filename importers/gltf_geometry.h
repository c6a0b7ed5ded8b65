#pragma once

// What a mesh's numbers must be like, and the mending of those that need not stop the import.

#include <string>
#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

// Where a primitive's faults are reported.
struct PrimitivePlace {
  const GltfContext& context;
  std::string pointer;
};

// Faults: positions that are not finite or beyond 1e15; other attributes that are not finite.
// `first`: the number of the first vertex that is given.
void check_positions(const PrimitivePlace& place, const std::vector<Vec3f>& positions,
                     std::size_t first = 0);
void check_attributes(const PrimitivePlace& place, const Mesh& mesh, std::size_t first = 0);

// Fault: an index that is not below the number of vertices, or is `restart`, the greatest of its
// component type, which elsewhere would begin a new strip.
void check_indices(const PrimitivePlace& place, const std::uint32_t* indices, std::size_t count,
                   std::size_t vertices, std::uint32_t restart);

// Normals to unit length. Those that have no direction get that of the triangles around, with a
// warning.
void mend_normals(const PrimitivePlace& place, Mesh& mesh);

// Tangents to unit length, and their signs to 1 or -1. Those that have no direction become 0, with a
// warning.
void mend_tangents(const PrimitivePlace& place, Mesh& mesh);

// Numbers the vertices that triangles use from 0 on, in their order. Returns what their numbers were.
std::vector<std::uint32_t> renumber_used(std::vector<Triangle>& triangles);

// Removes vertices that no triangle uses: primitives often share one long list.
void drop_unused_vertices(Mesh& mesh);

}  // namespace restframe
