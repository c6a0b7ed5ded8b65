#include "importers/gltf_texture.h"

#include <cmath>

namespace restframe {
namespace {

constexpr const char* transform_extension = "KHR_texture_transform";

double number_in(const tinygltf::Value& object, const std::string& key, double otherwise) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : otherwise;
}

glm::dvec2 pair_in(const tinygltf::Value& object, const std::string& key,
                   const glm::dvec2& otherwise) {
  if (!object.Has(key)) return otherwise;
  const tinygltf::Value& pair = object.Get(key);
  return {pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()};
}

// Scaled, then turned, then moved. The turn is counter-clockwise as seen on the image, whose v runs
// down: what KHR_texture_transform says in words and examples, where its matrix has the sign wrong.
void read_transform(const tinygltf::Value& extension, TextureSource& source) {
  const glm::dvec2 scale = pair_in(extension, "scale", glm::dvec2(1));
  const double angle = number_in(extension, "rotation", 0);
  const double c = std::cos(angle), s = std::sin(angle);
  source.transform.along_u = Vec2f(scale.x * glm::dvec2(c, -s));
  source.transform.along_v = Vec2f(scale.y * glm::dvec2(s, c));
  source.transform.offset = Vec2f(pair_in(extension, "offset", glm::dvec2(0)));
  source.uv_set = static_cast<int>(number_in(extension, "texCoord", source.uv_set));
}

template <class Info>
TextureSource core_source(const Info& info) {
  TextureSource source{info.index, info.texCoord, {}, 1};
  const auto extension = info.extensions.find(transform_extension);
  if (extension != info.extensions.end()) read_transform(extension->second, source);
  return source;
}

Wrap wrap_of(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored_repeat;
  return Wrap::repeat;
}

// Of a sampler that names none (-1), both are the best there are.
void set_shrunken_filter(int filter, Texture& texture) {
  switch (filter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
      texture.shrunken_filter = TextureFilter::nearest;
      break;
    default:
      texture.shrunken_filter = TextureFilter::linear;
  }
  switch (filter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
      texture.mip_filter = MipFilter::none;
      break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
      texture.mip_filter = MipFilter::nearest;
      break;
    default:
      texture.mip_filter = MipFilter::linear;
  }
}

}  // namespace

TextureSource texture_source(const tinygltf::TextureInfo& info) {
  return core_source(info);
}

TextureSource texture_source(const tinygltf::NormalTextureInfo& info) {
  TextureSource source = core_source(info);
  source.scale = static_cast<float>(info.scale);
  return source;
}

TextureSource texture_source(const tinygltf::Value& extension, const std::string& key) {
  if (!extension.Has(key)) return {};
  const tinygltf::Value& info = extension.Get(key);
  TextureSource source;
  source.index = static_cast<int>(number_in(info, "index", -1));
  source.uv_set = static_cast<int>(number_in(info, "texCoord", 0));
  source.scale = static_cast<float>(number_in(info, "scale", 1));
  if (!info.Has("extensions")) return source;
  const tinygltf::Value& extensions = info.Get("extensions");
  if (extensions.Has(transform_extension)) {
    read_transform(extensions.Get(transform_extension), source);
  }
  return source;
}

TextureUse TextureTable::use(const TextureSource& source, TextureKind kind,
                             const std::string& pointer) {
  if (source.index < 0) return {};
  const tinygltf::Texture& texture = model_.textures[static_cast<std::size_t>(source.index)];
  if (texture.source < 0) {
    context_.warn(pointer, "texture " + std::to_string(source.index) +
                               " has no PNG or JPEG image and is left out");
    return {};
  }
  const bool srgb = kind != TextureKind::data;
  const auto [entry, is_new] =
      textures_.try_emplace({source.index, srgb}, static_cast<int>(asset_.textures.size()));
  if (is_new) asset_.textures.push_back(make(texture, srgb));
  const int image = asset_.textures[static_cast<std::size_t>(entry->second)].image;
  used_images_[static_cast<std::size_t>(image)].is_seen |= kind == TextureKind::seen_color;
  return {entry->second, source.uv_set, source.transform};
}

int TextureTable::image_of(int source) {
  const auto [entry, is_new] = images_.try_emplace(source, static_cast<int>(used_images_.size()));
  if (is_new) used_images_.push_back({source, false});
  return entry->second;
}

Texture TextureTable::make(const tinygltf::Texture& source, bool srgb) {
  Texture texture;
  texture.image = image_of(source.source);
  texture.srgb = srgb;
  if (source.sampler < 0) return texture;
  const tinygltf::Sampler& sampler = model_.samplers[static_cast<std::size_t>(source.sampler)];
  texture.wrap_u = wrap_of(sampler.wrapS);
  texture.wrap_v = wrap_of(sampler.wrapT);
  if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) texture.filter = TextureFilter::nearest;
  set_shrunken_filter(sampler.minFilter, texture);
  return texture;
}

}  // namespace restframe
