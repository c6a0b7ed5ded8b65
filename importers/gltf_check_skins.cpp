// Skins: joints that are nodes, a matrix for each, and meshes that say how they hang on them.

#include <algorithm>

#include "importers/gltf_check.h"
#include "importers/gltf_layout.h"

namespace restframe {
namespace {

void check_joints(const Place& skin, const Place& document) {
  skin.require_member("joints");
  const Place joints = skin.member("joints");
  joints.require_array();
  if (joints.size() == 0) joints.fault("is empty");
  const std::size_t nodes = count_of(document, "nodes");
  std::vector<std::uint64_t> sorted;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Place joint = joints.element(i);
    if (nodes == 0) joint.fault("there are no nodes");
    sorted.push_back(joint.as_integer(0, nodes - 1));
  }
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) joints.fault("node " + std::to_string(*twice) + " is listed twice");
}

void check_skin(const Place& skin, const Place& document) {
  const std::int64_t matrices = skin.index("inverseBindMatrices", count_of(document, "accessors"));
  skin.index("skeleton", count_of(document, "nodes"));
  check_joints(skin, document);
  if (matrices < 0) return;
  const Place place = skin.member("inverseBindMatrices");
  const Json& accessor = accessor_at(document, matrices);
  if (accessor["type"] != "MAT4" || accessor["componentType"] != component_f32) {
    place.fault("must be MAT4 of floats");
  }
  const auto count = accessor["count"].get<std::uint64_t>();
  const std::size_t joints = skin.value()["joints"].size();
  if (count < joints) {
    place.fault("has " + std::to_string(count) + " matrices for " + std::to_string(joints) +
                " joints");
  }
}

bool is_skinned(const Json& mesh) {
  const auto has_joints = [](const Json& primitive) {
    return primitive["attributes"].contains("JOINTS_0");
  };
  return std::all_of(mesh["primitives"].begin(), mesh["primitives"].end(), has_joints);
}

}  // namespace

void check_skins(const Place& document) {
  for_each_object(document, "skins", [&](const Place& skin) { check_skin(skin, document); });
  std::vector<bool> skinned;
  for_each_object(document, "meshes",
                  [&](const Place& mesh) { skinned.push_back(is_skinned(mesh.value())); });
  std::size_t count = 0;
  for_each_object(document, "nodes", [&](const Place& node) {
    const std::int64_t mesh = node.index("mesh", skinned.size());
    if (node.index("skin", count_of(document, "skins")) < 0) return;
    if (mesh < 0) node.member("skin").fault("the node has no mesh");
    if (!skinned[static_cast<std::size_t>(mesh)]) {
      node.member("skin").fault("mesh " + std::to_string(mesh) +
                                " has a primitive without JOINTS_0 and WEIGHTS_0");
    }
    ++count;
  });
  if (count == 0) return;
  document.context().warn("/skins", "skins of " + std::to_string(count) +
                                        " nodes are not moved: read in its rest pose, with joints "
                                        "where their nodes stand");
}

}  // namespace restframe
