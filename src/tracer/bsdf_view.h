#pragma once

// Lobes as the view has them: the plain surface's without branches, for loops over lanes.

#include "tracer/bsdf_albedo.h"
#include "tracer/bsdf_layers.h"

namespace restframe {

// Chances are mere weights, as yet. `opaque`: of what a dielectric does not reflect, the fraction that
// is not let through.
inline ViewLobe view_weights(const Bsdf& b, float opaque, const FacetAlbedo& albedo) {
  const float cos_view = std::max(least_cosine, glm::dot(b.normal, b.view));
  // What microfacets scatter more than once, by the albedo that the single scattering lacks (Turquin
  // 2019): white ones lose nothing.
  const float again = (1.0F - albedo.all) / albedo.all;
  const Vec3f straight = straight_reflectance(b);
  const Vec3f grazing = glm::max(Vec3f(grazing_reflectance(b)) - straight, Vec3f(0));
  const float of_dielectric = (1.0F - b.metallic) * opaque;
  const Vec3f metal = b.metallic * (Vec3f(1) + again * b.base);
  const Vec3f gloss = Vec3f(1) + again * straight;
  const Vec3f reflected = gloss * (albedo.all * straight + albedo.grazing * grazing);
  const float below = of_dielectric * (1.0F - std::min(1.0F, largest(reflected)));
  ViewLobe lobe;
  lobe.diffuse = b.base * (below / pi);
  lobe.straight = metal * b.base + of_dielectric * gloss * straight;
  lobe.grazing = metal * (Vec3f(1) - b.base) + of_dielectric * gloss * grazing;
  lobe.cos_view = cos_view;
  lobe.lambda_view = smith_lambda(cos_view, b.alpha);
  lobe.diffuses = average(b.base) * below;
  lobe.reflects = average(albedo.all * lobe.straight + albedo.grazing * lobe.grazing);
  return lobe;
}

inline void share_chances(ViewLobe& lobe) {
  const float sum = lobe.diffuses + lobe.reflects;
  const float share = sum > 0.0F ? 1.0F / sum : 0.0F;
  lobe.diffuses *= share;
  lobe.reflects *= share;
}

// Diffuse and mirrored light; without mirrors that are perfectly smooth.
inline Fraction plain_fraction(const Bsdf& b, const ViewLobe& lobe, const Vec3f& direction) {
  const float cos_light = glm::dot(b.normal, direction);
  const Mirroring facets =
      mirroring(b.view, b.normal, b.alpha, lobe.cos_view, lobe.lambda_view, cos_light, direction);
  const bool rough = b.alpha >= smallest_alpha;
  const float to_facet = glm::dot(b.facet, direction);
  const bool seen = (cos_light > 0.0F) & (to_facet > 0.0F);
  const float facets_there = rough ? facets.fraction : 0.0F;
  const float facets_density = rough ? facets.density : 0.0F;
  const Vec3f sum = lobe.diffuse * cos_light +
                    (lobe.straight + lobe.grazing * schlick(facets.cos_half)) * facets_there;
  const float density = lobe.diffuses * (cos_light / pi) + lobe.reflects * facets_density;
  return {Vec3f(seen ? sum.x : 0.0F, seen ? sum.y : 0.0F, seen ? sum.z : 0.0F),
          seen ? density : 0.0F};
}

// What is left of both where nothing is metallic, specular or layered.
inline ViewLobe matte_view_lobe(const Vec3f& base) {
  ViewLobe lobe;
  lobe.diffuse = base * (1.0F / pi);
  lobe.diffuses = average(base);
  share_chances(lobe);
  return lobe;
}

inline Fraction matte_fraction(const Vec3f& normal, const Vec3f& facet, const Vec3f& diffuse,
                               float diffuses, const Vec3f& direction) {
  const float cos_light = glm::dot(normal, direction);
  const bool seen = (cos_light > 0.0F) & (glm::dot(facet, direction) > 0.0F);
  const float cosine = seen ? cos_light : 0.0F;
  return {diffuse * cosine, diffuses * (cosine / pi)};
}

inline ViewLobe plain_view_lobe(const Bsdf& b, const FacetAlbedoTable& table) {
  const float cos_view = std::max(least_cosine, glm::dot(b.normal, b.view));
  return view_weights(b, 1.0F - b.layers.transmission, facet_albedo(table, cos_view, b.alpha));
}

inline ViewLobe view_lobe(const Bsdf& b, const FacetAlbedoTable& table, ViewLayers& layers) {
  ViewLobe lobe = plain_view_lobe(b, table);
  layers = view_layers(b, lobe);
  return lobe;
}

inline Fraction whole_fraction(const Bsdf& b, const ViewLobe& lobe, const ViewLayers& layers,
                               const Vec3f& direction) {
  const Fraction plain = plain_fraction(b, lobe, direction);
  const Fraction more = layers_fraction(b, lobe, layers, direction);
  return {plain.fraction + more.fraction, plain.density + more.density};
}

}  // namespace restframe
