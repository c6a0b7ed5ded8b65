#pragma once

#include "importers/importers.h"

namespace restframe {

// Warns of meshes that let light in, by their materials, and are not closed: it would not find its
// way out. The scene is a valid one; `file` is named first.
void warn_of_open_glass(const Scene& scene, const Path& file, Warnings& warnings);

}  // namespace restframe
