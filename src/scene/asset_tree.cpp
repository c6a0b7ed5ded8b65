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

NodeRange subtree(const AssetTree& tree, int node) {
  const auto count = static_cast<int>(tree.nodes.size());
  int end = node + 1;
  while (end < count && tree.nodes[static_cast<std::size_t>(end)].parent >= node) ++end;
  return {node, end};
}

NodeRanges nodes_of_scene(const AssetTree& tree, int scene) {
  if (tree.scenes.empty()) return united({{0, static_cast<int>(tree.nodes.size())}});
  std::vector<NodeRange> ranges;
  for (const int root : tree.scenes[static_cast<std::size_t>(scene)].roots) {
    ranges.push_back(subtree(tree, root));
  }
  return united(std::move(ranges));
}

NodeRanges nodes_of_default_scene(const AssetTree& tree) {
  return nodes_of_scene(tree, tree.default_scene);
}

NodeRanges united(std::vector<NodeRange> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const NodeRange& a, const NodeRange& b) { return a.begin < b.begin; });
  NodeRanges result;
  for (const NodeRange& range : ranges) {
    if (range.begin >= range.end) continue;
    if (!result.empty() && range.begin <= result.back().end) {
      result.back().end = std::max(result.back().end, range.end);
    } else {
      result.push_back(range);
    }
  }
  return result;
}

NodeRanges without(const NodeRanges& nodes, const NodeRanges& others) {
  NodeRanges result;
  auto other = others.begin();
  for (const NodeRange& range : nodes) {
    int begin = range.begin;
    while (other != others.end() && other->end <= begin) ++other;
    for (auto inside = other; inside != others.end() && inside->begin < range.end; ++inside) {
      if (inside->begin > begin) result.push_back({begin, inside->begin});
      begin = std::max(begin, inside->end);
      other = inside;
    }
    if (begin < range.end) result.push_back({begin, range.end});
  }
  return result;
}

NodeRanges common(const NodeRanges& nodes, const NodeRanges& others) {
  return without(nodes, without(nodes, others));
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
