#include "scene/asset_tree.h"

#include <algorithm>
#include <cmath>

#include "scene/asset.h"

namespace restframe {
namespace {

// Of length one, whatever its length; 0 where it has none.
Vec3 unit_or_zero(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 && std::isfinite(largest) ? glm::normalize(v / largest) : Vec3(0);
}

}  // namespace

std::string place_of(const AssetTree& tree, int node) {
  const int number = tree.nodes[static_cast<std::size_t>(node)].number;
  return tree.number_prefix + std::to_string(number);
}

int subtree_end(const AssetTree& tree, int node) {
  const auto count = static_cast<int>(tree.nodes.size());
  int end = node + 1;
  while (end < count && tree.nodes[static_cast<std::size_t>(end)].parent >= node) ++end;
  return end;
}

NodeMarks nodes_of_scene(const AssetTree& tree, int scene) {
  NodeMarks marks(tree.nodes.size(), tree.scenes.empty() ? 1 : 0);
  if (tree.scenes.empty()) return marks;
  for (const int root : tree.scenes[static_cast<std::size_t>(scene)].roots) {
    marks[static_cast<std::size_t>(root)] = 1;
  }
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const int parent = tree.nodes[i].parent;
    if (parent >= 0) marks[i] = marks[static_cast<std::size_t>(parent)];
  }
  return marks;
}

NodeMarks nodes_of_default_scene(const AssetTree& tree) {
  return nodes_of_scene(tree, tree.default_scene);
}

NodePose pose_of(const AssetNode& node) {
  NodePose pose;
  pose.position = Vec3(node.asset_from_node[3]);
  const Vec3 forward = unit_or_zero(-Vec3(node.asset_from_node[2]));
  const Vec3 up = unit_or_zero(Vec3(node.asset_from_node[1]));
  if (!(glm::length(glm::cross(forward, up)) > 1e-9)) return pose;
  pose.forward = forward;
  pose.up = up;
  return pose;
}

const std::string& name_of(const Asset& asset, const Part& part) {
  return asset.tree.nodes[static_cast<std::size_t>(part.node)].name;
}

void add_part(Asset& asset, int mesh, const std::string& name, const Mat4& asset_from_mesh) {
  AssetNode node;
  node.name = name;
  node.asset_from_node = asset_from_mesh;
  asset.parts.push_back({mesh, static_cast<int>(asset.tree.nodes.size()), asset_from_mesh});
  asset.tree.nodes.push_back(std::move(node));
}

}  // namespace restframe
