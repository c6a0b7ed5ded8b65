#pragma once

// How a surface scatters light in its own rest frame: glTF's metallic-roughness model (its
// specification's appendix B) with transmission, specular, clearcoat and sheen. Directions are unit
// vectors that point away from the surface. Densities are per steradian.

#include <optional>

#include "frames/packet.h"
#include "physics/vectors.h"

namespace restframe {

// What lies above the surface, and how it is let through: most surfaces have none of this.
struct BsdfLayers {
  float transmission = 0;      // of what is not reflected by a dielectric, the fraction let through
  bool thin = false;           // a sheet: what is let through is not refracted
  float coat = 0;              // how much of the surface has a clear coat
  float coat_alpha = 0;        // the coat's microfacets
  Vec3f coat_normal{0, 0, 1};  // on the side of `view`
  Vec3f sheen{0};              // colour of fibres that stand on the surface
  float sheen_alpha = 1;       // how much they diverge: sheen roughness squared
};

// A surface at one event. Normals are on the side of `view`.
struct Bsdf {
  Vec3f view{0, 0, 1};    // towards where the ray came from
  Vec3f normal{0, 0, 1};  // shading normal
  Vec3f facet{0, 0, 1};   // the triangle's own
  Vec3f base{1};
  Vec3f specular_color{1};  // factor on a dielectric's reflection, seen straight on
  float specular = 1;       // likewise, at any angle
  float metallic = 0;
  float alpha = 1;  // of the microfacets' distribution (GGX): roughness squared
  float eta = 1.5;  // index of refraction beyond the surface over that on the side of `view`
  BsdfLayers layers{};
};

struct BsdfLayersLanes {
  Lanes<float> transmission;
  Lanes<std::int32_t> thin;
  Lanes<float> coat, coat_alpha;
  Vec3fLanes coat_normal, sheen;
  Lanes<float> sheen_alpha;

  BsdfLayers at(int i) const {
    return {transmission[i],   thin[i] != 0, coat[i],       coat_alpha[i],
            coat_normal.at(i), sheen.at(i),  sheen_alpha[i]};
  }
  void set(int i, const BsdfLayers& of_lane);
  bool any(int i) const {
    return transmission[i] > 0.0F || coat[i] > 0.0F || sheen.at(i) != Vec3f(0);
  }
};

// 16 surfaces.
struct BsdfLanes {
  Vec3fLanes view, normal, facet, base, specular_color;
  Lanes<float> specular, metallic, alpha, eta;
  bool matte = false;      // none is metallic, specular or layered: all is diffuse
  bool layered = false;    // else `layers` mean nothing
  BsdfLayersLanes layers;  // of all lanes if of any

  void set_layers(int lane, const BsdfLayers& of_lane);
  Bsdf plain_at(int i) const {
    return {view.at(i),  normal.at(i), facet.at(i), base.at(i), specular_color.at(i),
            specular[i], metallic[i],  alpha[i],    eta[i],     {}};
  }
  Bsdf at(int i) const {
    Bsdf bsdf = plain_at(i);
    if (layered) bsdf.layers = layers.at(i);
    return bsdf;
  }
};

// What layers need of the view.
struct ViewLayers {
  float below = 1, below_coat = 1;  // the light that fibres and coat leave to what is under them
  float reaches = 0;                // chance to come to a surface that lets light through, ...
  float glass = 0;                  // ... and what is scattered there
  float coat = 0, fibres = 0;       // chances to follow these lobes
  float coat_gain = 0;              // what a coat of perfect mirrors would reflect
  float fibre_gain = 0;             // factor on what white fibres scatter
  float cos_coat = 1, lambda_coat = 0;
};

// What each lobe needs of the view, whatever the light's direction. The chances of all lobes sum to 1,
// or are 0 where all light is absorbed.
struct ViewLobe {
  Vec3f diffuse{0};  // scattered below the surface, per steradian, but for the light's cosine
  // Reflected by microfacets that are met straight on, and how much more of it at grazing angles, both
  // with what is scattered several times between them.
  Vec3f straight{0}, grazing{0};
  float cos_view = 1, lambda_view = 0;
  float diffuses = 0, reflects = 0;  // chances to follow these lobes
};
struct ViewLobeLanes {
  Vec3fLanes diffuse, straight, grazing;
  Lanes<float> cos_view, lambda_view, diffuses, reflects;
  ViewLayers layers[packet_size];  // only of those surfaces that have any

  ViewLobe at(int i) const {
    return {diffuse.at(i),  straight.at(i), grazing.at(i), cos_view[i],
            lambda_view[i], diffuses[i],    reflects[i]};
  }
};
void view_lobes(const BsdfLanes& bsdf, ViewLobeLanes& lobes);

// A way on for a ray, chosen at random.
struct Scattered {
  Vec3f direction{0};
  Vec3f weight{0};       // scattered over density: what the path's throughput is multiplied by
  float density = 0;     // of the direction, by whatever lobe; 0: there is no other to choose
  bool through = false;  // into a body, or out of it; a thin sheet has no inside
};

// Three numbers in [0, 1) choose: nothing where light is absorbed.
std::optional<Scattered> scatter(const Bsdf& bsdf, float lobe, float u, float v);

// 16 of them; lanes that are not active, or whose light is absorbed, get active 0.
struct ScatteredLanes {
  Lanes<std::int32_t> active;
  Vec3fLanes direction, weight;
  Lanes<float> density;
  Lanes<std::int32_t> through;
};
void scatter(const BsdfLanes& bsdf, const ViewLobeLanes& lobes, const Lanes<std::int32_t>& active,
             const Vec3fLanes& numbers, ScatteredLanes& scattered);

// The fraction of light from `direction` that goes to `view`, per steradian, times the cosine at the
// surface. Without mirrors and clear glass (alpha below smallest_alpha): no light is met exactly.
// From below the facet comes what is let through: light inside a body, unless the surface is thin.
Vec3f scattered_fraction(const Bsdf& bsdf, const Vec3f& direction);

// The density with which scatter() chooses a direction, but for such mirrors and glass.
float scattering_density(const Bsdf& bsdf, const Vec3f& direction);

// Both, of 16 surfaces.
void scattered_fraction(const BsdfLanes& bsdf, const ViewLobeLanes& lobes,
                        const Vec3fLanes& direction, Vec3fLanes& fraction, Lanes<float>& density);

// Of one surface, the part of it that the diffuse lobe and fibres scatter.
Vec3f matte_fraction(const BsdfLanes& bsdf, const ViewLobeLanes& lobes, int lane,
                     const Vec3f& direction);

// The fraction that a clear coat of this strength reflects in all, away from what is below it.
float coat_reflection(float coat, float coat_alpha, float cos_view);

// Below, a surface is taken for perfectly smooth.
inline constexpr float smallest_alpha = 1e-3F;

// The reflected fraction of unpolarised light (Fresnel's equations); 1 where reflection is total.
// cos_theta: >= 0, on the side that the light comes from; eta: index beyond over index before.
float fresnel_dielectric(float cos_theta, float eta);

// The direction in which light from `view` goes on beyond `normal` (Snell's law), or nothing where
// reflection is total.
std::optional<Vec3f> refracted(const Vec3f& view, const Vec3f& normal, float eta);

}  // namespace restframe
