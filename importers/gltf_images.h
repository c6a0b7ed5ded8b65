#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"
#include "importers/gltf_json.h"
#include "importers/gltf_material.h"

namespace restframe {

// Where an image's PNG or JPEG bytes are.
struct ImageSource {
  std::string name, uri;
  int view = -1;  // a bufferView, or -1: at the uri
};

// Takes the images out of a checked document.
std::vector<ImageSource> take_image_sources(Json& document);

// Decodes the images in use. Of those that are only data for shading, faults are no more than
// warnings: one white pixel stands in for them.
std::vector<Image> read_images(const GltfContext& context, const tinygltf::Model& model,
                               const std::vector<ImageSource>& sources,
                               const std::vector<UsedImage>& used);

}  // namespace restframe
