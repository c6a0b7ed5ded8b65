#pragma once

#include <nlohmann/json.hpp>

#include "importers/gltf_context.h"

namespace restframe {

using Json = nlohmann::json;

// Parses glTF's JSON text with bounds on depth and numbers of elements; duplicate keys, numbers too
// large for double and invalid UTF-8 are faults. Of every `extras` leaves out all but
// `restframe`, and all of it but in elements of the document's and its extensions' arrays.
Json parse_gltf_json(const GltfContext& context, const std::string& text);

}  // namespace restframe
