#pragma once

#include <cstddef>
#include <string>

namespace restframe {

// Writes a GLB once more, the triangles of its first primitive shared out to so many primitives that
// all name the same list of vertices, as exporters write a mesh of many materials.
void split_glb(const std::string& from, const std::string& to, std::size_t primitives);

}  // namespace restframe
