#pragma once

// Scene files of a few lit surfaces, part by part.

#include <fmt/format.h>

#include <string>

#include "support/loaded_scene.h"

namespace restframe {

inline std::string camera_at(const Vec3& position, double fov, const std::string& render_keys) {
  reference::ObserverCamera camera;
  camera.position = position;
  camera.width = camera.height = 12;
  camera.vertical_fov = fov;
  return camera_text(camera, render_keys);
}

inline std::string material(const std::string& name, const std::string& keys) {
  return fmt::format("[[material]]\nname = \"{}\"\n{}\n", name, keys);
}

}  // namespace restframe
