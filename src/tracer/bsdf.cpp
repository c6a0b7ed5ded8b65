#include "tracer/bsdf.h"

#include <algorithm>
#include <cmath>

#include "tracer/bsdf_terms.h"

namespace restframe {
namespace {

// Columns: two tangents and the normal (Duff and others 2017: no branch near the poles).
glm::mat3 basis_around(const Vec3f& n) {
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1.0F / (sign + n.z);
  const float b = n.x * n.y * a;
  return {Vec3f(1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x),
          Vec3f(b, sign + n.y * n.y * a, -n.y), n};
}

Vec3f cosine_distributed(const Vec3f& normal, float u, float v) {
  const float radius = std::sqrt(u);
  const float phi = 2.0F * pi * v;
  const Vec3f local(radius * std::cos(phi), radius * std::sin(phi),
                    std::sqrt(std::max(0.0F, 1.0F - u)));
  return basis_around(normal) * local;
}

// Of the microfacets visible from `view`, the part that is also visible along `direction`
// (height-correlated Smith).
float shadowing(const Bsdf& b, const Vec3f& direction) {
  const float lambda_view = smith_lambda(std::max(1e-4F, glm::dot(b.normal, b.view)), b.alpha);
  const float lambda =
      smith_lambda(std::max(1e-4F, std::abs(glm::dot(b.normal, direction))), b.alpha);
  return (1.0F + lambda_view) / (1.0F + lambda_view + lambda);
}

// A microfacet's normal, distributed as those visible from `view` (Heitz 2018).
Vec3f visible_microfacet(const Bsdf& b, float u, float v) {
  if (b.alpha < smallest_alpha) return b.normal;
  const glm::mat3 basis = basis_around(b.normal);
  const Vec3f local = b.view * basis;
  const Vec3f stretched = glm::normalize(Vec3f(b.alpha * local.x, b.alpha * local.y, local.z));
  const float radius = std::sqrt(u);
  const float phi = 2.0F * pi * v;
  const float x = radius * std::cos(phi);
  const float half = 0.5F * (1.0F + stretched.z);
  // The disc's half beyond the horizon of `stretched` is squeezed to what is seen of it. Its second
  // axis must be the one that lies in the plane of view and normal.
  const Vec3f across = stretched.z < 0.9999F ? glm::normalize(glm::cross(Vec3f(0, 0, 1), stretched))
                                             : Vec3f(1, 0, 0);
  const Vec3f along = glm::cross(stretched, across);
  const float y = glm::mix(std::sqrt(std::max(0.0F, 1.0F - x * x)), radius * std::sin(phi), half);
  const float z = std::sqrt(std::max(0.0F, 1.0F - x * x - y * y));
  const Vec3f n = x * across + y * along + z * stretched;
  return basis * glm::normalize(Vec3f(b.alpha * n.x, b.alpha * n.y, std::max(1e-6F, n.z)));
}

std::optional<Scattered> reflect_off(const Bsdf& b, const Vec3f& microfacet,
                                     const Vec3f& reflectance) {
  const Vec3f direction = 2.0F * glm::dot(b.view, microfacet) * microfacet - b.view;
  if (glm::dot(direction, b.facet) <= 0.0F || glm::dot(direction, b.normal) <= 0.0F)
    return std::nullopt;
  const float visible = b.alpha < smallest_alpha ? 1.0F : shadowing(b, direction);
  return Scattered{direction, reflectance * visible, false};
}

std::optional<Scattered> transmit(const Bsdf& b, const Vec3f& microfacet, const Vec3f& fraction) {
  const auto direction = refracted(b.view, microfacet, b.eta);
  if (!direction || glm::dot(*direction, b.facet) >= 0.0F || glm::dot(*direction, b.normal) >= 0.0F)
    return std::nullopt;
  const float visible = b.alpha < smallest_alpha ? 1.0F : shadowing(b, *direction);
  return Scattered{*direction, fraction * visible, true};
}

// The fraction that a microfacet of a dielectric reflects.
float reflectance_at(const Bsdf& b, const Vec3f& microfacet) {
  return fresnel_dielectric(std::max(0.0F, glm::dot(b.view, microfacet)), b.eta);
}

// The surface's reflection, or what passes it. Each is chosen as often as it matters, so weights stay
// near the colour.
std::optional<Scattered> scatter_dielectric(const Bsdf& b, float lobe, float u, float v) {
  // Towards something thinner some microfacets reflect all and others hardly anything: there the one
  // that is met decides, or light would be made or lost. So it does in glass, where weights are then
  // never above the colour.
  const bool microfacet_decides = b.eta < 1.0F || b.transmission >= 1.0F;
  const Vec3f met = microfacet_decides ? visible_microfacet(b, u, v) : b.normal;
  const float reflectance = reflectance_at(b, met);
  // A reflection that hardly ever happens would weigh too much when it does.
  constexpr float least_reflectance = 1e-6F;
  if (reflectance > least_reflectance && lobe < reflectance) {
    const Vec3f microfacet = microfacet_decides ? met : visible_microfacet(b, u, v);
    return reflect_off(b, microfacet, Vec3f(reflectance_at(b, microfacet) / reflectance));
  }
  if ((lobe - reflectance) / (1.0F - reflectance) < b.transmission) {
    const Vec3f microfacet = microfacet_decides ? met : visible_microfacet(b, u, v);
    const float passing = 1.0F - reflectance_at(b, microfacet);
    return transmit(b, microfacet, b.base * (passing / (1.0F - reflectance)));
  }
  const Vec3f direction = cosine_distributed(b.normal, u, v);
  if (glm::dot(direction, b.facet) <= 0.0F) return std::nullopt;
  return Scattered{direction, b.base, false};
}

}  // namespace

std::optional<Vec3f> refracted(const Vec3f& view, const Vec3f& normal, float eta) {
  const float cos_theta = glm::dot(view, normal);
  const float sin2_beyond = (1.0F - squared(cos_theta)) / squared(eta);
  if (sin2_beyond >= 1.0F) return std::nullopt;
  return (cos_theta / eta - std::sqrt(1.0F - sin2_beyond)) * normal - view / eta;
}

std::optional<Scattered> scatter(const Bsdf& b, float lobe, float u, float v) {
  if (lobe < b.metallic) {
    const Vec3f microfacet = visible_microfacet(b, u, v);
    return reflect_off(b, microfacet, schlick(b.base, glm::dot(b.view, microfacet)));
  }
  return scatter_dielectric(b, (lobe - b.metallic) / (1.0F - b.metallic), u, v);
}

}  // namespace restframe
