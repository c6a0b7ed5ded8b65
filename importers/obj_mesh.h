#pragma once

#include <string>
#include <vector>

#include "importers/importers.h"
#include "importers/obj_parse.h"

namespace restframe {

// One mesh for each group of `data`, named after object and group, with normals. `slots` holds the
// material slot of each of data.materials, then that of faces without one. `file` begins the
// warnings.
std::vector<Mesh> build_obj_meshes(const ObjData& data, const std::vector<int>& slots,
                                   const std::string& file, Warnings& warnings);

}  // namespace restframe
