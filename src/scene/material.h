#pragma once

#include <cstdint>
#include <string>

#include "scene/temporal_function.h"

namespace restframe {

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

// Which texture a property multiplies with, and which of the mesh's UV sets (0 or 1) places it.
struct TextureUse {
  int texture = -1;  // index into the textures of the same asset or scene; -1: none
  int uv_set = 0;
};

// glTF's material, its meaning and defaults. Any number or colour may be a temporal function.
struct Material {
  std::string name;
  TemporalColor base_color{Vec3f(1)};
  TemporalNumber opacity{1.0F};  // glTF's base colour alpha
  TextureUse base_color_texture;
  TemporalNumber metallic{1.0F}, roughness{1.0F};
  TextureUse metallic_roughness_texture;
  TemporalColor emission{Vec3f(0)};
  TemporalNumber emission_strength{1.0F};
  TextureUse emission_texture;
  TemporalNumber ior{1.5F};
  TemporalNumber transmission{0.0F};  // fraction of the light below the surface that goes through
  // What is left of white light, inside, after this distance (scene lengths, rest frame); 0: nothing
  // is lost, however far.
  TemporalColor attenuation_color{Vec3f(1)};
  TemporalNumber attenuation_distance{0.0F};
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5F;
  bool double_sided = false;  // else its back faces are not seen
  bool unlit = false;
};

// Light can be inside of what is made of it.
inline bool can_transmit(const Material& material) {
  return material.transmission.value > 0.0F || material.transmission.function != no_function;
}

}  // namespace restframe
