#include "scene/camera.h"

#include <cmath>

#include "physics/doppler.h"
#include "scene/error.h"

namespace restframe {
namespace {

// Columns right, up, backwards of a camera that looks along `forward` (unit).
Mat3 axes_looking(const Vec3& forward, const Vec3& up) {
  const Vec3 right = glm::cross(forward, up);
  const double sine = glm::length(right);
  if (!(sine > 1e-9 * glm::length(up))) {
    throw InputError("camera: it looks along its up direction; give another `up`");
  }
  const Vec3 unit_right = right / sine;
  return Mat3(unit_right, glm::cross(unit_right, forward), -forward);
}

WaveVector<in::World> sight_of(const AimPoint& aim, const Event<in::World>& observer) {
  const Vec3 to_point = aim.point - observer.x;
  if (!(glm::length(to_point) > 0.0)) {
    throw InputError("camera: it is at its look_at point; move one of them");
  }
  return looking_along<in::World>(glm::normalize(to_point));
}

// In the target's rest frame the light comes straight from where the target rests (paper, section
// 4.4).
WaveVector<in::World> sight_of(const AimTrack& aim, const Event<in::World>& observer) {
  const AnchoredFrame<in::Rest> rest = aim.target.rest_frame();
  const Vec3 to_target = -rest(observer).x;
  if (!(glm::length(to_target) > 0.0)) {
    throw InputError("camera: it meets \"" + aim.name + "\", which it tracks; track another point");
  }
  return rest.from_world.inverse()(looking_along<in::Rest>(glm::normalize(to_target)));
}

}  // namespace

CameraPose pose_at(const Camera& camera, double proper_time) {
  CameraPose pose;
  pose.vertical_fov = camera.vertical_fov;
  pose.event = camera.worldline.at_proper_time(proper_time);
  const Boost<in::Camera, in::World> camera_from_world(camera.worldline.velocity);
  pose.world_from_camera = camera_from_world.inverse();
  if (const auto* aim = std::get_if<AimDirection>(&camera.aim)) {
    pose.axes = axes_looking(glm::normalize(aim->direction), camera.up);
    return pose;
  }
  const auto* track = std::get_if<AimTrack>(&camera.aim);
  const WaveVector<in::World> sight = track != nullptr
                                          ? sight_of(*track, pose.event)
                                          : sight_of(std::get<AimPoint>(camera.aim), pose.event);
  pose.axes = axes_looking(sight_direction(camera_from_world(sight)),
                           aberrated(camera_from_world, glm::normalize(camera.up)));
  return pose;
}

bool is_steady(const Camera& camera) {
  if (std::holds_alternative<AimDirection>(camera.aim)) return true;
  const bool rests = camera.worldline.velocity.gamma_beta() == Vec3(0);
  return rests && std::holds_alternative<AimPoint>(camera.aim);
}

Projection::Projection(const CameraPose& pose, double vertical_fov, int width, int height) {
  const double half_height = std::tan(0.5 * vertical_fov);
  const double half_width = half_height * width / height;
  step_x_ = pose.axes[0] * (2.0 * half_width / width);
  step_y_ = pose.axes[1] * (-2.0 * half_height / height);
  corner_ = -pose.axes[2] - half_width * pose.axes[0] + half_height * pose.axes[1];
}

}  // namespace restframe
