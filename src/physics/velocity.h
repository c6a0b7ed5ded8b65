#pragma once

#include <algorithm>
#include <cmath>

#include "physics/vectors.h"

namespace restframe {

// A velocity held as gamma * beta, which keeps its digits at any speed: near light, 1 - beta does
// not.
class Velocity {
 public:
  Velocity() = default;

  // beta: fractions of c, |beta| < 1.
  static Velocity from_beta(const Vec3& beta) {
    const double speed = glm::length(beta);
    return Velocity(beta / std::sqrt((1.0 - speed) * (1.0 + speed)));
  }

  // gamma >= 1; direction of any length but zero.
  static Velocity from_gamma(double gamma, const Vec3& direction) {
    // Scaled first: the square of a very long or short direction overflows or vanishes.
    const double largest =
        std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    return Velocity(std::sqrt((gamma - 1.0) * (gamma + 1.0)) * glm::normalize(direction / largest));
  }

  static Velocity from_gamma_beta(const Vec3& gamma_beta) { return Velocity(gamma_beta); }

  const Vec3& gamma_beta() const { return gamma_beta_; }
  double gamma() const { return gamma_; }
  Vec3 beta() const { return gamma_beta_ / gamma_; }
  Velocity operator-() const { return {-gamma_beta_, gamma_}; }
  bool operator==(const Velocity& other) const { return gamma_beta_ == other.gamma_beta_; }

 private:
  explicit Velocity(const Vec3& gamma_beta)
      : gamma_beta_(gamma_beta), gamma_(std::sqrt(1.0 + glm::dot(gamma_beta, gamma_beta))) {}

  Velocity(const Vec3& gamma_beta, double gamma) : gamma_beta_(gamma_beta), gamma_(gamma) {}

  Vec3 gamma_beta_{0, 0, 0};
  double gamma_ = 1;
};

}  // namespace restframe
