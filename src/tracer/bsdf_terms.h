#pragma once

// The factors of scattering functions, without branches: loops over lanes use them, too.

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "physics/vectors.h"

namespace restframe {

inline constexpr float pi = glm::pi<float>();

inline float squared(float x) {
  return x * x;
}

// Smith's lambda of GGX: hidden over visible microfacet area, seen at this cosine.
inline float smith_lambda(float cosine, float alpha) {
  const float c2 = cosine * cosine;
  return 0.5F * (std::sqrt(1.0F + squared(alpha) * (1.0F - c2) / c2) - 1.0F);
}

inline float ggx_density(float cosine, float alpha) {
  const float d = 1.0F + squared(cosine) * (squared(alpha) - 1.0F);
  return squared(alpha) / (pi * d * d);
}

inline Vec3f schlick(const Vec3f& normal_reflectance, float cos_theta) {
  const float c = std::min(std::max(1.0F - cos_theta, 0.0F), 1.0F);
  return normal_reflectance + (Vec3f(1) - normal_reflectance) * (c * c * c * c * c);
}

}  // namespace restframe
