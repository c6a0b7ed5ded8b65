#pragma once

// Which geometry nodes need. One mesh of a file stands still, but nodes may give it weights for its
// morph targets, and joints: each such pair is a mesh of its own.

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

struct MeshVariant {
  int mesh = 0;
  int skin = -1;
  bool mirrored = false;        // skinned by a node whose transform mirrors: glTF 2.0, 3.7.4
  std::vector<double> weights;  // of the morph targets; empty: all 0
};

// The variants that nodes place, and those meshes that none does as they are; the nodes' `mesh` is
// made to be the variant's index, which is that of the mesh wherever that is possible. Fault: more
// geometry in all than the limits allow.
std::vector<MeshVariant> make_variants(const GltfContext& context, tinygltf::Model& model);

}  // namespace restframe
