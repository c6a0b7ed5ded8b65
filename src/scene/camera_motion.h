#pragma once

// How a camera moves: an event and a velocity for each moment of its own clock. Events are the
// world's; lengths light-seconds, times seconds, accelerations c a second.

#include <variant>
#include <vector>

#include "physics/worldline.h"

namespace restframe {

struct CameraState {
  Event<in::World> event;
  Velocity velocity;
};

// Beyond this, doubles no longer tell where a camera is after some seconds of its clock.
constexpr double largest_camera_gamma = 1e8;

// Where the camera is when its clock shows `proper_time`.
struct PathKey {
  double proper_time = 0;
  Vec3 position{0, 0, 0};
  Velocity velocity;  // if the path states velocities
};

// A path through keys; between them, the position is linear in the camera's proper time tau.
//
// Without stated velocities the motion between two keys is uniform, with gamma beta = dx / dtau:
// any path stays below c. At a key the camera moves as after it, at the last one as before it;
// before the first key and after the last it rests there.
//
// Stated velocities say how fast the camera is for aberration and for its clock, whatever the path:
// gamma beta is linear in tau between the keys; before the first and after the last it is theirs,
// while the position holds.
//
// World time follows the clock: dt = gamma dtau.
class KeyedPath {
 public:
  // time: the world's when the camera's clock shows 0. keys: at least one, in rising time.
  KeyedPath(double time, std::vector<PathKey> keys, bool states_velocity);

  CameraState state_at(double proper_time) const;

  double time() const { return time_; }
  const std::vector<PathKey>& keys() const { return keys_; }
  bool states_velocity() const { return states_velocity_; }

 private:
  Vec3 gamma_beta_after(std::size_t key, double fraction) const;
  CameraState held_at(std::size_t key, double proper_time) const;
  CameraState state_after(std::size_t key, double proper_time) const;

  double time_ = 0;
  std::vector<PathKey> keys_;
  bool states_velocity_ = false;
  std::vector<double> world_times_;  // of each key
};

// A span of constant proper acceleration. Its direction is in the camera's rest frame at the
// span's beginning, whose axes are a pure boost of the world's.
struct AccelerationLeg {
  double duration = 1;  // proper time
  Vec3 acceleration{0, 0, 0};
};

// An observer who accelerates leg by leg, from clock 0 on; before and after, the motion is uniform.
class AcceleratedPath {
 public:
  // start: where the camera is at clock 0, and how fast.
  AcceleratedPath(const Worldline& start, std::vector<AccelerationLeg> legs);

  CameraState state_at(double proper_time) const;

  const Worldline& start() const { return beginnings_.front(); }
  const std::vector<AccelerationLeg>& legs() const { return legs_; }
  // Uniform motion as it would go on from the end of leg `index`.
  const Worldline& after_leg(std::size_t index) const { return beginnings_[index + 1]; }

 private:
  std::vector<AccelerationLeg> legs_;
  std::vector<double> clocks_;         // at the beginning of each leg, and at the end of the last
  std::vector<Worldline> beginnings_;  // likewise: uniform motion from there
};

using CameraMotion = std::variant<Worldline, KeyedPath, AcceleratedPath>;

// Exact for any time.
CameraState state_at(const CameraMotion& motion, double proper_time);

}  // namespace restframe
