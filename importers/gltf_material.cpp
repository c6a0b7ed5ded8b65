#include "importers/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace restframe {
namespace {

Wrap wrap_of(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored_repeat;
  return Wrap::repeat;
}

// Collects the textures that materials use: each once as colour and once as data, with its image.
class TextureTable {
 public:
  TextureTable(const GltfContext& context, const tinygltf::Model& model, Asset& asset,
               std::vector<UsedImage>& used_images)
      : context_(context), model_(model), asset_(asset), used_images_(used_images) {}

  TextureUse use(int index, int uv_set, bool srgb, const std::string& pointer) {
    if (index < 0) return {};
    const tinygltf::Texture& source = model_.textures[static_cast<std::size_t>(index)];
    if (source.source < 0) {
      context_.warn(pointer, "texture " + std::to_string(index) +
                                 " has no PNG or JPEG image and is left out");
      return {};
    }
    if (uv_set > 1) {
      context_.warn(pointer, "texCoord " + std::to_string(uv_set) + " is not read, 0 is used");
      uv_set = 0;
    }
    const auto [entry, is_new] =
        textures_.try_emplace({index, srgb}, static_cast<int>(asset_.textures.size()));
    if (is_new) asset_.textures.push_back(make(source, srgb));
    return {entry->second, uv_set};
  }

 private:
  Texture make(const tinygltf::Texture& source, bool srgb) {
    Texture texture;
    const auto [entry, is_new] =
        images_.try_emplace(source.source, static_cast<int>(used_images_.size()));
    if (is_new) used_images_.push_back({source.source, false});
    texture.image = entry->second;
    used_images_[static_cast<std::size_t>(texture.image)].is_seen |= srgb;
    texture.srgb = srgb;
    if (source.sampler < 0) return texture;
    const tinygltf::Sampler& sampler = model_.samplers[static_cast<std::size_t>(source.sampler)];
    texture.wrap_u = wrap_of(sampler.wrapS);
    texture.wrap_v = wrap_of(sampler.wrapT);
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
      texture.filter = TextureFilter::nearest;
    return texture;
  }

  const GltfContext& context_;
  const tinygltf::Model& model_;
  Asset& asset_;
  std::vector<UsedImage>& used_images_;
  std::map<std::pair<int, bool>, int> textures_;
  std::map<int, int> images_;
};

Vec3f color_of(const std::vector<double>& v) {
  return Vec3f(Vec3(v[0], v[1], v[2]));
}

AlphaMode alpha_mode_of(const std::string& name) {
  if (name == "MASK") return AlphaMode::mask;
  return name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

// The number under `key` of the extension `name`, if there is one.
std::optional<float> extension_number(const tinygltf::Material& source, const char* name,
                                      const std::string& key) {
  const auto extension = source.extensions.find(name);
  if (extension == source.extensions.end() || !extension->second.Has(key)) return std::nullopt;
  return static_cast<float>(extension->second.Get(key).GetNumberAsDouble());
}

void set(TemporalNumber& number, const std::optional<float>& given) {
  if (given) number.value = *given;
}

// How thick a body is, its mesh tells.
void read_volume(const tinygltf::Material& source, Material& material) {
  const auto volume = source.extensions.find("KHR_materials_volume");
  if (volume == source.extensions.end()) return;
  set(material.attenuation_distance,
      extension_number(source, "KHR_materials_volume", "attenuationDistance"));
  if (!volume->second.Has("attenuationColor")) return;
  const tinygltf::Value& color = volume->second.Get("attenuationColor");
  for (int i = 0; i < 3; ++i) {
    material.attenuation_color.value[i] = static_cast<float>(color.Get(i).GetNumberAsDouble());
  }
}

void read_extensions(const tinygltf::Material& source, const GltfContext& context,
                     const std::string& pointer, Material& material) {
  material.unlit = source.extensions.count("KHR_materials_unlit") > 0;
  set(material.emission_strength,
      extension_number(source, "KHR_materials_emissive_strength", "emissiveStrength"));
  set(material.transmission,
      extension_number(source, "KHR_materials_transmission", "transmissionFactor"));
  set(material.ior, extension_number(source, "KHR_materials_ior", "ior"));
  read_volume(source, material);
  if (material.ior.value >= 1) return;
  context.warn(pointer,
               fmt::format("ior is {}, must be at least 1; 1 is used", material.ior.value));
  material.ior.value = 1;
}

Material read_material(const tinygltf::Material& source, TextureTable& textures,
                       const GltfContext& context, const std::string& pointer) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  Material material;
  material.name = source.name;
  material.base_color.value = color_of(pbr.baseColorFactor);
  material.opacity.value = static_cast<float>(pbr.baseColorFactor[3]);
  material.metallic.value = static_cast<float>(pbr.metallicFactor);
  material.roughness.value = static_cast<float>(pbr.roughnessFactor);
  material.emission.value = color_of(source.emissiveFactor);
  const tinygltf::TextureInfo& color = pbr.baseColorTexture;
  const tinygltf::TextureInfo& metal = pbr.metallicRoughnessTexture;
  const tinygltf::TextureInfo& emission = source.emissiveTexture;
  material.base_color_texture = textures.use(color.index, color.texCoord, true, pointer);
  material.metallic_roughness_texture = textures.use(metal.index, metal.texCoord, false, pointer);
  material.emission_texture = textures.use(emission.index, emission.texCoord, true, pointer);
  material.alpha_mode = alpha_mode_of(source.alphaMode);
  material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  material.double_sided = source.doubleSided;
  read_extensions(source, context, pointer, material);
  return material;
}

}  // namespace

void read_materials(const GltfContext& context, const tinygltf::Model& model, Asset& asset,
                    std::vector<UsedImage>& used_images) {
  TextureTable textures(context, model, asset, used_images);
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    Material material =
        read_material(model.materials[i], textures, context, "/materials/" + std::to_string(i));
    if (material.name.empty()) material.name = "material_" + std::to_string(i);
    asset.materials.push_back(std::move(material));
  }
}

}  // namespace restframe
