#pragma once

#include <optional>

#include "importers/gltf_context.h"
#include "importers/gltf_files.h"

namespace restframe {

// The two halves of a glTF file: JSON text, and the BIN chunk of a .glb.
struct GltfContainer {
  std::string json;
  std::optional<Bytes> bin;
};

// Reads context.path, .glb or .gltf by its first bytes. Every length is checked before memory is
// taken.
GltfContainer read_container(const GltfContext& context);

}  // namespace restframe
