#pragma once

// Vectors and matrices, from GLM. Double wherever spacetime is computed; float where Embree,
// textures and pixels are.

#include <cmath>

#include <glm/glm.hpp>

namespace restframe {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;

template <int N, class T>
bool is_finite(const glm::vec<N, T>& v) {
  bool finite = true;
  for (int i = 0; i < N; ++i) finite &= std::isfinite(v[i]);
  return finite;
}

// Whether no component is beyond +-limit; false for NaN.
template <int N, class T>
bool is_within(const glm::vec<N, T>& v, T limit) {
  bool within = true;
  for (int i = 0; i < N; ++i) within &= std::abs(v[i]) <= limit;
  return within;
}

}  // namespace restframe
