#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "importers/importers.h"
#include "support/path_scene.h"
#include "support/temporary_folder.h"

namespace restframe {

// A scene from text, and from files beside it.
inline Scene loaded_scene(const std::string& text, const std::vector<AssetFile>& files = {}) {
  const TemporaryFolder folder;
  for (const AssetFile& file : files) folder.write(file.name, file.content);
  Warnings warnings;
  return load_scene(folder.write("scene.toml", text), {}, warnings);
}

// An asset as it is seen from (0, 0, 2): at z = 0 a square picture of so many pixels shows x and y from
// -1 to 1. Of one sample, with the normals.
inline Scene seen_from_front(const std::filesystem::path& file, int pixels) {
  Warnings warnings;
  Scene scene = load_scene(file, {}, warnings);
  EXPECT_EQ(warnings, Warnings{});
  std::get<Worldline>(scene.camera.motion).reference.x = {0, 0, 2};
  scene.camera.vertical_fov = 2 * std::atan(0.5);
  scene.camera_given = true;
  scene.render.width = scene.render.height = pixels;
  scene.render.samples = 1;
  scene.output.layers = {Layer::beauty, Layer::normal};
  return scene;
}

inline Material& material_of(Scene& scene, const std::string& name) {
  for (Material& material : scene.materials) {
    if (material.name == name) return material;
  }
  throw std::out_of_range("no material " + name);
}

}  // namespace restframe
