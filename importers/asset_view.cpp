#include "importers/asset_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "importers/scene_file_camera.h"
#include "importers/scene_file_light.h"
#include "scene/message.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

// A node and what carries it.
struct Mount {
  int object = 0;
  bool carried = false;    // by a node of a motion of its own
  Vec3 offset{0};          // from the object's origin, light-seconds
  Vec3 position{0};        // in the asset
  Vec3 forward{0}, up{0};  // 0 where the node's transform leaves them open
};

Vec3 turned(const Mat4& object_from_asset, const Vec3& direction) {
  return direction == Vec3(0) ? direction : glm::normalize(Mat3(object_from_asset) * direction);
}

Mount mount_of(int node, const AssetObjects& objects, const SceneFile& file) {
  const auto whole = static_cast<std::size_t>(objects.whole);
  const auto asset = static_cast<std::size_t>(file.object_materials[whole].asset);
  const AssetAuthoring& said = file.authoring[asset];
  const Mat4& object_from_asset = file.object_from_asset[whole];
  const NodePose pose = pose_of(file.assets[asset].tree.nodes[static_cast<std::size_t>(node)]);
  Mount mount;
  mount.object = objects.whole;
  mount.position = pose.position;
  mount.forward = turned(object_from_asset, pose.forward);
  mount.up = turned(object_from_asset, pose.up);
  Vec3 origin(0);
  const int owner = said.owners.empty() ? -1 : said.owners[static_cast<std::size_t>(node)];
  if (const auto moving = objects.of_motion.find(owner); moving != objects.of_motion.end()) {
    mount.object = moving->second;
    mount.carried = true;
    origin = said.motions[static_cast<std::size_t>(owner)].origin;
  }
  mount.offset = Vec3(object_from_asset * glm::dvec4(pose.position - origin, 1));
  return mount;
}

// Calls body(node, index) for the nodes that have one, a camera or a light.
template <class Body>
void for_each_with(int AssetNode::*what, const AssetTree& tree, const NodeRanges& nodes,
                   const Body& body) {
  for (const NodeRange& range : nodes) {
    for (int node = range.begin; node < range.end; ++node) {
      const int index = tree.nodes[static_cast<std::size_t>(node)].*what;
      if (index >= 0) body(node, index);
    }
  }
}

std::vector<int> camera_nodes(const AssetTree& tree, const NodeRanges& among) {
  std::vector<int> nodes;
  for_each_with(&AssetNode::camera, tree, among, [&](int node, int index) {
    const AssetNode& it = tree.nodes[static_cast<std::size_t>(node)];
    const bool has_direction = pose_of(it).forward != Vec3(0);
    if (tree.cameras[static_cast<std::size_t>(index)].is_perspective && has_direction) {
      nodes.push_back(node);
    }
  });
  return nodes;
}

const AssetCamera& camera_at(const AssetTree& tree, int node) {
  return tree.cameras[static_cast<std::size_t>(tree.nodes[static_cast<std::size_t>(node)].camera)];
}

// By the name of its node or its own.
std::optional<int> named_camera(TableReader& root, const AssetTree& tree,
                                const std::vector<int>& nodes) {
  const auto name = root.text("camera");
  if (!name) return std::nullopt;
  std::vector<std::string> known;
  for (const int node : nodes) {
    known.push_back(node_name(tree, node));
    if (known.back() == *name) return node;
  }
  for (const int node : nodes) {
    known.push_back(camera_at(tree, node).name);
    if (known.back() == *name) return node;
  }
  root.report(root.place("camera"), fmt::format("there is no camera \"{}\", the nearest is \"{}\"",
                                                *name, nearest(*name, known)));
  return std::nullopt;
}

CameraStart camera_start(int node, const AssetTree& tree, const AssetObjects& objects,
                         const SceneFile& file) {
  const Mount mount = mount_of(node, objects, file);
  const Object& object = file.scene.objects[static_cast<std::size_t>(mount.object)];
  CameraStart start;
  start.direction = mount.forward;
  start.up = mount.up;
  start.vertical_fov = camera_at(tree, node).vertical_fov;
  start.position = mount.offset;
  if (mount.carried) start.carried = at_rest_on(object, mount.offset, 0.0);
  return start;
}

