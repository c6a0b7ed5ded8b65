#pragma once

#include "tracer/exposed_camera.h"
#include "tracer/sample.h"

namespace restframe {

// How a surface that is hit looks to the camera, whose ray this is: sets its depth, and its normal as it
// appears. `velocity`: the surface's.
//
// What a camera sees at one moment are events of many times. Laid out in its rest frame, each at the
// distance that its light travelled, they form the surface that it believes to see: what moves is
// sheared, bent and turned in it. A plane n.x = const at rest in some frame is the world-sheet
// N.X = const with N = (0, n) there. In the camera's frame, N = (N_t, N_x), and what is seen of the
// sheet lies on the past light cone t = -|x|: there
//     N.X = N_x.x - N_t t = N_x.x + N_t |x|,
// so the apparent normal is the gradient N_x + N_t d, with the direction d = x / |x| in which it is
// seen. That is N + N_t k with the wave vector k = (-1, d): the one sum of N and multiples of k without a
// time part. Along d it is N.k, the same number in every frame, and negative for a normal towards the
// camera: what faces an observer appears to face every other one at that event. Across d it is that of
// N_x, which comes by way of the world: where camera and surface are both faster than gamma = 1e6 there, it
// loses the digits that gamma^2 takes.
inline void set_apparent(const CameraSight& sight, const Velocity& velocity, SurfaceData& data) {
  const Boost<in::Rest, in::World> rest_from_world(velocity);
  const Vec3& d = sight.direction;
  const WaveVector<in::World> k = sight.pose.world_from_camera(looking_along<in::Camera>(d));
  const double facing = glm::dot(data.normal, rest_from_world(k).x);
  const Displacement<in::World> world_normal =
      rest_from_world.inverse()(Displacement<in::Rest>{0, data.normal});
  const Vec3 across = sight.pose.world_from_camera.inverse()(world_normal).x;
  const Vec3 normal = across + (facing - glm::dot(across, d)) * d;
  const double length = glm::length(normal);
  data.depth = -data.distance * glm::dot(d, sight.pose.axes[2]);
  if (length > 0.0) data.apparent_normal = glm::transpose(sight.pose.axes) * normal / length;
}

}  // namespace restframe
