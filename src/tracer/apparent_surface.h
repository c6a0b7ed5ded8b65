#pragma once

#include "scene/camera.h"
#include "tracer/sample.h"

namespace restframe {

// Sets what a camera at `pose` makes of a surface that it hits: its depth, and its normal as it appears.
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
// N_x. Neither is a difference of large numbers.
inline void set_apparent(const CameraPose& pose, SurfaceData& data) {
  const Boost<in::Camera, in::World> camera_from_world = pose.world_from_camera.inverse();
  const Vec3 d = sight_direction(camera_from_world(data.sight));
  const Vec3 sheet_normal = camera_from_world(data.sheet_normal).x;
  const Vec3 normal = sheet_normal + (data.facing - glm::dot(sheet_normal, d)) * d;
  const double length = glm::length(normal);
  const Mat3 axes_from_camera = glm::transpose(pose.axes);
  data.depth = -data.distance * glm::dot(d, pose.axes[2]);
  if (length > 0.0) data.apparent_normal = axes_from_camera * normal / length;
}

}  // namespace restframe
