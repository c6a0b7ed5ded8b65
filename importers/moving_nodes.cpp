#include "importers/moving_nodes.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

namespace restframe {
namespace {

constexpr std::size_t most_slots = 50'000'000;  // of all moving nodes of an asset

void add(NodeRanges& ranges, int node) {
  if (!ranges.empty() && ranges.back().end == node) {
    ++ranges.back().end;
  } else {
    ranges.push_back({node, node + 1});
  }
}

// The rotation of a matrix that turns, scales evenly and moves.
Mat3 rotation_of(const Mat4& matrix) {
  Mat3 rotation(matrix);
  for (int axis = 0; axis < 3; ++axis) rotation[axis] = glm::normalize(rotation[axis]);
  return rotation;
}

// The name, or with a number that makes it one of its own. `numbers`: the last ones given.
std::string claim_name(const std::string& wanted, int object, std::map<std::string, int>& numbers,
                       SceneFile& file) {
  std::string name = wanted;
  int& number = numbers.emplace(wanted, 1).first->second;
  while (!file.object_of_name.emplace(name, object).second) {
    name = fmt::format("{}_{}", wanted, ++number);
  }
  return name;
}

Object moving_object(const NodeMotion& motion, const Object& base, const Mat4& object_from_asset) {
  Object object;
  object.worldline = in_world(motion.own.worldline, base, object_from_asset);
  object.clock = motion.has_clock ? motion.own.clock : base.clock;
  object.frame_clock = motion.has_clock ? motion.own.frame_clock : base.frame_clock;
  return object;
}

bool fits(const AssetAuthoring& said, const SceneAsset& asset, std::size_t count, SceneFile& file) {
  if (count * static_cast<std::size_t>(slot_count(asset)) <= most_slots) return true;
  file.faults.add(said.motions.front().at,
                  fmt::format("{} nodes that move by themselves, times {} materials, are more than "
                              "{}",
                              count, slot_count(asset), most_slots));
  return false;
}

}  // namespace

NodeGroups grouped(const AssetAuthoring& said, const NodeRanges& nodes) {
  if (said.owners.empty()) return {nodes, {}};
  NodeGroups groups;
  for (const NodeRange& range : nodes) {
    for (int node = range.begin; node < range.end; ++node) {
      const int owner = said.owners[static_cast<std::size_t>(node)];
      add(owner < 0 ? groups.resting : groups.moving[owner], node);
    }
  }
  return groups;
}

Worldline in_world(const Worldline& in_asset, const Object& base, const Mat4& object_from_asset) {
  Worldline worldline = in_asset;
  const Vec3 place(object_from_asset * glm::dvec4(in_asset.reference.x, 1));
  worldline.reference.x = base.worldline.reference.x + place;
  worldline.reference.t += base.worldline.reference.t;
  worldline.velocity =
      Velocity::from_gamma_beta(rotation_of(object_from_asset) * in_asset.velocity.gamma_beta());
  return worldline;
}

std::map<int, int> add_moving_nodes(int base, const std::map<int, NodeRanges>& moving,
                                    const std::string& prefix, SceneFile& file) {
  if (moving.empty()) return {};
  const auto base_index = static_cast<std::size_t>(base);
  const Mat4 object_from_asset = file.object_from_asset[base_index];
  ObjectMaterials materials = file.object_materials[base_index];
  const auto asset_index = static_cast<std::size_t>(materials.asset);
  const SceneAsset& asset = file.assets[asset_index];
  const AssetAuthoring& said = file.authoring[asset_index];
  std::map<int, int> added;
  if (!fits(said, asset, moving.size(), file)) return added;
  materials.part_of = base;
  materials.slots.clear();
  std::map<std::string, int> numbers;
  for (const auto& [index, nodes] : moving) {
    const NodeMotion& motion = said.motions[static_cast<std::size_t>(index)];
    const Mat4 from_asset = glm::translate(object_from_asset, -motion.origin);
    Object object = moving_object(motion, file.scene.objects[base_index], object_from_asset);
    object.parts = placed_parts(asset, nodes, from_asset);
    object.whole = file.scene.objects[base_index].name;
    if (wants_part_names(file.scene) && has_many_nodes(asset, nodes)) {
      name_parts(asset, nodes, prefix, object);
    }
    added[index] = static_cast<int>(file.scene.objects.size());
    object.name =
        claim_name(prefix + node_name(asset.tree, motion.node), added[index], numbers, file);
    file.scene.objects.push_back(std::move(object));
    file.object_from_asset.push_back(object_from_asset);
    file.object_materials.push_back(materials);
  }
  return added;
}

}  // namespace restframe
