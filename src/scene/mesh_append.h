#pragma once

#include "scene/mesh.h"

namespace restframe {

// Does as append(), but frees each attribute of `part` once it is in, and gives the mesh's attributes
// as much room as its positions have.
void append_and_free(Mesh& mesh, Mesh part, int slot);

}  // namespace restframe
