#pragma once

// How a surface scatters light in its own rest frame: glTF's metallic-roughness model with
// transmission. Directions are unit vectors that point away from the surface.

#include <optional>

#include "frames/packet.h"
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

// 16 surfaces.
struct BsdfLanes {
  Vec3fLanes view, normal, facet, base;
  Lanes<float> metallic, transmission, alpha, eta;

  Bsdf at(int i) const {
    return {view.at(i),  normal.at(i),    facet.at(i), base.at(i),
            metallic[i], transmission[i], alpha[i],    eta[i]};
  }
};

// What each lobe that lights are seen by needs of the view, whatever the light's direction.
struct ViewLobe {
  Vec3f diffuse{0};  // scattered below the surface, per steradian, but for the light's cosine
  float cos_view = 1, lambda_view = 0;  // of the microfacets
};
struct ViewLobeLanes {
  Vec3fLanes diffuse;
  Lanes<float> cos_view, lambda_view;

  ViewLobe at(int i) const { return {diffuse.at(i), cos_view[i], lambda_view[i]}; }
};
void view_lobes(const BsdfLanes& bsdf, ViewLobeLanes& lobes);

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
void scattered_fraction(const BsdfLanes& bsdf, const ViewLobeLanes& lobes,
                        const Vec3fLanes& direction, Vec3fLanes& fraction);

// Below, a surface is taken for perfectly smooth.
inline constexpr float smallest_alpha = 1e-3F;

// The reflected fraction of unpolarised light (Fresnel's equations); 1 where reflection is total.
// cos_theta: >= 0, on the side that the light comes from; eta: index beyond over index before.
float fresnel_dielectric(float cos_theta, float eta);

// The direction in which light from `view` goes on beyond `normal` (Snell's law), or nothing where
// reflection is total.
std::optional<Vec3f> refracted(const Vec3f& view, const Vec3f& normal, float eta);

}  // namespace restframe
