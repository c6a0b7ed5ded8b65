#pragma once

// How a surface scatters light in its own rest frame: glTF's metallic-roughness model with
// transmission. Directions are unit vectors that point away from the surface.

#include <optional>

#include "physics/vectors.h"

namespace restframe {

// A surface at one event. Normals are on the side of `view`.
struct Bsdf {
  Vec3f view{0, 0, 1};    // towards where the ray came from
  Vec3f normal{0, 0, 1};  // shading normal
  Vec3f facet{0, 0, 1};   // the triangle's own
  Vec3f base{1};
  float metallic = 0, transmission = 0;
  float alpha = 1;  // of the microfacets' distribution (GGX): roughness squared
  float eta = 1.5;  // index of refraction beyond the surface over that on the side of `view`
};

// A way on for a ray, chosen at random.
struct Scattered {
  Vec3f direction{0};
  Vec3f weight{0};       // scattered over chosen: what the path's throughput is multiplied by
  bool through = false;  // to the other side
};

// Three numbers in [0, 1) choose: nothing where light is absorbed.
std::optional<Scattered> scatter(const Bsdf& bsdf, float lobe, float u, float v);

// The fraction of light from `direction` that goes to `view`, per steradian, times the cosine at the
// surface. Without mirrors and clear glass (alpha below smallest_alpha): no light is met exactly.
Vec3f scattered_fraction(const Bsdf& bsdf, const Vec3f& direction);

// Below, a surface is taken for perfectly smooth.
inline constexpr float smallest_alpha = 1e-3F;

// The reflected fraction of unpolarised light (Fresnel's equations); 1 where reflection is total.
// cos_theta: >= 0, on the side that the light comes from; eta: index beyond over index before.
float fresnel_dielectric(float cos_theta, float eta);

// The direction in which light from `view` goes on beyond `normal` (Snell's law), or nothing where
// reflection is total.
std::optional<Vec3f> refracted(const Vec3f& view, const Vec3f& normal, float eta);

}  // namespace restframe
