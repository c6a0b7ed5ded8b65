#include "importers/gltf_node_transform.h"

namespace restframe {
namespace {

Vec3 vec3_of(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

Mat4 matrix_of(const NodePlacement& placement) {
  Mat4 matrix = glm::mat4_cast(glm::normalize(placement.rotation));
  for (int axis = 0; axis < 3; ++axis) matrix[axis] *= placement.scale[axis];
  matrix[3] = glm::dvec4(placement.translation, 1);
  return matrix;
}

Mat4 parent_from_node(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) {
    Mat4 matrix(1);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        matrix[column][row] = node.matrix[static_cast<std::size_t>(4 * column + row)];
      }
    }
    return matrix;
  }
  NodePlacement placement;
  const std::vector<double>& r = node.rotation;
  if (node.translation.size() == 3) placement.translation = vec3_of(node.translation);
  if (r.size() == 4) placement.rotation = glm::dquat(r[3], r[0], r[1], r[2]);
  if (node.scale.size() == 3) placement.scale = vec3_of(node.scale);
  return matrix_of(placement);
}

std::vector<Mat4> asset_from_nodes(const tinygltf::Model& model) {
  std::vector<int> parents(model.nodes.size(), -1), waiting;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    for (const int child : model.nodes[i].children) {
      parents[static_cast<std::size_t>(child)] = static_cast<int>(i);
    }
  }
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (parents[i] < 0) waiting.push_back(static_cast<int>(i));
  }
  std::vector<Mat4> result(model.nodes.size(), Mat4(1));
  while (!waiting.empty()) {
    const auto i = static_cast<std::size_t>(waiting.back());
    waiting.pop_back();
    result[i] = parent_from_node(model.nodes[i]);
    if (parents[i] >= 0) result[i] = result[static_cast<std::size_t>(parents[i])] * result[i];
    waiting.insert(waiting.end(), model.nodes[i].children.begin(), model.nodes[i].children.end());
  }
  return result;
}

}  // namespace restframe
