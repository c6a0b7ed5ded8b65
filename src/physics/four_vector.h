#pragma once

// Events and wave vectors, each in a frame that the compiler knows: a world event cannot be used as
// a rest-frame one. Units: c = 1, seconds and light-seconds; metric (-,+,+,+); right-handed axes.

#include <cmath>

#include "physics/vectors.h"

namespace restframe {

// The frames that types tell apart: Event<in::World> against Event<in::Rest>.
namespace in {
struct World;      // the inertial frame in which a scene is written
struct Rest;       // the rest frame of the objects of one velocity
struct Camera;     // the rest frame of the camera
struct LightRest;  // the rest frame of one light
}  // namespace in

// The difference of two events.
template <class Frame>
struct Displacement {
  double t = 0;
  Vec3 x{0, 0, 0};
};

// A point of spacetime.
template <class Frame>
struct Event {
  double t = 0;
  Vec3 x{0, 0, 0};
};

// The null 4-vector along a ray, traced backwards in time: t = -|x|. Minus its time part is the
// light's frequency in this frame over its frequency in the camera's (design: one ray, one
// parameter).
template <class Frame>
struct WaveVector {
  double t = -1;
  Vec3 x{0, 0, -1};
};

template <class Frame>
Displacement<Frame> operator-(const Event<Frame>& a, const Event<Frame>& b) {
  return {a.t - b.t, a.x - b.x};
}

template <class Frame>
Event<Frame> operator+(const Event<Frame>& e, const Displacement<Frame>& d) {
  return {e.t + d.t, e.x + d.x};
}

template <class Frame>
Displacement<Frame> operator*(double s, const WaveVector<Frame>& k) {
  return {s * k.t, s * k.x};
}

// The event at parameter s of the ray from `origin` along `k`; s is the same number in every frame.
template <class Frame>
Event<Frame> point_on_ray(const Event<Frame>& origin, const WaveVector<Frame>& k, double s) {
  return origin + s * k;
}

template <class Frame>
double minkowski_dot(const Displacement<Frame>& a, const Displacement<Frame>& b) {
  return glm::dot(a.x, b.x) - a.t * b.t;
}

// A ray of unit frequency that looks along `direction` (unit length).
template <class Frame>
WaveVector<Frame> looking_along(const Vec3& direction) {
  return {-1.0, direction};
}

// The unit direction in which the ray looks, that is, against the light's propagation.
template <class Frame>
Vec3 sight_direction(const WaveVector<Frame>& k) {
  return k.x * (-1.0 / k.t);
}

template <class Frame>
bool is_finite(const Event<Frame>& e) {
  return std::isfinite(e.t) && std::isfinite(e.x.x) && std::isfinite(e.x.y) && std::isfinite(e.x.z);
}

}  // namespace restframe
