#pragma once

#include "scene/material.h"

namespace restframe {

// What a material is in the path integrator where that never changes. Most materials are so, and
// need neither a clock nor a place on the surface.
struct PlainMaterial {
  // The numbers below are all there is: no texture, no temporal function, no transparency of any
  // kind, and lights matter.
  bool always = false;
  bool double_sided = false;
  bool layered = false;                      // may have what Bsdf::layers are for
  bool tilted = false, tilted_coat = false;  // by normal maps
  Vec3f base{1}, emission{0};
  float metallic = 0;
  float alpha = 1;  // roughness squared
  float ior = 1.5F;
  float specular = 1;
  Vec3f specular_color{1};
};

PlainMaterial plain_material(const Material& material);

}  // namespace restframe
