#pragma once

// The bytes that a glTF file refers to: data URIs, and files in its folder.

#include <cstdint>
#include <string>
#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

using Bytes = std::vector<std::uint8_t>;

// What `uri` stands for, at most `limit` bytes. `pointer` is the URI's place, for faults.
Bytes read_uri(const GltfContext& context, const std::string& pointer, const std::string& uri,
               std::size_t limit);

}  // namespace restframe
