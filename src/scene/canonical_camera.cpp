#include "scene/canonical_listing.h"

namespace restframe {
namespace {

void add_aim(Listing& list, const std::string& key, const Aim& aim) {
  if (const auto* direction = std::get_if<AimDirection>(&aim)) {
    list.add(key + ".direction", direction->direction);
  } else if (const auto* point = std::get_if<AimPoint>(&aim)) {
    list.add(key + ".look_at", point->point);
  } else {
    add_worldline(list, key + ".track", std::get<AimTrack>(aim).target);
  }
}

void add_motion(Listing& list, const Worldline& worldline) {
  add_worldline(list, "camera", worldline);
}

void add_motion(Listing& list, const KeyedPath& path) {
  list.add("camera.time", path.time());
  for (std::size_t i = 0; i < path.keys().size(); ++i) {
    const PathKey& key = path.keys()[i];
    const std::string name = fmt::format("camera.key.{}", i);
    list.add(name + ".time", key.proper_time);
    list.add(name + ".position", key.position);
    if (path.states_velocity()) list.add(name + ".gamma_beta", key.velocity.gamma_beta());
  }
}

void add_motion(Listing& list, const AcceleratedPath& path) {
  add_worldline(list, "camera", path.start());
  for (std::size_t i = 0; i < path.legs().size(); ++i) {
    list.add(fmt::format("camera.leg.{}.duration", i), path.legs()[i].duration);
    list.add(fmt::format("camera.leg.{}.acceleration", i), path.legs()[i].acceleration);
  }
}

}  // namespace

void add_worldline(Listing& list, const std::string& key, const Worldline& worldline) {
  list.add(key + ".position", worldline.reference.x);
  list.add(key + ".time", worldline.reference.t);
  list.add(key + ".gamma_beta", worldline.velocity.gamma_beta());
}

void add_camera(Listing& list, const Camera& camera) {
  std::visit([&](const auto& motion) { add_motion(list, motion); }, camera.motion);
  list.add("camera.up", camera.up);
  list.add("camera.aperture", camera.aperture);
  list.add("camera.focus", camera.focus);
  list.add("camera.rolling", camera.rolling);
  if (camera.stereo) {
    list.add("camera.stereo.separation", camera.stereo->separation);
    list.add("camera.stereo.convergence", camera.stereo->convergence);
  }
  if (camera.view_keys.empty()) {
    add_aim(list, "camera", camera.aim);
    list.add("camera.fov", camera.vertical_fov);
  }
  for (std::size_t i = 0; i < camera.view_keys.size(); ++i) {
    const ViewKey& key = camera.view_keys[i];
    const std::string name = fmt::format("camera.view.{}", i);
    list.add(name + ".time", key.proper_time);
    add_aim(list, name, key.aim);
    list.add(name + ".fov", key.vertical_fov);
  }
}

}  // namespace restframe
