#pragma once

#include <cstddef>
#include <string>

#include "scene/mesh.h"

namespace restframe {

// Makes the triangles of closed surfaces agree on which side is out, and out the side that the
// volume is not on. A surface is what hangs together by edges of just two triangles; it is closed
// if it has no others. Left as they are: open surfaces; those with edges of three triangles or
// more; those with one side only (Klein's bottle). Of a surface within another, which may be a
// cavity, the triangles are made to agree with the most of them. Vertices of equal position count as
// one. Returns how many triangles were turned over. For meshes without normals.
std::size_t orient_outwards(Mesh& mesh);

// The warning of it, for a file.
std::string turned_over(const std::string& file, std::size_t triangles);

}  // namespace restframe
