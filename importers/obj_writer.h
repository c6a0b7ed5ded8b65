#pragma once

#include <filesystem>

#include "scene/asset.h"

namespace restframe {

// Writes the asset's first mesh, with normals, as Wavefront OBJ, and its constant materials as an
// .mtl file beside it. Throws OutputError.
void write_obj(const Asset& asset, const std::filesystem::path& path);

}  // namespace restframe
