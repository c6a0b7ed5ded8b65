#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

// Mesh `index` of a checked document, its primitives joined; `slots` are those of its primitives'
// materials. Has no triangles if the mesh is only of points and lines.
Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, std::size_t index,
               const std::vector<int>& slots);

}  // namespace restframe
