#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "importers/gltf_context.h"
#include "importers/gltf_texture.h"

namespace restframe {

// Fills the asset's materials (slot = index in the model) and textures. Textures' `image` is an
// index into the asset's images, which are the model's images `used_images` in this order.
void read_materials(const GltfContext& context, const tinygltf::Model& model, Asset& asset,
                    std::vector<UsedImage>& used_images);

// What the extensions of a material say of it; `pointer` is its place, for warnings.
void read_material_extensions(const tinygltf::Material& source, TextureTable& textures,
                              const std::string& pointer, Material& material);

// Where meshes lack the texture coordinates that their materials ask for: a warning; and if none has
// them, the material uses set 0.
void check_uv_sets(const GltfContext& context, const tinygltf::Model& model, Asset& asset);

}  // namespace restframe
