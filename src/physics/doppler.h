#pragma once

#include "physics/lorentz.h"

namespace restframe {

// D = nu_observed / nu_emitted of light that is emitted in the frame of `k` and seen by the camera
// whose ray it is (k.t = -1 in the camera's frame). Equals the paper's alpha, equation 3.
template <class Frame>
double doppler_factor(const WaveVector<Frame>& k) {
  return -1.0 / k.t;
}

// The direction in which the target frame sees what the source frame sees along `direction` (unit).
template <class To, class From>
Vec3 aberrated(const Boost<To, From>& to_from, const Vec3& direction) {
  return sight_direction(to_from(looking_along<From>(direction)));
}

// The paper's figure 5: how many times as fast as it runs a clock is seen to run, equation 3's
// alpha = 1 / ((1 + e.beta) gamma). It moves at `speed` (0 <= speed < 1) and is seen `angle`
// radians (-pi/2 to pi/2, in the camera's frame) past the direction across its motion: at -pi/2 it
// approaches, at 0 it is seen exactly sideways, at pi/2 it recedes.
inline double blink_rate_factor(double speed, double angle) {
  const Boost<in::Rest, in::Camera> rest_from_camera(Velocity::from_beta({speed, 0, 0}));
  const Vec3 sight(std::sin(angle), std::cos(angle), 0);
  return doppler_factor(rest_from_camera(looking_along<in::Camera>(sight)));
}

// The angle of blink_rate_factor, in radians, at which the factor is 1: the cross-over angle. With
// theta from the velocity to the direction from object to observer, that is pi/2 + angle,
// cos(theta) = sqrt((gamma - 1) / (gamma + 1)); the tangent taken here, sqrt((gamma - 1) / 2), has
// gamma - 1 as (gamma beta)^2 / (gamma + 1), so it keeps its digits for slow objects. At rest the
// factor is 1 everywhere; the limit, 0, is returned.
inline double crossover_angle(double speed) {
  const Velocity velocity = Velocity::from_beta({speed, 0, 0});
  return -std::atan(velocity.gamma_beta().x / std::sqrt(2.0 * (velocity.gamma() + 1.0)));
}

}  // namespace restframe
