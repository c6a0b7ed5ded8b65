#pragma once

// The rest pose of meshes that could move: morph targets, then skins (glTF 2.0, 3.7.2.2, 3.7.3).

#include <tiny_gltf.h>

#include <map>
#include <vector>

#include "importers/gltf_geometry.h"
#include "importers/gltf_posed.h"

namespace restframe {

// The matrices of skins, each made when it is first asked for: asset_from_bind of every joint.
class Skins {
 public:
  Skins(const GltfContext& context, const tinygltf::Model& model)
      : context_(context), model_(model) {}
  const std::vector<Mat4>& matrices(int skin);

 private:
  const GltfContext& context_;
  const tinygltf::Model& model_;
  std::vector<Mat4> asset_from_node_;  // empty until the first skin
  std::map<int, std::vector<Mat4>> matrices_;
};

// Adds the weighted differences of the targets to the attributes that the mesh has.
void add_targets(const PrimitivePlace& place, const tinygltf::Model& model,
                 const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                 Mesh& mesh);

// Moves vertices to where their joints carry them, normals and tangents with them. Faults: joints
// that the skin does not have, weights that are negative or not finite.
void apply_skin(const PrimitivePlace& place, const tinygltf::Model& model,
                const tinygltf::Primitive& primitive, const std::vector<Mat4>& matrices,
                Mesh& mesh);

}  // namespace restframe
