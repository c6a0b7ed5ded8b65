#include "importers/gltf_material.h"

namespace restframe {
namespace {

Vec3f color_of(const std::vector<double>& v) {
  return Vec3f(Vec3(v[0], v[1], v[2]));
}

AlphaMode alpha_mode_of(const std::string& name) {
  if (name == "MASK") return AlphaMode::mask;
  return name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

void read_textures(const tinygltf::Material& source, TextureTable& textures,
                   const std::string& pointer, Material& material) {
  const auto use = [&](const auto& info, TextureKind kind) {
    return textures.use(texture_source(info), kind, pointer);
  };
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  material.base_color_texture = use(pbr.baseColorTexture, TextureKind::seen_color);
  material.metallic_roughness_texture = use(pbr.metallicRoughnessTexture, TextureKind::data);
  material.emission_texture = use(source.emissiveTexture, TextureKind::seen_color);
  material.normal_texture = use(source.normalTexture, TextureKind::data);
  material.normal_scale.value = texture_source(source.normalTexture).scale;
}

Material read_material(const tinygltf::Material& source, TextureTable& textures,
                       const std::string& pointer) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  Material material;
  material.name = source.name;
  material.base_color.value = color_of(pbr.baseColorFactor);
  material.opacity.value = static_cast<float>(pbr.baseColorFactor[3]);
  material.metallic.value = static_cast<float>(pbr.metallicFactor);
  material.roughness.value = static_cast<float>(pbr.roughnessFactor);
  material.emission.value = color_of(source.emissiveFactor);
  material.alpha_mode = alpha_mode_of(source.alphaMode);
  material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  material.double_sided = source.doubleSided;
  read_textures(source, textures, pointer, material);
  read_material_extensions(source, textures, pointer, material);
  return material;
}

}  // namespace

void read_materials(const GltfContext& context, const tinygltf::Model& model, Asset& asset,
                    std::vector<UsedImage>& used_images) {
  TextureTable textures(context, model, asset, used_images);
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    Material material =
        read_material(model.materials[i], textures, "/materials/" + std::to_string(i));
    if (material.name.empty()) material.name = "material_" + std::to_string(i);
    asset.materials.push_back(std::move(material));
  }
}

}  // namespace restframe
