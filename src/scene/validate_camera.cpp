#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "scene/error.h"
#include "scene/validate_data.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

bool is_near(const Event<in::World>& e) {
  return std::abs(e.t) <= farthest && is_within(e.x, farthest);  // false for NaN
}

void check_fov(double fov, const std::string& name, Faults& faults) {
  if (fov > 0 && fov < std::numbers::pi) return;
  faults.push_back(
      fmt::format("{}: fov is {}, must be above 0 and below 180", name, glm::degrees(fov)));
}

void check_aim(const Aim& aim, const Vec3& up, const std::string& name, Faults& faults) {
  if (const auto* ahead = std::get_if<AimDirection>(&aim)) {
    const double sine =
        glm::length(glm::cross(glm::normalize(ahead->direction), glm::normalize(up)));
    if (!(sine > 1e-9)) {
      faults.push_back(name + ": direction must be finite, of length 1, and not along up");
    }
  } else if (const auto* point = std::get_if<AimPoint>(&aim)) {
    if (!is_within(point->point, farthest)) {
      faults.push_back(name + ": look_at must be finite and within 1e100 light-seconds");
    }
  } else {
    validate_worldline(std::get<AimTrack>(aim).target, name + ": track", faults);
  }
}

// Whether clock times are finite and each above the one before.
template <class Key>
bool are_in_order(const std::vector<Key>& keys) {
  double before = -std::numeric_limits<double>::infinity();
  for (const Key& key : keys) {
    if (!(key.proper_time > before) || !std::isfinite(key.proper_time)) return false;
    before = key.proper_time;
  }
  return true;
}

bool are_opposite(const Aim& a, const Aim& b) {
  const auto *from = std::get_if<AimDirection>(&a), *to = std::get_if<AimDirection>(&b);
  return from && to &&
         glm::length(glm::normalize(from->direction) + glm::normalize(to->direction)) < 1e-9;
}

void check_view_keys(const Camera& camera, Faults& faults) {
  const std::vector<ViewKey>& keys = camera.view_keys;
  if (!are_in_order(keys)) {
    faults.push_back("camera: times of its view keys must be finite and rise");
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string name = fmt::format("camera: view key {}", i);
    check_fov(keys[i].vertical_fov, name, faults);
    check_aim(keys[i].aim, camera.up, name, faults);
    if (keys[i].aim.index() != keys[0].aim.index()) {
      faults.push_back(name + " has another kind of aim than the first");
    }
    if (i > 0 && are_opposite(keys[i - 1].aim, keys[i].aim)) {
      faults.push_back(name + " looks the opposite way to the one before");
    }
  }
}

void check_motion(const Worldline& worldline, Faults& faults) {
  validate_worldline(worldline, "camera", faults);
}

void check_motion(const KeyedPath& path, Faults& faults) {
  const std::vector<PathKey>& keys = path.keys();
  if (keys.empty()) faults.push_back("camera: a path must have at least one key");
  if (!are_in_order(keys)) faults.push_back("camera: times of its keys must be finite and rise");
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string name = fmt::format("camera: key {}", i);
    const CameraState state = path.state_at(keys[i].proper_time);
    if (!is_near(state.event) || !is_within(keys[i].position, farthest)) {
      faults.push_back(name + ": position and time must be finite and within 1e100 light-seconds");
    } else if (!(state.velocity.gamma() <= largest_camera_gamma)) {
      faults.push_back(fmt::format("{}: gamma is {}, must be at most {}", name,
                                   state.velocity.gamma(), largest_camera_gamma));
    }
  }
}

void check_motion(const AcceleratedPath& path, Faults& faults) {
  check_motion(path.start(), faults);
  for (std::size_t i = 0; i < path.legs().size(); ++i) {
    const AccelerationLeg& leg = path.legs()[i];
    const std::string name = fmt::format("camera: leg {}", i);
    if (!(leg.duration > 0 && std::isfinite(leg.duration))) {
      faults.push_back(
          fmt::format("{}: duration is {}, must be above 0 and finite", name, leg.duration));
    }
    if (!is_finite(leg.acceleration)) faults.push_back(name + ": acceleration must be finite");
    const Worldline& after = path.after_leg(i);
    if (!is_near(after.reference)) {
      faults.push_back(name + " must end within 1e100 light-seconds and seconds");
    } else if (!(after.velocity.gamma() <= largest_camera_gamma)) {
      faults.push_back(fmt::format("{}: gamma is {} at its end, must be at most {}", name,
                                   after.velocity.gamma(), largest_camera_gamma));
    } else {
      continue;
    }
    return;
  }
}

std::optional<std::string> pose_fault(const Camera& camera, double proper_time) {
  try {
    if (is_near(pose_at(camera, proper_time).event)) return std::nullopt;
    return "camera: it is farther than 1e100 light-seconds, or seconds, from the world's origin";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

void validate_worldline(const Worldline& worldline, const std::string& name, Faults& faults) {
  if (!is_near(worldline.reference)) {
    faults.push_back(name + ": position and time must be finite and within 1e100 light-seconds");
  }
  if (!is_finite(worldline.velocity.gamma_beta()) || !std::isfinite(worldline.velocity.gamma())) {
    faults.push_back(name + ": |velocity| must be below 1");
  }
}

void validate_camera(const Camera& camera, Faults& faults) {
  std::visit([&](const auto& motion) { check_motion(motion, faults); }, camera.motion);
  if (!is_finite(camera.up) || !(glm::length(camera.up) > 0)) {
    faults.push_back("camera: up must be finite and of a length above 0");
  }
  check_view_keys(camera, faults);
  if (!camera.view_keys.empty()) return;
  check_fov(camera.vertical_fov, "camera", faults);
  check_aim(camera.aim, camera.up, "camera", faults);
}

// A moving camera may pass what it looks at.
void validate_poses(const Scene& scene, Faults& faults) {
  // So many exposures that this would last are left to the rendering.
  const bool few = 1.0 * scene.animation.pictures * scene.exposure.count <= 1e6;
  const int exposures = few ? scene.exposure.count : 1;
  // Motion is told from where the picture after the last would see things.
  const int pictures =
      scene.animation.pictures + (has_layer(scene.output.layers, Layer::motion) ? 1 : 0);
  for (int picture = 0; picture < pictures; ++picture) {
    const double opening = scene.animation.start + picture / scene.animation.rate;
    for (int i = 0; i < exposures; ++i) {
      const auto fault = pose_fault(scene.camera, opening + i * scene.exposure.interval);
      if (!fault) continue;
      faults.push_back(fmt::format("picture {}: {}", picture, *fault));
      return;
    }
  }
}

}  // namespace restframe
