#pragma once

#include <optional>
#include <vector>

#include "importers/gltf_context.h"
#include "importers/gltf_files.h"
#include "importers/gltf_json.h"

namespace restframe {

// The bytes of every buffer of a checked document, exactly as many as it says. Those that only
// readers without meshoptimizer need are not read: they get one byte.
std::vector<Bytes> read_buffers(const GltfContext& context, Json& document,
                                std::optional<Bytes> bin);

// Decompresses the views that EXT_meshopt_compression made, each into a new buffer, and makes the
// document say so.
void decode_meshopt(const GltfContext& context, Json& document, std::vector<Bytes>& buffers);

// Decompresses the primitives that KHR_draco_mesh_compression made, each into a new buffer with
// views and accessors of their own, and makes the document say so.
void decode_draco(const GltfContext& context, Json& document, std::vector<Bytes>& buffers);

}  // namespace restframe
