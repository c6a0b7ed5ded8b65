#pragma once

#include "scene/mesh.h"

namespace restframe {

// Whether the triangles bound bodies: each edge is shared by exactly two, which run along it in
// opposite directions, so that what goes in comes out and normals agree on which side is out.
// Vertices of equal position count as one (meshes are split where normals or UVs jump); triangles
// that this makes lines or points do not count. False for no triangles.
bool is_closed(const Mesh& mesh);

// The same of those triangles alone that use the material slot.
bool is_closed(const Mesh& mesh, int slot);

}  // namespace restframe
