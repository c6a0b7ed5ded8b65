#pragma once

// Authoring in the asset: what glTF's `extras.restframe` says of nodes, materials, lights, cameras
// and the scene (design, section 5). The keys are those of the scene file.

#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "importers/config_value.h"
#include "importers/scene_assets.h"
#include "physics/worldline.h"

namespace restframe {

// A worldline with a clock, as Object and Light have it.
struct ClockedWorldline {
  Worldline worldline;
  double clock = 0;          // what the clock shows at the reference event ...
  bool frame_clock = false;  // ... or: the rest frame's own time
};

// A node that is, with all below it, an object of its own.
struct NodeMotion {
  int node = 0;
  TextPosition at;            // of what says so
  Vec3 origin{0};             // of the node, in the asset
  ClockedWorldline own;       // of that point, with the asset's lengths, axes and times
  bool has_velocity = false;  // stated, be it zero
  bool has_clock = false;
};

// What an asset says, but for materials, which are as it says already.
struct AssetAuthoring {
  std::filesystem::path path;       // of the asset
  std::vector<NodeMotion> motions;  // in the order of their nodes
  std::vector<int> owners;          // of each node, the motion it goes with, or -1; empty: all rest
  std::map<int, ConfigTable> lights, cameras;  // by the tree's indices
  std::optional<ConfigTable> scene;            // of the default scene
};

struct SceneFile;

// Reads the asset's extras; its file lies at `path`. Faults are the file's.
AssetAuthoring read_asset_extras(SceneAsset& asset, const std::filesystem::path& path,
                                 SceneFile& file);

// "tram", or "node_3" where it has no name.
std::string node_name(const AssetTree& tree, int node);

}  // namespace restframe
