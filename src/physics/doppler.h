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

}  // namespace restframe
