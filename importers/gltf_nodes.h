#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

// Fills the asset's parts, which name the model's meshes, and its tree's nodes and scenes.
// light_indices: the light at each of the model's nodes, or -1. Returns the index in the tree of
// each of the model's nodes; -1 where it is in no scene. A file without scenes has all its nodes in
// one.
std::vector<int> place_nodes(const GltfContext& context, const tinygltf::Model& model,
                             const std::vector<int>& light_indices, Asset& asset);

// Throws where the transform of the model's node can not be reckoned with.
void require_bounded(const GltfContext& context, int node, const Mat4& asset_from_node);

}  // namespace restframe
