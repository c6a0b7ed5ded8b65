#pragma once

// Vectors and 4x4 Lorentz matrices in long double, for expected values: written without
// src/physics, in the textbook's form, so that the tested code and its reference share nothing but
// the inputs.

#include <array>
#include <cmath>

#include "physics/vectors.h"

namespace restframe::reference {

struct Long3 {
  long double x = 0, y = 0, z = 0;
};

inline Long3 widened(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline Vec3 narrowed(const Long3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Long3 operator+(const Long3& a, const Long3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Long3 operator-(const Long3& a, const Long3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Long3 operator*(long double s, const Long3& v) {
  return {s * v.x, s * v.y, s * v.z};
}
inline Long3 operator/(const Long3& v, long double s) {
  return {v.x / s, v.y / s, v.z / s};
}
inline long double dot(const Long3& a, const Long3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Long3 cross(const Long3& a, const Long3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double length(const Long3& v) {
  return std::sqrt(dot(v, v));
}
inline Long3 normalized(const Long3& v) {
  return v / length(v);
}
inline long double angle_between(const Long3& a, const Long3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

// gamma of a velocity given as u = gamma beta.
inline long double gamma_of(const Long3& u) {
  return std::sqrt(1 + dot(u, u));
}

struct Long4 {
  long double t = 0;
  Long3 x;
};

// The components of a displacement in a frame that moves with u = gamma beta.
inline Long4 boosted(const Long3& u, const Long4& d) {
  const long double gamma = gamma_of(u);
  return {gamma * d.t - dot(u, d.x), d.x + (dot(u, d.x) / (gamma + 1) - d.t) * u};
}

// Rows and columns t, x, y, z.
struct LongMatrix {
  std::array<std::array<long double, 4>, 4> rows{};

  std::array<long double, 4>& operator[](std::size_t i) { return rows[i]; }
  const std::array<long double, 4>& operator[](std::size_t i) const { return rows[i]; }
};

// The matrix of `boosted`.
inline LongMatrix boost_matrix(const Long3& u) {
  const std::array<long double, 3> c = {u.x, u.y, u.z};
  const long double gamma = gamma_of(u);
  LongMatrix m;
  m[0][0] = gamma;
  for (std::size_t i = 0; i < 3; ++i) {
    m[0][i + 1] = m[i + 1][0] = -c[i];
    for (std::size_t j = 0; j < 3; ++j) {
      m[i + 1][j + 1] = (i == j ? 1.0L : 0.0L) + c[i] * c[j] / (gamma + 1);
    }
  }
  return m;
}

inline LongMatrix operator*(const LongMatrix& a, const LongMatrix& b) {
  LongMatrix product;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) product[i][j] += a[i][k] * b[k][j];
    }
  }
  return product;
}

inline Long4 operator*(const LongMatrix& m, const Long4& d) {
  std::array<long double, 4> r{};
  for (std::size_t i = 0; i < 4; ++i) {
    r[i] = m[i][0] * d.t + m[i][1] * d.x.x + m[i][2] * d.x.y + m[i][3] * d.x.z;
  }
  return {r[0], {r[1], r[2], r[3]}};
}

// -k.t in a frame that moves with u, of a ray of unit frequency that looks along e (of any length),
// that is gamma (1 + beta.e). With w = u/|u| it is 1/(gamma + |u|) + |u| |e + w|^2 / 2, a sum of
// positives.
inline long double frequency_seen_from(const Long3& u, const Long3& e) {
  const long double speed = length(u);
  const Long3 w = speed > 0 ? u / speed : Long3{};
  const Long3 sum = normalized(e) + w;
  if (speed == 0) return 1;
  return 1 / (gamma_of(u) + speed) + speed * dot(sum, sum) / 2;
}

}  // namespace restframe::reference
