#pragma once

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

inline Material& material_of(Scene& scene, const std::string& name) {
  for (Material& material : scene.materials) {
    if (material.name == name) return material;
  }
  throw std::out_of_range("no material " + name);
}

}  // namespace restframe
