#pragma once

#include <tiny_gltf.h>

#include "importers/gltf_context.h"
#include "importers/gltf_pose.h"
#include "importers/gltf_variants.h"

namespace restframe {

// A variant of a mesh of a checked document, its primitives joined; a primitive's material is its
// slot, and those without one use `default_slot`. Has no triangles if the mesh is only of points and
// lines.
Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, const MeshVariant& variant,
               Skins& skins, int default_slot);

}  // namespace restframe