// The keys of both tables; none may be in both.
ConfigTable joined(const ConfigTable& first, const ConfigTable& second, SceneFile& file) {
  ConfigTable table = first;
  for (const ConfigEntry& entry : second.entries) {
    for (const ConfigEntry& known : first.entries) {
      if (known.key != entry.key) continue;
      file.faults.add(entry.key_at,
                      fmt::format("camera: {} is there twice: by the camera itself "
                                  "({}), too",
                                  entry.key, file.faults.place_text(known.key_at.place)));
    }
    table.entries.push_back(entry);
  }
  return table;
}

LightStart light_start(int node, int index, const AssetTree& tree, const AssetObjects& objects,
                       const SceneFile& file) {
  const Mount mount = mount_of(node, objects, file);
  const Object& object = file.scene.objects[static_cast<std::size_t>(mount.object)];
  LightStart start;
  start.light = tree.lights[static_cast<std::size_t>(index)];
  start.light.name = objects.prefix + node_name(tree, node);
  start.light.worldline = at_rest_on(object, mount.offset, clock_at_reference(object));
  start.light.clock = object.clock;
  start.light.frame_clock = object.frame_clock;
  if (mount.forward != Vec3(0)) start.light.direction = mount.forward;
  const Object& whole = file.scene.objects[static_cast<std::size_t>(objects.whole)];
  start.carried = mount.carried || whole.worldline.velocity.gamma() > 1;
  start.position = mount.position;
  start.object = objects.whole;
  start.object_from_asset = file.object_from_asset[static_cast<std::size_t>(objects.whole)];
  return start;
}

bool has_open_direction(const Light& light, const ConfigTable& said, const AssetNode& node) {
  const bool needs_one = light.kind == LightKind::spot || light.kind == LightKind::sun;
  const bool says_one = std::any_of(said.entries.begin(), said.entries.end(),
                                    [](const ConfigEntry& e) { return e.key == "direction"; });
  return needs_one && !says_one && pose_of(node).forward == Vec3(0);
}

}  // namespace

void read_asset_camera(TableReader& root, const AssetObjects& objects, SceneFile& file) {
  const auto asset = static_cast<std::size_t>(
      file.object_materials[static_cast<std::size_t>(objects.whole)].asset);
  const AssetTree& tree = file.assets[asset].tree;
  const std::vector<int> nodes = camera_nodes(tree, objects.nodes);
  const ConfigValue* value = root.find("camera");
  const bool is_named = value && std::holds_alternative<std::string>(value->data);
  const ConfigTable* table = is_named ? nullptr : root.table("camera");
  std::optional<int> node = is_named ? named_camera(root, tree, nodes) : std::nullopt;
  if (!is_named && !nodes.empty()) node = nodes.front();
  if (!node) {
    if (table) read_camera_table(*table, std::nullopt, file);
    return;
  }
  const auto& said = file.authoring[asset].cameras;
  const auto own = said.find(tree.nodes[static_cast<std::size_t>(*node)].camera);
  ConfigTable all = own == said.end() ? ConfigTable{} : own->second;
  if (table) all = joined(all, *table, file);
  read_camera_table(all, camera_start(*node, tree, objects, file), file);
}

bool add_asset_lights(const AssetObjects& objects, SceneFile& file) {
  const auto asset = static_cast<std::size_t>(
      file.object_materials[static_cast<std::size_t>(objects.whole)].asset);
  const AssetTree& tree = file.assets[asset].tree;
  bool has_some = false;
  const std::optional<Path> before =
      std::exchange(file.asset_being_read, file.authoring[asset].path);
  for_each_with(&AssetNode::light, tree, objects.nodes, [&](int node, int index) {
    const auto& said = file.authoring[asset].lights;
    const auto own = said.find(index);
    const ConfigTable table = own == said.end() ? ConfigTable{} : own->second;
    const LightStart start = light_start(node, index, tree, objects, file);
    if (has_open_direction(start.light, table, tree.nodes[static_cast<std::size_t>(node)])) {
      file.warnings.push_back(fmt::format("{}:{}: light {} is left out: its transform is singular",
                                          file.assets[asset].name, place_of(tree, node),
                                          quote(start.light.name)));
      return;
    }
    read_light(table, &start, file);
    has_some = true;
  });
  file.asset_being_read = before;
  return has_some;
}

}  // namespace restframe
