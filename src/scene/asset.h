#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/asset_tree.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/texture.h"

namespace restframe {

// A mesh placed in the asset's coordinates.
struct Part {
  int mesh = 0;
  int node = 0;             // index into the tree's nodes; instances share one
  Mat4 asset_from_mesh{1};  // affine; may mirror
};

// A slot whose material depends on the variant of the asset that is shown.
struct VariantSlot {
  int material = 0;               // where the variant says nothing, and without one
  std::map<int, int> by_variant;  // variant to material
};

// What an importer makes of a file, in the file's own units.
struct Asset {
  std::string name;  // file name without its folder
  std::vector<Mesh> meshes;
  std::vector<Part> parts;  // of all scenes, in the order of their nodes
  // Slots of the meshes' material ranges; at least one. Slots beyond are `variant_slots`.
  std::vector<Material> materials;
  std::vector<std::string> variants;  // names of the looks that the asset comes in
  std::vector<VariantSlot> variant_slots;
  std::vector<Texture> textures;
  std::vector<Image> images;
  AssetTree tree;
  std::vector<std::string> extensions;    // that the file says it uses
  std::set<std::filesystem::path> files;  // canonical; those read besides the one of that name
};

// The name of the node that places it.
const std::string& name_of(const Asset& asset, const Part& part);

// Places a mesh at a new root node of this name.
void add_part(Asset& asset, int mesh, const std::string& name,
              const Mat4& asset_from_mesh = Mat4(1));

}  // namespace restframe
