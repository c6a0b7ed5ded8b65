#pragma once

// Fibres that stand on a surface: velvet (Estevez and Kulla 2017, "Charlie").

#include "tracer/bsdf_terms.h"

namespace restframe {

struct Fibres {
  Vec3f normal, view;
  float alpha = 1;  // sheen roughness squared; from smallest_fibre_alpha on
  float cos_view = 1;
};

// Below, they shine at nothing but the horizon.
inline constexpr float smallest_fibre_alpha = 1e-3F;

// The fraction of light from `direction`, above the surface, that white fibres send to the view, per
// steradian, times the light's cosine.
float fibre_fraction(const Fibres& fibres, const Vec3f& direction);

}  // namespace restframe
