#pragma once

// Which geometry nodes need. A node may give a mesh weights for its morph targets, and joints: each
// choice of them makes another mesh.

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

struct PosedMesh {
  int mesh = 0;
  int skin = -1;
  bool mirrored = false;        // skinned by a node whose transform mirrors: glTF 2.0, 3.7.4
  std::vector<double> weights;  // of the morph targets; empty: all 0
};

// What nodes place, and those meshes that none does, as they are. The nodes' `mesh` is made to be an
// index into the result; the first pose of a mesh has the mesh's own. Fault: more geometry in all
// than the limits allow.
std::vector<PosedMesh> pose_meshes(const GltfContext& context, tinygltf::Model& model);

}  // namespace restframe
