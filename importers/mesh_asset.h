#pragma once

#include <vector>

#include "importers/importers.h"

namespace restframe {

// The asset of the meshes that a file without materials holds, a part each: closed surfaces turned
// outwards where the file gives no normals, normals completed, one material called "default" (grey;
// white under colours). Warns of what was mended.
Asset make_mesh_asset(const Path& path, std::vector<Mesh> meshes, Warnings& warnings);

}  // namespace restframe
