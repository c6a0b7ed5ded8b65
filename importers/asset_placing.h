#pragma once

// What stands at an asset's nodes besides meshes, as it rests on an object made of them.

#include <optional>
#include <vector>

#include "importers/importers.h"
#include "scene/asset_tree.h"
#include "scene/scene.h"

namespace restframe {

// Some of an asset's nodes as an object has them: its coordinates are object_from_asset times the
// asset's.
struct PlacedNodes {
  const AssetTree& tree;
  const NodeRanges& nodes;
  const Object& object;
  const Mat4& object_from_asset;
};

struct PlacedLight {
  Light light;   // of the object's velocity and clock; named OBJECT/NODE
  int node = 0;  // of the tree
};

// The lights at the nodes, in their order. A scale makes them no brighter. Spots and suns that the
// transform leaves no direction are left out; `file` names them in the warning.
std::vector<PlacedLight> placed_lights(const PlacedNodes& placed, const std::string& file,
                                       Warnings& warnings);

// The first camera of perspective at the nodes that has a direction; it rides the object.
std::optional<Camera> placed_camera(const PlacedNodes& placed);

// Adds the lights to the scene, whose names get a number where there is such a one already.
void add_lights(std::vector<Light> lights, Scene& scene);

}  // namespace restframe
