#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// What rounding of world coordinates leaves open in coordinates of the frame.
double rounding_of(const AnchoredFrame<in::Rest>& frame, const Event<in::World>& e) {
  const Event<in::World>& anchor = frame.anchor;
  const double coordinates =
      std::abs(e.t) + std::abs(anchor.t) + glm::length(e.x) + glm::length(anchor.x);
  return 4.0 * std::numeric_limits<double>::epsilon() * frame.from_world.velocity().gamma() *
         coordinates;
}

// In the target's rest frame the light comes straight from where the target rests (paper, section
// 4.4).
WaveVector<in::World> sight_of(const AimTrack& aim, const Event<in::World>& observer) {
  const AnchoredFrame<in::Rest> rest = aim.target.rest_frame();
  const Vec3 to_target = -rest(observer).x;
  if (!(glm::length(to_target) > rounding_of(rest, observer))) {
    throw InputError("camera: it meets \"" + aim.name + "\", which it tracks; track another point");
  }
  return rest.from_world.inverse()(looking_along<in::Rest>(glm::normalize(to_target)));
}

// What the camera looks at: a fraction of the way from one aim to another of the same kind.
struct View {
  const Aim& from;
  const Aim& to;
  double fraction = 0;
  double vertical_fov = 1;
};

View view_at(const Camera& camera, double proper_time) {
  const std::vector<ViewKey>& keys = camera.view_keys;
  if (keys.empty()) return {camera.aim, camera.aim, 0, camera.vertical_fov};
  const auto is_before = [](double time, const ViewKey& key) { return time < key.proper_time; };
  const auto next = std::upper_bound(keys.begin(), keys.end(), proper_time, is_before);
  const ViewKey& from = next == keys.begin() ? keys.front() : *(next - 1);
  const ViewKey& to = next == keys.end() ? keys.back() : *next;
  if (&from == &to) return {from.aim, from.aim, 0, from.vertical_fov};
  const double fraction = (proper_time - from.proper_time) / (to.proper_time - from.proper_time);
  return {from.aim, to.aim, fraction, glm::mix(from.vertical_fov, to.vertical_fov, fraction)};
}

WaveVector<in::World> sight_of(const View& view, const Event<in::World>& observer) {
  if (const auto* track = std::get_if<AimTrack>(&view.from)) return sight_of(*track, observer);
  const Vec3& begin = std::get<AimPoint>(view.from).point;
  const Vec3& end = std::get<AimPoint>(view.to).point;
  return sight_of(AimPoint{glm::mix(begin, end, view.fraction)}, observer);
}

// A point at the distance c ahead of the middle is half the separation to the left of the right eye:
// there it is seen at the tangent -separation / (2 c), which is where the film's middle belongs.
void move_to(Eye eye, const StereoSettings& stereo, CameraPose& pose) {
  if (eye == Eye::centre) return;
  const double to_right = (eye == Eye::right ? 0.5 : -0.5) * stereo.separation;
  pose.event =
      pose.event + pose.world_from_camera(Displacement<in::Camera>{0, to_right * pose.axes[0]});
  if (stereo.convergence > 0.0) pose.film_shift = -to_right / stereo.convergence;
}

CameraPose centre_pose(const Camera& camera, double proper_time) {
  const CameraState state = state_at(camera.motion, proper_time);
  const View view = view_at(camera, proper_time);
  const Boost<in::Camera, in::World> camera_from_world(state.velocity);
  CameraPose pose;
  pose.vertical_fov = view.vertical_fov;
  pose.event = state.event;
  pose.world_from_camera = camera_from_world.inverse();
  if (const auto* begin = std::get_if<AimDirection>(&view.from)) {
    const Vec3& end = std::get<AimDirection>(view.to).direction;
    const Vec3 direction = glm::mix(begin->direction, end, view.fraction);
    pose.axes = axes_looking(glm::normalize(direction), camera.up);
    return pose;
  }
  const WaveVector<in::World> sight = sight_of(view, pose.event);
  pose.axes = axes_looking(sight_direction(camera_from_world(sight)),
                           aberrated(camera_from_world, glm::normalize(camera.up)));
  return pose;
}

}  // namespace

std::vector<Eye> eyes_of(const Camera& camera) {
  if (camera.stereo) return {Eye::left, Eye::right};
  return {Eye::centre};
}

CameraPose pose_at(const Camera& camera, double proper_time, Eye eye) {
  CameraPose pose = centre_pose(camera, proper_time);
  if (camera.stereo) move_to(eye, *camera.stereo, pose);
  return pose;
}

bool is_steady(const Camera& camera) {
  const auto* uniform = std::get_if<Worldline>(&camera.motion);
  if (!uniform || !camera.view_keys.empty()) return false;
  if (std::holds_alternative<AimDirection>(camera.aim)) return true;
  const bool rests = uniform->velocity == Velocity();
  return rests && std::holds_alternative<AimPoint>(camera.aim);
}

Projection::Projection(const CameraPose& pose, double vertical_fov, int width, int height) {
  const double half_height = std::tan(0.5 * vertical_fov);
  const double half_width = half_height * width / height;
  step_x_ = pose.axes[0] * (2.0 * half_width / width);
  step_y_ = pose.axes[1] * (-2.0 * half_height / height);
  corner_ =
      -pose.axes[2] + (pose.film_shift - half_width) * pose.axes[0] + half_height * pose.axes[1];
}

}  // namespace restframe
