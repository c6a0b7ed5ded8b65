#pragma once

// Directions chosen at random: without branches, for loops over lanes.

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

// (cos, sin) of 2 pi v, v in [0, 1): Taylor's series on the eighths of a turn, to 4e-7. Compilers have
// no such functions for lanes.
inline Vec2f on_circle(float v) {
  const float quarters = std::floor(4.0F * v + 0.5F);
  const float x = (4.0F * v - quarters) * (0.5F * pi);
  const float x2 = x * x;
  const float s =
      x * (1.0F + x2 * (-1.0F / 6 + x2 * (1.0F / 120 + x2 * (-1.0F / 5040 + x2 / 362880))));
  const float c = 1.0F + x2 * (-0.5F + x2 * (1.0F / 24 + x2 * (-1.0F / 720 + x2 / 40320)));
  const int quarter = static_cast<int>(quarters) & 3;
  const bool odd = (quarter & 1) != 0;
  const float cosine = odd ? s : c, sine = odd ? c : s;
  const bool backwards = (quarter == 1) | (quarter == 2);
  return {backwards ? -cosine : cosine, quarter >= 2 ? -sine : sine};
}

inline Vec2f disc_distributed(float u, float v) {
  return std::sqrt(u) * on_circle(v);
}

inline Vec3f cosine_distributed(const glm::mat3& basis, const Vec2f& on_disc) {
  const float height = std::sqrt(std::max(0.0F, 1.0F - glm::dot(on_disc, on_disc)));
  return basis * Vec3f(on_disc.x, on_disc.y, height);
}

// Over the hemisphere.
inline Vec3f evenly_distributed(const Vec3f& normal, float u, float v) {
  const Vec2f around = std::sqrt(std::max(0.0F, 1.0F - u * u)) * on_circle(v);
  return basis_around(normal) * Vec3f(around.x, around.y, u);
}

// A microfacet's normal, distributed as those visible from `view` (Heitz 2018), around z, for a point
// that is distributed evenly over the unit disc.
inline Vec3f visible_microfacet(const Vec3f& view, float alpha, const Vec2f& point) {
  const Vec3f stretch(alpha * view.x, alpha * view.y, view.z);
  const Vec3f stretched = stretch / std::sqrt(std::max(1e-20F, glm::dot(stretch, stretch)));
  const float half = 0.5F * (1.0F + stretched.z);
  // The disc's half beyond the horizon of `stretched` is squeezed to what is seen of it. Its second
  // axis must be the one that lies in the plane of view and normal.
  const float sine2 = squared(stretched.x) + squared(stretched.y);
  const bool tilted = sine2 > 1e-10F;
  const float per_sine = 1.0F / std::sqrt(tilted ? sine2 : 1.0F);
  const Vec3f across(tilted ? -stretched.y * per_sine : 1.0F,
                     tilted ? stretched.x * per_sine : 0.0F, 0.0F);
  const Vec3f along = glm::cross(stretched, across);
  const float x = point.x;
  const float rim = std::sqrt(std::max(0.0F, 1.0F - x * x));
  const float y = rim + (point.y - rim) * half;
  const float z = std::sqrt(std::max(0.0F, 1.0F - x * x - y * y));
  const Vec3f n = x * across + y * along + z * stretched;
  const Vec3f facet(alpha * n.x, alpha * n.y, std::max(1e-6F, n.z));
  return facet / std::sqrt(glm::dot(facet, facet));
}

inline Vec3f choose(bool first, const Vec3f& a, const Vec3f& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

// The normal itself, if the surface is smooth.
inline Vec3f visible_microfacet(const glm::mat3& basis, const Vec3f& view, float alpha,
                                const Vec2f& on_disc) {
  const Vec3f rough = basis * visible_microfacet(view * basis, alpha, on_disc);
  return choose(alpha < smallest_alpha, basis[2], rough);
}

inline Vec3f mirrored_view(const Vec3f& view, const Vec3f& microfacet) {
  return 2.0F * glm::dot(view, microfacet) * microfacet - view;
}

// Where a lobe leads to. `there`: it does, else the light is absorbed. `exact`: no other lobe leads
// there, and this is its weight.
struct Way {
  Vec3f direction{0}, weight{0};
  bool there = false, exact = false, through = false;
};

// Of a surface without layers.
inline Way plain_way(const Bsdf& b, const ViewLobe& lobe, const Vec3f& numbers) {
  const glm::mat3 basis = basis_around(b.normal);
  const Vec2f on_disc = disc_distributed(numbers.y, numbers.z);
  const bool diffuse = numbers.x < lobe.diffuses;
  const Vec3f mirrored = mirrored_view(b.view, visible_microfacet(basis, b.view, b.alpha, on_disc));
  Way way;
  way.direction = choose(diffuse, cosine_distributed(basis, on_disc), mirrored);
  const float share = 1.0F / std::max(1e-20F, lobe.reflects);
  way.weight = (lobe.straight + lobe.grazing * schlick(lobe.cos_view)) * share;
  way.exact = !diffuse & (b.alpha < smallest_alpha);
  const float to_facet = glm::dot(way.direction, b.facet);
  const float to_normal = glm::dot(way.direction, b.normal);
  way.there = (lobe.diffuses + lobe.reflects > 0.0F) & (to_facet > 0.0F) & (to_normal > 0.0F);
  return way;
}

// Of one that is matte.
inline Way matte_way(const Vec3f& normal, const Vec3f& facet, float diffuses, float u, float v) {
  Way way;
  way.direction = cosine_distributed(basis_around(normal), disc_distributed(u, v));
  const float to_facet = glm::dot(way.direction, facet);
  const float to_normal = glm::dot(way.direction, normal);
  way.there = (diffuses > 0.0F) & (to_facet > 0.0F) & (to_normal > 0.0F);
  return way;
}

}  // namespace restframe
