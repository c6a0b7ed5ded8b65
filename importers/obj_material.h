#pragma once

#include <vector>

#include "importers/importers.h"
#include "importers/obj_data.h"

namespace restframe {

// Reads the MTL files of `data` and fills the materials, textures and images of `asset` with those
// that faces use. Returns the material slot of each of data.materials, then that of faces without
// one (-1 if there are no such faces). A name that no MTL file has becomes a grey material.
std::vector<int> add_obj_materials(const ObjData& data, const Path& path,
                                   const ImportLimits& limits, Asset& asset, Warnings& warnings);

}  // namespace restframe
