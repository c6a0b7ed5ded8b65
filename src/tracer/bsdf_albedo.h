#pragma once

// How much of the light a rough surface scatters in all, for a given view: tables of integrals that
// have no closed form, made when they are first used.

#include "tracer/bsdf_terms.h"

namespace restframe {

// Of microfacets (GGX) that scatter light once.
struct FacetAlbedo {
  float all = 1;      // if each reflected all
  float grazing = 0;  // if each reflected as much as schlick() says
};

inline constexpr int albedo_cosines = 32, albedo_roughnesses = 16;

struct FacetAlbedoTable {
  float all[albedo_roughnesses + 1][albedo_cosines + 1];
  float grazing[albedo_roughnesses + 1][albedo_cosines + 1];
};
const FacetAlbedoTable& facet_albedo_table();

inline FacetAlbedo facet_albedo(const FacetAlbedoTable&, float cos_view, float) {
  return {1.0F, schlick(cos_view)};
}

// Of surfaces that reflect some light by Fresnel's equations, and let the rest through, to anything of
// that index of refraction.
inline float glass_albedo(float, float, float) {
  return 1.0F;
}

// Of fibres (`alpha`: sheen roughness squared).
inline float fibre_albedo(float, float) {
  return 0.0F;
}

}  // namespace restframe
