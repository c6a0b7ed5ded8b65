#pragma once

#include "importers/importers.h"
#include "importers/obj_data.h"

namespace restframe {

// Throws InputError at the first fault. Warns of each kind of statement that is not used.
ObjData parse_obj(const Path& path, const ImportLimits& limits, Warnings& warnings);

}  // namespace restframe
