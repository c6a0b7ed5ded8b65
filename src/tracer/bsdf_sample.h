#pragma once

// Directions chosen at random.

#include "tracer/bsdf.h"
#include "tracer/bsdf_terms.h"

namespace restframe {

// Columns: two tangents and the normal (Duff and others 2017: no branch near the poles).
inline glm::mat3 basis_around(const Vec3f& n) {
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1.0F / (sign + n.z);
  const float b = n.x * n.y * a;
  return {Vec3f(1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x),
          Vec3f(b, sign + n.y * n.y * a, -n.y), n};
}

inline Vec3f cosine_distributed(const Vec3f& normal, float u, float v) {
  const float radius = std::sqrt(u);
  const float phi = 2.0F * pi * v;
  const Vec3f local(radius * std::cos(phi), radius * std::sin(phi),
                    std::sqrt(std::max(0.0F, 1.0F - u)));
  return basis_around(normal) * local;
}

// Evenly over the hemisphere.
inline Vec3f evenly_distributed(const Vec3f& normal, float u, float v) {
  const float radius = std::sqrt(std::max(0.0F, 1.0F - u * u));
  const float phi = 2.0F * pi * v;
  return basis_around(normal) * Vec3f(radius * std::cos(phi), radius * std::sin(phi), u);
}

inline Vec2f disc_distributed(float u, float v) {
  const float radius = std::sqrt(u);
  const float phi = 2.0F * pi * v;
  return {radius * std::cos(phi), radius * std::sin(phi)};
}

// A microfacet's normal, distributed as those visible from `view` (Heitz 2018), around z, for a point
// that is distributed evenly over the unit disc.
inline Vec3f visible_microfacet(const Vec3f& view, float alpha, const Vec2f& point) {
  const Vec3f stretched = glm::normalize(Vec3f(alpha * view.x, alpha * view.y, view.z));
  const float half = 0.5F * (1.0F + stretched.z);
  // The disc's half beyond the horizon of `stretched` is squeezed to what is seen of it. Its second
  // axis must be the one that lies in the plane of view and normal.
  const Vec3f across = stretched.z < 0.9999F ? glm::normalize(glm::cross(Vec3f(0, 0, 1), stretched))
                                             : Vec3f(1, 0, 0);
  const Vec3f along = glm::cross(stretched, across);
  const float x = point.x;
  const float y = glm::mix(std::sqrt(std::max(0.0F, 1.0F - x * x)), point.y, half);
  const float z = std::sqrt(std::max(0.0F, 1.0F - x * x - y * y));
  const Vec3f n = x * across + y * along + z * stretched;
  return glm::normalize(Vec3f(alpha * n.x, alpha * n.y, std::max(1e-6F, n.z)));
}

inline Vec3f visible_microfacet(const Vec3f& normal, const Vec3f& view, float alpha, float u,
                                float v) {
  if (alpha < smallest_alpha) return normal;
  const glm::mat3 basis = basis_around(normal);
  return basis * visible_microfacet(view * basis, alpha, disc_distributed(u, v));
}

}  // namespace restframe
