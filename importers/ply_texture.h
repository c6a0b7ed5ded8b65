#pragma once

#include <string>
#include <vector>

#include "importers/importers.h"

namespace restframe {

// Gives the asset's material the image that a `comment TextureFile` line of the PLY file at `path`
// names: the first of them; it must lie in the file's folder or below. A missing image is a
// warning; throws InputError for one that can not be read.
void add_ply_texture(const std::vector<std::string>& names, const Path& path,
                     const ImportLimits& limits, Asset& asset, Warnings& warnings);

}  // namespace restframe
