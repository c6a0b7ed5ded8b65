#pragma once

#include <tiny_gltf.h>

#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

struct NodePlacement {
  Vec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  Vec3 scale{1};
};

// Scales, then rotates, then moves.
Mat4 matrix_of(const NodePlacement& placement);

// From the node's matrix, or its translation, rotation and scale.
Mat4 parent_from_node(const tinygltf::Node& node);

// asset_from_node of every node of a checked document, in a scene or not.
std::vector<Mat4> asset_from_nodes(const tinygltf::Model& model);

}  // namespace restframe
