#pragma once

// Nodes of an asset that move on their own, as objects.

#include <map>
#include <string>

#include "importers/scene_file.h"

namespace restframe {

// Nodes by what they go with: an object that the whole asset is placed as, or motions of the
// asset's authoring (their indices).
struct NodeGroups {
  NodeRanges resting;
  std::map<int, NodeRanges> moving;
};
NodeGroups grouped(const AssetAuthoring& said, const NodeRanges& nodes);

// A worldline in an asset that rests in the world as `base` does, there.
Worldline in_world(const Worldline& in_asset, const Object& base, const Mat4& object_from_asset);

// Adds an object for each motion, named `prefix` and its node's name. `base` is the index of the
// object that the asset is placed as, which rests. Returns their indices by motion.
std::map<int, int> add_moving_nodes(int base, const std::map<int, NodeRanges>& moving,
                                    const std::string& prefix, SceneFile& file);

}  // namespace restframe
