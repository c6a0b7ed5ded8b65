#pragma once

#include <vector>

#include "scene/asset.h"
#include "scene/scene.h"

namespace restframe {

// What the objects made of one asset share, in the scene's indices.
struct SceneAsset {
  std::vector<Part> parts;          // of all the asset's scenes, in the order of their nodes
  std::vector<Material> materials;  // by slot
  AssetTree tree;
};

// Moves the asset's meshes, textures and images into the scene.
SceneAsset add_asset(Scene& scene, Asset asset);

// The parts of an object that holds these nodes, and whose coordinates are object_from_asset times
// the asset's.
std::vector<PlacedMesh> placed_parts(const SceneAsset& asset, const NodeRanges& nodes,
                                     const Mat4& object_from_asset);

}  // namespace restframe
