#pragma once

// A material's properties as a table, for all that treats them alike: reading, checking, listing.

#include <array>
#include <limits>

#include "scene/material.h"

namespace restframe {

// `name` is the scene file's key; every number, or component of a colour, is from low to high.
struct NumberProperty {
  const char* name;
  TemporalNumber Material::*member;
  float low = 0, high = std::numeric_limits<float>::max();
};
struct ColorProperty {
  const char* name;
  TemporalColor Material::*member;
  float high = std::numeric_limits<float>::max();
};

inline constexpr std::array number_properties = {
    NumberProperty{"metallic", &Material::metallic, 0, 1},
    NumberProperty{"roughness", &Material::roughness, 0, 1},
    NumberProperty{"normal_scale", &Material::normal_scale, -std::numeric_limits<float>::max()},
    NumberProperty{"emission_strength", &Material::emission_strength},
    NumberProperty{"opacity", &Material::opacity, 0, 1},
    NumberProperty{"ior", &Material::ior, 1},
    NumberProperty{"transmission", &Material::transmission, 0, 1},
    NumberProperty{"attenuation_distance", &Material::attenuation_distance},
    NumberProperty{"specular", &Material::specular, 0, 1},
    NumberProperty{"clearcoat", &Material::clearcoat, 0, 1},
    NumberProperty{"clearcoat_roughness", &Material::clearcoat_roughness, 0, 1},
    NumberProperty{"sheen_roughness", &Material::sheen_roughness, 0, 1},
};

inline constexpr std::array color_properties = {
    ColorProperty{"base_color", &Material::base_color, 1},
    ColorProperty{"emission", &Material::emission},
    ColorProperty{"attenuation_color", &Material::attenuation_color, 1},
    ColorProperty{"specular_color", &Material::specular_color},
    ColorProperty{"sheen_color", &Material::sheen_color, 1},
};

struct TextureProperty {
  const char* name;
  TextureUse Material::*member;
};

inline constexpr std::array texture_properties = {
    TextureProperty{"base_color_texture", &Material::base_color_texture},
    TextureProperty{"metallic_roughness_texture", &Material::metallic_roughness_texture},
    TextureProperty{"normal_texture", &Material::normal_texture},
    TextureProperty{"emission_texture", &Material::emission_texture},
    TextureProperty{"transmission_texture", &Material::transmission_texture},
    TextureProperty{"specular_texture", &Material::specular_texture},
    TextureProperty{"specular_color_texture", &Material::specular_color_texture},
    TextureProperty{"clearcoat_texture", &Material::clearcoat_texture},
    TextureProperty{"clearcoat_roughness_texture", &Material::clearcoat_roughness_texture},
    TextureProperty{"clearcoat_normal_texture", &Material::clearcoat_normal_texture},
    TextureProperty{"sheen_color_texture", &Material::sheen_color_texture},
    TextureProperty{"sheen_roughness_texture", &Material::sheen_roughness_texture},
};

}  // namespace restframe
