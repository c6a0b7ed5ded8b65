#pragma once

// The cameras and lights of an asset, where its nodes place them.

#include <map>

#include "importers/scene_file.h"

namespace restframe {

// The objects that an asset is placed as.
struct AssetObjects {
  int whole = 0;                 // what has no motion of its own
  std::map<int, int> of_motion;  // those of its authoring's motions
};

// The camera that `camera` in the table names, or the first one of the default scene's nodes; with
// what the asset says of it, and what `camera` says if that is a table.
void read_asset_camera(TableReader& root, const AssetObjects& objects, SceneFile& file);

// Every light of the default scene's nodes; `path`: the asset's.
void add_asset_lights(const AssetObjects& objects, const Path& path, SceneFile& file);

}  // namespace restframe
