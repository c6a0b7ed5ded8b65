#pragma once

#include "importers/gltf_json.h"
#include "scene/asset_tree.h"

namespace restframe {

// The lights of KHR_lights_punctual and the cameras of a checked document, by their own indices.
std::vector<Light> read_gltf_lights(const Json& document);
std::vector<AssetCamera> read_gltf_cameras(const Json& document);

// The light at each node; -1: none.
std::vector<int> read_light_indices(const Json& document);

}  // namespace restframe
