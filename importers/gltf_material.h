#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

// An image of the model that a texture in use shows.
struct UsedImage {
  int image = 0;
  bool is_seen = false;  // as colour, so that the picture would be wrong without it
};

// Fills the asset's materials (slot = index in the model) and textures. Textures' `image` is an
// index into the asset's images, which are the model's images `used_images` in this order.
void read_materials(const GltfContext& context, const tinygltf::Model& model, Asset& asset,
                    std::vector<UsedImage>& used_images);

}  // namespace restframe
