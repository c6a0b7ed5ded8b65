#pragma once

#include "importers/importers.h"
#include "importers/mtl_read.h"

namespace restframe {

// What is used where no MTL file says anything.
Material grey_material(const std::string& name);

// The colours and numbers of an MTL material, brought into the ranges of Material; not its
// textures. scenes/reference.md has the formulas.
Material material_from_mtl(const MtlMaterial& source, Warnings& warnings);

}  // namespace restframe
