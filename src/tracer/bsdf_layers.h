#pragma once

// The terms of rarely used lobes: bodies and sheets that let light through, clear coats, fibres.

#include "tracer/bsdf.h"
#include "tracer/bsdf_terms.h"

namespace restframe {

inline constexpr float coat_straight = 0.04F;  // its reflectance, seen straight on

// Refraction by less than this is none, however rough the surface.
inline constexpr float least_bending = 1e-3F;

inline bool passes_exactly(const Bsdf& b) {
  return b.alpha < smallest_alpha || (!b.layers.thin && std::abs(b.eta - 1.0F) < least_bending);
}

inline Vec3f mirrored(const Vec3f& direction, const Vec3f& normal) {
  return direction - 2.0F * glm::dot(direction, normal) * normal;
}

// A dielectric's reflectance straight on.
inline Vec3f straight_reflectance(const Bsdf& b) {
  return glm::min(straight_reflectance(b.eta) * b.specular_color, Vec3f(1)) * b.specular;
}

inline float coat_reflectance(float cos_half) {
  return coat_straight + (1.0F - coat_straight) * schlick(cos_half);
}

// And at grazing angles: all, but for what is hardly denser than its surroundings, where Schlick's
// formula alone would see a mirror in nothing. It holds from water's index on.
inline float grazing_reflectance(const Bsdf& b) {
  return std::min(1.0F, 50.0F * straight_reflectance(b.eta)) * b.specular;
}

// What a microfacet of a surface that lets light through reflects: Fresnel's equations, since
// reflection can be total there, changed as much as the surface's own value straight on is.
Vec3f glass_reflectance(const Bsdf& b, float cos_half);

// Divides the light between the surface, what it lets through, its coat and its fibres. `lobe` is the
// surface's own without them, its chances mere weights; with them afterwards, its chances as well.
ViewLayers view_layers(const Bsdf& bsdf, ViewLobe& lobe);

// What goes one way.
struct Fraction {
  Vec3f fraction{0};
  float density = 0;
};

struct Way;
Way layered_way(const Bsdf& bsdf, const ViewLobe& lobe, const ViewLayers& layers,
                const Vec3f& numbers);

// Of what they add, what fibres scatter of light from above.
Fraction off_fibres(const Bsdf& bsdf, const ViewLobe& lobe, const ViewLayers& layers,
                    const Vec3f& direction);

// All that layered surfaces add to the plain one's.
Fraction layers_fraction(const Bsdf& bsdf, const ViewLobe& lobe, const ViewLayers& layers,
                         const Vec3f& direction);

}  // namespace restframe
