#include "tracer/emitter_tree.h"

#include <algorithm>
#include <cmath>

namespace restframe {
namespace {

// Leaves are halved, along the longest axis of their middles.
std::size_t middle(std::size_t begin, std::size_t end) {
  return begin + (end - begin) / 2;
}

Vec3 center(const TreeLeaf& leaf) {
  return 0.5 * (leaf.lower + leaf.upper);
}

float sine(float cosine) {
  return std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
}

// Of the angles within `cover` of another, each by its cosine and sine; 0 where all are beyond a right
// angle.
float largest_cosine(float cosine, float sin, float cos_cover, float sin_cover) {
  if (cosine >= cos_cover) return 1.0F;
  return std::max(0.0F, cosine * cos_cover + sin * sin_cover);
}

}  // namespace

EmitterTree::EmitterTree(std::vector<TreeLeaf> leaves) {
  if (leaves.empty()) return;
  Vec3 lower = leaves[0].lower, upper = leaves[0].upper;
  std::uint32_t names = 0;
  for (const TreeLeaf& leaf : leaves) {
    lower = glm::min(lower, leaf.lower);
    upper = glm::max(upper, leaf.upper);
    names = std::max(names, leaf.index + 1);
  }
  center_ = 0.5 * (lower + upper);
  nodes_.reserve(2 * leaves.size() - 1);
  build(leaves, 0, leaves.size());
  place_of_leaf_.resize(names);
  for (const TreeLeaf& leaf : leaves) {
    place_of_leaf_[leaf.index] = static_cast<std::uint32_t>(leaf_of_place_.size());
    leaf_of_place_.push_back(leaf.index);
  }
}

void EmitterTree::build(std::vector<TreeLeaf>& leaves, std::size_t begin, std::size_t end) {
  nodes_.push_back(node_of(&leaves[begin], &leaves[begin] + (end - begin)));
  if (end - begin == 1) return;
  Vec3 lower = center(leaves[begin]), upper = lower;
  for (std::size_t i = begin; i < end; ++i) {
    lower = glm::min(lower, center(leaves[i]));
    upper = glm::max(upper, center(leaves[i]));
  }
  const Vec3 extent = upper - lower;
  const int longest = extent.x >= extent.y && extent.x >= extent.z ? 0
                      : extent.y >= extent.z                       ? 1
                                                                   : 2;
  const std::size_t half = middle(begin, end);
  const auto at = [&](std::size_t i) { return leaves.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end), [&](const TreeLeaf& a, const TreeLeaf& b) {
    const double x = center(a)[longest], y = center(b)[longest];
    return x < y || (x == y && a.index < b.index);
  });
  build(leaves, begin, half);
  build(leaves, half, end);
}

EmitterTree::Node EmitterTree::node_of(const TreeLeaf* begin, const TreeLeaf* end) const {
  Node node;
  Vec3 lower = begin->lower, upper = begin->upper, sum(0);
  double power = 0;
  bool two_sided = false;
  for (const TreeLeaf* leaf = begin; leaf != end; ++leaf) {
    lower = glm::min(lower, leaf->lower);
    upper = glm::max(upper, leaf->upper);
    sum += leaf->power * leaf->normal;
    power += leaf->power;
    two_sided = two_sided || leaf->two_sided;
  }
  node.center = Vec3f(0.5 * (lower + upper) - center_);
  node.radius = static_cast<float>(0.5 * glm::length(upper - lower) * (1 + 1e-6));
  node.power = static_cast<float>(power);
  if (two_sided || !(glm::dot(sum, sum) > 0.0)) return node;
  const Vec3 axis = glm::normalize(sum);
  double spread = 1;
  for (const TreeLeaf* leaf = begin; leaf != end; ++leaf) {
    spread = std::min(spread, glm::dot(axis, leaf->normal));
  }
  node.axis = Vec3f(axis);
  node.spread = static_cast<float>(std::max(-1.0, spread - 1e-6));
  return node;
}

// The most that the node's power could bring: as if all of it were seen at the largest cosines that any
// place and normal of it may have; but not nearer than it is large.
float EmitterTree::importance(const Node& node, const Local& receiver) {
  constexpr float least_distance = 1e-30F;
  const Vec3f away = receiver.place - node.center;
  const float squared = glm::dot(away, away), radius2 = node.radius * node.radius;
  const float weight = node.power / std::max(std::max(squared, radius2), least_distance);
  if (squared <= radius2) return weight;
  const float inverse = 1.0F / std::sqrt(squared);
  const float sin_cover = node.radius * inverse, cos_cover = sine(sin_cover);
  float cosines = 1;
  if (receiver.faces) {
    const float cosine = -glm::dot(receiver.facing, away) * inverse;
    cosines = largest_cosine(cosine, sine(cosine), cos_cover, sin_cover);
  }
  if (node.spread <= -1.0F) return weight * cosines;
  const float cos_axis = std::clamp(glm::dot(node.axis, away) * inverse, -1.0F, 1.0F);
  if (cos_axis >= node.spread) return weight * cosines;
  const float sin_axis = sine(cos_axis), sin_spread = sine(node.spread);
  const float cos_off = cos_axis * node.spread + sin_axis * sin_spread;
  const float sin_off = std::max(0.0F, sin_axis * node.spread - cos_axis * sin_spread);
  return weight * cosines * largest_cosine(cos_off, sin_off, cos_cover, sin_cover);
}

EmitterTree::Local EmitterTree::localised(const Receiver& receiver) const {
  return {Vec3f(receiver.place - center_), receiver.facing, receiver.facing != Vec3f(0)};
}

double EmitterTree::first_chance(std::size_t node, std::size_t left, const Local& receiver) const {
  const auto first = static_cast<double>(importance(nodes_[node + 1], receiver));
  const auto second = static_cast<double>(importance(nodes_[node + 2 * left], receiver));
  const double sum = first + second;
  return sum > 0.0 ? first / sum : -1.0;
}

EmitterTree::Chosen EmitterTree::choose(const Receiver& receiver, double u) const {
  const Local local = localised(receiver);
  std::size_t node = 0, begin = 0, end = leaf_of_place_.size();
  double chance = 1;
  while (end - begin > 1) {
    const std::size_t half = middle(begin, end), left = half - begin;
    const double first = first_chance(node, left, local);
    if (first < 0.0) return {};
    if (u < first) {
      u = std::min(u / first, 1.0 - 0x1p-53);
      chance *= first;
      node += 1;
      end = half;
    } else {
      u = std::min((u - first) / (1.0 - first), 1.0 - 0x1p-53);
      chance *= 1.0 - first;
      node += 2 * left;
      begin = half;
    }
  }
  return {leaf_of_place_[begin], chance};
}

double EmitterTree::chance(const Receiver& receiver, std::uint32_t leaf) const {
  const Local local = localised(receiver);
  const std::size_t wanted = place_of_leaf_[leaf];
  std::size_t node = 0, begin = 0, end = leaf_of_place_.size();
  double chance = 1;
  while (end - begin > 1) {
    const std::size_t half = middle(begin, end), left = half - begin;
    const double first = first_chance(node, left, local);
    if (first < 0.0) return 0.0;
    const bool is_first = wanted < half;
    chance *= is_first ? first : 1.0 - first;
    node += is_first ? 1 : 2 * left;
    (is_first ? end : begin) = half;
  }
  return chance;
}

}  // namespace restframe
