#pragma once

#include <set>
#include <string>
#include <vector>

#include "importers/importers.h"
#include "importers/tinyobj.h"

namespace restframe {

// One newmtl of an MTL file.
struct MtlMaterial {
  std::string name;
  tinyobj::material_t values;
  std::set<std::string>
      given;  // the keys that it states, of those that are used: Kd, d, map_Kd ...
  Path file;  // textures are relative to its folder
};

// Appends the materials of an MTL file. Throws InputError for malformed numbers and for whatever
// makes it unreadable.
void read_mtl(const Path& path, const ImportLimits& limits, std::vector<MtlMaterial>& materials,
              Warnings& warnings);

}  // namespace restframe
