#pragma once

// The cameras and lights of an asset, where its nodes place them.

#include "importers/scene_file.h"

namespace restframe {

// The camera that `camera` in the table names, or the first one of the objects' nodes; with
// what the asset says of it, and what `camera` says if that is a table.
void read_asset_camera(TableReader& root, const AssetObjects& objects, SceneFile& file);

// Every light of the objects' nodes, in their order; true if there are any. Spots and suns that their
// transform leaves no direction are left out with a warning.
bool add_asset_lights(const AssetObjects& objects, SceneFile& file);

}  // namespace restframe
