#pragma once

#include <vector>

#include "importers/gltf_context.h"
#include "importers/gltf_files.h"
#include "importers/gltf_json.h"

namespace tinygltf {
class Model;
}

namespace restframe {

// What tinygltf makes of a checked document. The buffers' bytes are moved into the model, never
// copied. Images are left out: `read_images` has them.
tinygltf::Model parse_model(const GltfContext& context, Json document, std::vector<Bytes> buffers);

}  // namespace restframe
