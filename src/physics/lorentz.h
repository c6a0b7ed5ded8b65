#pragma once

// Pure boosts. Both frames share axes up to the boost (no rotation), as the design lays down.
//
// With u = gamma beta of the target frame as the source frame measures it, a displacement (t, x)
// becomes
//     t' = gamma t - u.x                x' = x + u ((u.x) / (gamma + 1) - t).
// Nothing divides by |u|, so rest is not special. For null vectors these differences cancel:
// head-on at gamma = 10^6 they leave an error of 5e-4 in the frequency. There, with omega = |x| =
// -t,
//     omega' = gamma omega + u.x = (omega^2 + |u x x|^2) / (gamma omega - u.x)   where u.x < 0,
// which has no difference left, and x' = x + u (omega + omega') / (gamma + 1), rescaled to |x'| =
// omega'.

#include "physics/four_vector.h"
#include "physics/velocity.h"

namespace restframe {

// Named target first: `Boost<in::Rest, in::World> rest_from_world` takes world vectors to the rest
// frame.
template <class To, class From>
class Boost {
 public:
  Boost() = default;

  // velocity: of the frame `To`, measured in the frame `From`.
  explicit Boost(const Velocity& velocity)
      : velocity_(velocity), inverse_gamma_plus_1_(1.0 / (velocity.gamma() + 1.0)) {}

  const Velocity& velocity() const { return velocity_; }
  bool is_identity() const { return velocity_.gamma_beta() == Vec3(0); }
  Boost<From, To> inverse() const { return {-velocity_, inverse_gamma_plus_1_}; }

  Displacement<To> operator()(const Displacement<From>& d) const {
    const Vec3& u = velocity_.gamma_beta();
    const double gamma = velocity_.gamma();
    const double u_dot_x = glm::dot(u, d.x);
    return {gamma * d.t - u_dot_x, d.x + u * (u_dot_x * inverse_gamma_plus_1_ - d.t)};
  }

  WaveVector<To> operator()(const WaveVector<From>& k) const {
    const Vec3& u = velocity_.gamma_beta();
    const double gamma = velocity_.gamma();
    const double omega = -k.t;
    const double u_dot_x = glm::dot(u, k.x);
    const Vec3 u_cross_x = glm::cross(u, k.x);
    // omega' = numerator / sum without a difference; one division gives it and its inverse, and the choice
    // of the numerator is no branch.
    const double sum = gamma * omega + std::abs(u_dot_x);
    const double numerator =
        u_dot_x < 0.0 ? omega * omega + glm::dot(u_cross_x, u_cross_x) : sum * sum;
    const double inverse = 1.0 / (sum * numerator);
    const double omega_to = numerator * numerator * inverse;
    const double inverse_omega_to = sum * sum * inverse;
    const Vec3 x_to = k.x + u * ((omega + omega_to) * inverse_gamma_plus_1_);
    // omega' / |x'| to first order in their difference, which is rounding: what is left is its square.
    const Vec3 unit = x_to * inverse_omega_to;
    return {-omega_to, x_to * (1.5 - 0.5 * glm::dot(unit, unit))};
  }

 private:
  template <class, class>
  friend class Boost;
  Boost(const Velocity& velocity, double inverse_gamma_plus_1)
      : velocity_(velocity), inverse_gamma_plus_1_(inverse_gamma_plus_1) {}

  Velocity velocity_;
  double inverse_gamma_plus_1_ = 0.5;
};

// The velocity, in the frame `From`, of something that moves with `velocity` in the frame `To`.
template <class To, class From>
Velocity composed(const Boost<To, From>& to_from, const Velocity& velocity) {
  const Displacement<To> four_velocity{velocity.gamma(), velocity.gamma_beta()};
  return Velocity::from_gamma_beta(to_from.inverse()(four_velocity).x);
}

// Where a frame's own coordinates begin: times and places in it are told from `anchor`, an event
// near the things at rest there, so that large world coordinates cancel before they are multiplied
// by gamma.
template <class To>
struct AnchoredFrame {
  Event<in::World> anchor;
  Boost<To, in::World> from_world;

  Event<To> operator()(const Event<in::World>& e) const {
    const Displacement<To> d = from_world(e - anchor);
    return {d.t, d.x};
  }
  WaveVector<To> operator()(const WaveVector<in::World>& k) const { return from_world(k); }

  Event<in::World> to_world(const Event<To>& e) const {
    return anchor + from_world.inverse()(Displacement<To>{e.t, e.x});
  }
};

}  // namespace restframe
