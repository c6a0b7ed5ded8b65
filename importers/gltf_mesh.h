#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"
#include "importers/gltf_pose.h"
#include "importers/gltf_posed.h"

namespace restframe {

// A mesh of a checked document in a pose, its primitives joined; `slots` are those of its
// primitives' materials. Has no triangles if the mesh is only of points and lines.
Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, const PosedMesh& posed,
               Skins& skins, const std::vector<int>& slots);

}  // namespace restframe
