#pragma once

#include <tiny_gltf.h>

#include "importers/gltf_context.h"
#include "importers/gltf_pose.h"
#include "importers/gltf_posed.h"

namespace restframe {

// A mesh of a checked document in a pose, its primitives joined; a primitive's material is its
// slot, and those without one use `default_slot`. Has no triangles if the mesh is only of points and
// lines.
Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, const PosedMesh& posed,
               Skins& skins, int default_slot);

}  // namespace restframe
