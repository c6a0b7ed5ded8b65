#pragma once

#include <string>
#include <utility>
#include <vector>

#include "importers/importers.h"
#include "importers/obj_data.h"

namespace restframe {

// One mesh for each of data.groups that has triangles, with its number; objects and their groups in
// the order of the file. Uses `data` up but for its names. `slots` holds the material slot of each
// of data.materials, then that of faces without one. `file` begins the warnings.
std::vector<std::pair<int, Mesh>> build_obj_meshes(ObjData& data, const std::vector<int>& slots,
                                                   const std::string& file, Warnings& warnings);

// "object/group", or the one of them that there is.
std::string name_of(const ObjGroup& group);

}  // namespace restframe
