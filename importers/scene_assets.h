#pragma once

#include <vector>

#include "scene/asset.h"
#include "scene/scene.h"

namespace restframe {

// What the objects made of one asset share, in the scene's indices.
struct SceneAsset {
  std::vector<PlacedMesh> parts;    // object_from_mesh: the asset's own asset_from_mesh
  std::vector<Material> materials;  // by slot
};

// Moves the asset's meshes, textures and images into the scene.
SceneAsset add_asset(Scene& scene, Asset asset);

// The parts of an object whose coordinates are object_from_asset times the asset's.
std::vector<PlacedMesh> placed_parts(const SceneAsset& asset, const Mat4& object_from_asset);

}  // namespace restframe
