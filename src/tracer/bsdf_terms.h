#pragma once

// The factors of scattering functions, without branches: loops over lanes use them, too.

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "physics/vectors.h"

namespace restframe {

inline constexpr float pi = glm::pi<float>();
inline constexpr float least_cosine = 1e-4F;

inline float squared(float x) {
  return x * x;
}

inline float average(const Vec3f& v) {
  return (v.x + v.y + v.z) * (1.0F / 3.0F);
}

inline float largest(const Vec3f& v) {
  return std::max(v.x, std::max(v.y, v.z));
}

// Smith's lambda of GGX: hidden over visible microfacet area, seen at this cosine.
inline float smith_lambda(float cosine, float alpha) {
  const float c2 = cosine * cosine;
  return 0.5F * (std::sqrt(1.0F + squared(alpha) * (1.0F - c2) / c2) - 1.0F);
}

// Of microfacets in this direction. The sine comes from a cross product: where alpha is small, one
// minus the squared cosine has no digits left.
inline float ggx_density(const Vec3f& normal, const Vec3f& microfacet, float alpha) {
  const Vec3f across = glm::cross(normal, microfacet);
  const float sine2 = glm::dot(across, across);
  const float d = sine2 + squared(alpha * glm::dot(normal, microfacet));
  return squared(alpha) / (pi * std::max(1e-20F, d * d));
}

// How far reflection has gone from its value straight on to that at grazing angles (Schlick 1994).
inline float schlick(float cos_theta) {
  const float c = std::min(std::max(1.0F - cos_theta, 0.0F), 1.0F);
  return c * c * c * c * c;
}

// Reflection straight on, of what an index of refraction tells.
inline float straight_reflectance(float eta) {
  return squared((eta - 1.0F) / (eta + 1.0F));
}

inline float reflected_fraction(float cos_theta, float eta) {
  const float sin2_beyond = (1.0F - squared(cos_theta)) / squared(eta);
  const float cos_beyond = std::sqrt(std::max(0.0F, 1.0F - sin2_beyond));
  const float across = (cos_theta - eta * cos_beyond) / (cos_theta + eta * cos_beyond);
  const float along = (eta * cos_theta - cos_beyond) / (eta * cos_theta + cos_beyond);
  const float partial = 0.5F * (squared(across) + squared(along));
  return sin2_beyond >= 1.0F ? 1.0F : partial;
}

// Microfacets that mirror light to the view, but for their reflectance (GGX, height-correlated Smith).
struct Mirroring {
  float fraction = 0;  // with the light's cosine, per steradian
  float density = 0;   // of the direction, when the microfacet is chosen among those visible
  float cos_half = 0;  // of light and microfacet
};

inline Mirroring mirroring(const Vec3f& view, const Vec3f& normal, float alpha, float cos_view,
                           float lambda_view, float cos_light, const Vec3f& direction) {
  const Vec3f between = view + direction;
  const Vec3f microfacet = between / std::sqrt(std::max(1e-20F, glm::dot(between, between)));
  const float lambda = smith_lambda(std::max(least_cosine, cos_light), alpha);
  const float facets = ggx_density(normal, microfacet, alpha) / (4.0F * cos_view);
  return {facets / (1.0F + lambda_view + lambda), facets / (1.0F + lambda_view),
          std::max(0.0F, glm::dot(view, microfacet))};
}

}  // namespace restframe
