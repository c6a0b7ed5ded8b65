#pragma once

#include <tiny_gltf.h>

#include "importers/gltf_context.h"

namespace restframe {

// Mesh `index` of a checked document, its primitives joined; a primitive's material is its slot,
// and those without one use `default_slot`. Has no triangles if the mesh is only of points and
// lines.
Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, std::size_t index,
               int default_slot);

}  // namespace restframe
