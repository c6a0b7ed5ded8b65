#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/texture.h"

namespace restframe {

// A mesh placed in the asset's coordinates.
struct Part {
  int mesh = 0;
  std::string node;         // the node's name, for messages and `info`
  Mat4 asset_from_mesh{1};  // affine; may mirror
};

// What an importer makes of a file, in the file's own units.
struct Asset {
  std::string name;  // file name without its folder
  std::vector<Mesh> meshes;
  std::vector<Part> parts;
  std::vector<Material> materials;  // slots of the meshes' material ranges; at least one
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::set<std::filesystem::path> files;  // canonical; those read besides the one of that name
};

}  // namespace restframe
