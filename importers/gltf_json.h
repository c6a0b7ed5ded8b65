#pragma once

#include <nlohmann/json.hpp>

#include "importers/gltf_context.h"

namespace restframe {

using Json = nlohmann::json;

// Parses glTF's JSON text with bounds on depth and numbers of elements; duplicate keys, numbers too
// large for double and invalid UTF-8 are faults. Leaves out every `extras`: nothing here reads
// them.
Json parse_gltf_json(const GltfContext& context, const std::string& text);

}  // namespace restframe
