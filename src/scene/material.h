#pragma once

#include <cstdint>
#include <string>

#include "scene/emission_spectrum.h"
#include "scene/temporal_function.h"

namespace restframe {

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

// Texture coordinates as an image is to be read at, of the mesh's own (KHR_texture_transform).
struct UvTransform {
  Vec2f along_u{1, 0}, along_v{0, 1}, offset{0, 0};

  Vec2f operator()(const Vec2f& uv) const { return uv.x * along_u + uv.y * along_v + offset; }
};

// Which texture a property multiplies with, which of the mesh's UV sets places it, and how.
struct TextureUse {
  int texture = -1;  // index into the textures of the same asset or scene; -1: none
  int uv_set = 0;    // 0 or more; where the mesh lacks that set, its coordinates are 0
  UvTransform transform{};
};

// glTF's material with its extensions, their meaning and defaults. Any number or colour may be a
// temporal function. What multiplies with which texture, and which of its channels, glTF says.
struct Material {
  std::string name;
  TemporalColor base_color{Vec3f(1)};
  TemporalNumber opacity{1.0F};  // glTF's base colour alpha
  TextureUse base_color_texture;
  TemporalNumber metallic{1.0F}, roughness{1.0F};
  TextureUse metallic_roughness_texture;
  TemporalNumber normal_scale{1.0F};  // of the normal texture's x and y
  TextureUse normal_texture;
  TemporalColor emission{Vec3f(0)};
  TemporalNumber emission_strength{1.0F};
  // What glows with a spectrum of its own; `emission` is a filter before it then.
  TemporalNumber emission_temperature{0.0F};  // of a blackbody, K; 0: it is none
  EmissionSpectrum emission_spectrum;
  TextureUse emission_texture;
  TemporalNumber ior{1.5F};
  TemporalNumber transmission{0.0F};  // fraction of the light below the surface that goes through
  TextureUse transmission_texture;
  // A sheet that light goes through straight on, but for roughness; else its mesh bounds a body, which
  // refracts.
  bool thin_walled = false;
  // What is left of white light, inside, after this distance (scene lengths, rest frame); 0: nothing
  // is lost, however far.
  TemporalColor attenuation_color{Vec3f(1)};
  TemporalNumber attenuation_distance{0.0F};
  TemporalNumber specular{1.0F};           // factor on the reflection of what is no metal
  TemporalColor specular_color{Vec3f(1)};  // likewise, seen straight on; may be above 1
  TextureUse specular_texture, specular_color_texture;
  TemporalNumber clearcoat{0.0F}, clearcoat_roughness{0.0F};
  float clearcoat_normal_scale = 1;
  TextureUse clearcoat_texture, clearcoat_roughness_texture, clearcoat_normal_texture;
  TemporalColor sheen_color{Vec3f(0)};
  TemporalNumber sheen_roughness{0.0F};
  TextureUse sheen_color_texture, sheen_roughness_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5F;
  bool double_sided = false;  // else its back faces are not seen
  bool unlit = false;
  std::string group;  // of lights, if it shines: names a layer
};

// The index of refraction that stands for glTF's 0: the dielectric reflects all that it meets, but
// for 4e-6 of it.
inline constexpr float reflecting_ior = 1e6F;

// Light goes through it.
inline bool can_transmit(const Material& material) {
  return material.transmission.value > 0.0F || material.transmission.function != no_function;
}

// Light can be inside of what is made of it.
inline bool refracts(const Material& material) {
  return can_transmit(material) && !material.thin_walled;
}

}  // namespace restframe
