#pragma once

#include <tiny_gltf.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

// An image of the model that a texture in use shows.
struct UsedImage {
  int image = 0;
  bool is_seen = false;  // the picture would be plainly wrong without it
};

// A use of a texture as the document has it.
struct TextureSource {
  int index = -1;  // into the model's textures; -1: none
  int uv_set = 0;
  UvTransform transform;
  float scale = 1;  // of a normal texture
};
TextureSource texture_source(const tinygltf::TextureInfo& info);
TextureSource texture_source(const tinygltf::NormalTextureInfo& info);
// In an extension, which need not have it.
TextureSource texture_source(const tinygltf::Value& extension, const std::string& key);

// What a texture holds: colour without which the picture is wrong, colour that finishes a surface,
// numbers.
enum class TextureKind : std::uint8_t { seen_color, color, data };

// Collects the textures that materials use: each once as colour and once as data, with its image.
class TextureTable {
 public:
  TextureTable(const GltfContext& context, const tinygltf::Model& model, Asset& asset,
               std::vector<UsedImage>& used_images)
      : context_(context), model_(model), asset_(asset), used_images_(used_images) {}

  // None, with a warning that begins with `pointer`, where the texture has no image that can be
  // read.
  TextureUse use(const TextureSource& source, TextureKind kind, const std::string& pointer);

 private:
  Texture make(const tinygltf::Texture& source, bool srgb);
  int image_of(int source);

  const GltfContext& context_;
  const tinygltf::Model& model_;
  Asset& asset_;
  std::vector<UsedImage>& used_images_;
  std::map<std::pair<int, bool>, int> textures_;
  std::map<int, int> images_;
};

}  // namespace restframe
