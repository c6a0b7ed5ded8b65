#include "importers/gltf_material.h"

namespace restframe {
namespace {

// One extension of a material, if the material has it: each member replaces what is there.
class Extension {
 public:
  Extension(const tinygltf::Material& source, const std::string& name, TextureTable& textures,
            const std::string& pointer)
      : textures_(textures), pointer_(pointer) {
    const auto found = source.extensions.find(name);
    if (found != source.extensions.end()) value_ = &found->second;
  }

  bool is_there() const { return value_ != nullptr; }

  void number(const std::string& key, TemporalNumber& number) const {
    if (has(key)) number.value = static_cast<float>(value_->Get(key).GetNumberAsDouble());
  }

  void color(const std::string& key, TemporalColor& color) const {
    if (!has(key)) return;
    for (int i = 0; i < 3; ++i) {
      color.value[i] = static_cast<float>(value_->Get(key).Get(i).GetNumberAsDouble());
    }
  }

  void texture(const std::string& key, TextureKind kind, TextureUse& use) const {
    if (has(key)) use = textures_.use(texture_source(*value_, key), kind, pointer_);
  }

  void normal_scale(const std::string& key, float& scale) const {
    if (has(key)) scale = texture_source(*value_, key).scale;
  }

 private:
  bool has(const std::string& key) const { return value_ != nullptr && value_->Has(key); }

  const tinygltf::Value* value_ = nullptr;
  TextureTable& textures_;
  const std::string& pointer_;
};

// Without a volume that has a thickness, what lets light through is a sheet; how thick a body is
// otherwise, its mesh tells.
void read_glass(const Extension& transmission, const Extension& ior, const Extension& volume,
                Material& material) {
  transmission.number("transmissionFactor", material.transmission);
  transmission.texture("transmissionTexture", TextureKind::data, material.transmission_texture);
  ior.number("ior", material.ior);
  if (material.ior.value == 0) material.ior.value = reflecting_ior;
  TemporalNumber thickness{0.0F};
  volume.number("thicknessFactor", thickness);
  material.thin_walled = transmission.is_there() && thickness.value == 0.0F;
  volume.number("attenuationDistance", material.attenuation_distance);
  volume.color("attenuationColor", material.attenuation_color);
}

void read_specular(const Extension& specular, Material& material) {
  specular.number("specularFactor", material.specular);
  specular.color("specularColorFactor", material.specular_color);
  specular.texture("specularTexture", TextureKind::data, material.specular_texture);
  specular.texture("specularColorTexture", TextureKind::color, material.specular_color_texture);
}

void read_clearcoat(const Extension& coat, Material& material) {
  coat.number("clearcoatFactor", material.clearcoat);
  coat.number("clearcoatRoughnessFactor", material.clearcoat_roughness);
  coat.texture("clearcoatTexture", TextureKind::data, material.clearcoat_texture);
  coat.texture("clearcoatRoughnessTexture", TextureKind::data,
               material.clearcoat_roughness_texture);
  coat.texture("clearcoatNormalTexture", TextureKind::data, material.clearcoat_normal_texture);
  coat.normal_scale("clearcoatNormalTexture", material.clearcoat_normal_scale);
}

void read_sheen(const Extension& sheen, Material& material) {
  sheen.color("sheenColorFactor", material.sheen_color);
  sheen.number("sheenRoughnessFactor", material.sheen_roughness);
  sheen.texture("sheenColorTexture", TextureKind::color, material.sheen_color_texture);
  sheen.texture("sheenRoughnessTexture", TextureKind::data, material.sheen_roughness_texture);
}

}  // namespace

void read_material_extensions(const tinygltf::Material& source, TextureTable& textures,
                              const std::string& pointer, Material& material) {
  const auto extension = [&](const char* name) {
    return Extension(source, std::string("KHR_materials_") + name, textures, pointer);
  };
  material.unlit = extension("unlit").is_there();
  extension("emissive_strength").number("emissiveStrength", material.emission_strength);
  read_glass(extension("transmission"), extension("ior"), extension("volume"), material);
  read_specular(extension("specular"), material);
  read_clearcoat(extension("clearcoat"), material);
  read_sheen(extension("sheen"), material);
}

}  // namespace restframe
