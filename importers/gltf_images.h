#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"
#include "importers/gltf_json.h"
#include "importers/gltf_material.h"

namespace restframe {

// Where an image's PNG or JPEG bytes are.
struct ImageSource {
  std::string name, uri, mime_type;
  int view = -1;          // a bufferView, or -1: at the uri
  int same_as = 0;        // the first image with the same bytes, which may be this one
  std::vector<int> same;  // of such a first one: the others
};

// Takes the images out of a checked document.
std::vector<ImageSource> take_image_sources(Json& document);

// Lets textures show the first of images with the same bytes, so that those are decoded once.
void share_images(const std::vector<ImageSource>& sources, tinygltf::Model& model);

// Decodes the images in use, each once, on all threads, into the asset's images. Their sizes are
// checked against the limits before the first is decoded. Of faults, the first image's in the file's
// order is thrown: of those that show before decoding, then of those that decoding finds. Of images
// that are only data for shading, faults are no more than warnings: the asset's materials go without
// them, and one white pixel stands where they would be. The last to read the model's buffers: it
// may free them.
void read_images(const GltfContext& context, tinygltf::Model& model,
                 const std::vector<ImageSource>& sources, const std::vector<UsedImage>& used,
                 Asset& asset);

}  // namespace restframe
