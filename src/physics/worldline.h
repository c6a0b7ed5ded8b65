#pragma once

#include "physics/lorentz.h"

namespace restframe {

// Something that moves uniformly: where it is at one event, and how fast.
struct Worldline {
  Event<in::World> reference;
  Velocity velocity;

  AnchoredFrame<in::Rest> rest_frame() const {
    return {reference, Boost<in::Rest, in::World>(velocity)};
  }

  Event<in::World> at_proper_time(double tau) const {
    return {reference.t + velocity.gamma() * tau, reference.x + velocity.gamma_beta() * tau};
  }
};

// Where on its past light cone `observer` sees the point that rests at `point` in the frame `rest`
// (paper, section 4.4, steps 1 to 3).
Event<in::Rest> seen_event(const AnchoredFrame<in::Rest>& rest, const Event<in::World>& observer,
                           const Vec3& point);

}  // namespace restframe
