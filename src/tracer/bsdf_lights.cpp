// What a surface scatters of light from a given direction: a sum over lobes.

#include "physics/clones.h"
#include "tracer/bsdf.h"
#include "tracer/bsdf_terms.h"

namespace restframe {
namespace {

constexpr float least_cosine = 1e-4F;

inline float reflected_fraction(float cos_theta, float eta) {
  const float sin2_beyond = (1.0F - squared(cos_theta)) / squared(eta);
  const float cos_beyond = std::sqrt(std::max(0.0F, 1.0F - sin2_beyond));
  const float across = (cos_theta - eta * cos_beyond) / (cos_theta + eta * cos_beyond);
  const float along = (eta * cos_theta - cos_beyond) / (eta * cos_theta + cos_beyond);
  const float partial = 0.5F * (squared(across) + squared(along));
  return sin2_beyond >= 1.0F ? 1.0F : partial;
}

inline ViewLobe view_lobe(const Bsdf& b) {
  const float cos_view = glm::dot(b.normal, b.view);
  const float below = (1.0F - b.metallic) * (1.0F - b.transmission) *
                      (1.0F - reflected_fraction(std::max(0.0F, cos_view), b.eta));
  return {b.base * (below / pi), cos_view, smith_lambda(std::max(least_cosine, cos_view), b.alpha)};
}

// The microfacets' reflection (GGX, height-correlated Smith), with the light's cosine.
inline Vec3f facet_reflection(const Bsdf& b, const ViewLobe& lobe, float cos_light,
                              const Vec3f& direction) {
  const Vec3f between = b.view + direction;
  const Vec3f microfacet = between / std::sqrt(glm::dot(between, between));
  const float cos_half = std::max(0.0F, glm::dot(b.view, microfacet));
  const float lambda = smith_lambda(std::max(least_cosine, cos_light), b.alpha);
  const float facets = ggx_density(glm::dot(b.normal, microfacet), b.alpha) /
                       ((1.0F + lobe.lambda_view + lambda) * 4.0F * lobe.cos_view);
  const Vec3f reflectance = b.metallic * schlick(b.base, cos_half) +
                            Vec3f((1.0F - b.metallic) * reflected_fraction(cos_half, b.eta));
  return reflectance * facets;
}

inline Vec3f fraction(const Bsdf& b, const ViewLobe& lobe, const Vec3f& direction) {
  const float cos_light = glm::dot(b.normal, direction);
  const Vec3f diffuse = lobe.diffuse * cos_light;
  const Vec3f facets = facet_reflection(b, lobe, cos_light, direction);
  const bool rough = b.alpha >= smallest_alpha;
  const float above_facet = glm::dot(b.facet, direction);
  const bool seen = (cos_light > 0.0F) & (lobe.cos_view > 0.0F) & (above_facet > 0.0F);
  return {seen ? diffuse.x + (rough ? facets.x : 0.0F) : 0.0F,
          seen ? diffuse.y + (rough ? facets.y : 0.0F) : 0.0F,
          seen ? diffuse.z + (rough ? facets.z : 0.0F) : 0.0F};
}

}  // namespace

float fresnel_dielectric(float cos_theta, float eta) {
  return reflected_fraction(cos_theta, eta);
}

Vec3f scattered_fraction(const Bsdf& bsdf, const Vec3f& direction) {
  return fraction(bsdf, view_lobe(bsdf), direction);
}

RESTFRAME_CLONES void view_lobes(const BsdfLanes& bsdf, ViewLobeLanes& lobes) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const ViewLobe lobe = view_lobe(bsdf.at(i));
    lobes.diffuse.set(i, lobe.diffuse);
    lobes.cos_view[i] = lobe.cos_view;
    lobes.lambda_view[i] = lobe.lambda_view;
  }
}

RESTFRAME_CLONES void scattered_fraction(const BsdfLanes& bsdf, const ViewLobeLanes& lobes,
                                         const Vec3fLanes& direction, Vec3fLanes& result) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    result.set(i, fraction(bsdf.at(i), lobes.at(i), direction.at(i)));
  }
}

}  // namespace restframe
