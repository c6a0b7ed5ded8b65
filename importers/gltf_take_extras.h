#pragma once

#include "importers/gltf_json.h"
#include "scene/asset_tree.h"

namespace restframe {

// Takes every `extras.restframe` out of a checked document, in the order of ExtrasOf, then of
// glTF's own indices. Where nothing reads one, a warning says so.
std::vector<AssetExtras> take_extras(const GltfContext& context, Json& document);

}  // namespace restframe
