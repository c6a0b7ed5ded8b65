#include "importers/asset_placing.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "scene/message.h"

namespace restframe {
namespace {

// Calls body(index, node) for the nodes of the ranges.
template <class Body>
void for_each_node(const PlacedNodes& placed, const Body& body) {
  for (const NodeRange& range : placed.nodes) {
    for (int i = range.begin; i < range.end; ++i) {
      body(i, placed.tree.nodes[static_cast<std::size_t>(i)]);
    }
  }
}

NodePose pose_on_object(const PlacedNodes& placed, const AssetNode& node) {
  AssetNode in_object;
  in_object.asset_from_node = placed.object_from_asset * node.asset_from_node;
  return pose_of(in_object);
}

std::string name_of(const PlacedNodes& placed, const AssetNode& node, const Light& light) {
  std::string own = node.name.empty() ? light.name : node.name;
  if (own.empty()) own = fmt::format("light_{}", node.light);
  return placed.object.name + "/" + own;
}

bool needs_direction(const Light& light) {
  return light.kind == LightKind::spot || light.kind == LightKind::sun;
}

Light light_at(const PlacedNodes& placed, const AssetNode& node, const NodePose& pose) {
  const Object& object = placed.object;
  Light light = placed.tree.lights[static_cast<std::size_t>(node.light)];
  light.name = name_of(placed, node, light);
  light.worldline = at_rest_on(object, pose.position, clock_at_reference(object));
  light.clock = object.clock;
  light.frame_clock = object.frame_clock;
  if (needs_direction(light)) light.direction = pose.forward;
  return light;
}

}  // namespace

std::vector<PlacedLight> placed_lights(const PlacedNodes& placed, const std::string& file,
                                       Warnings& warnings) {
  std::vector<PlacedLight> lights;
  for_each_node(placed, [&](int index, const AssetNode& node) {
    if (node.light < 0) return;
    const NodePose pose = pose_on_object(placed, node);
    PlacedLight added{light_at(placed, node, pose), index};
    if (needs_direction(added.light) && pose.forward == Vec3(0)) {
      warnings.push_back(fmt::format("{}:{}: light {} is left out: its transform is singular", file,
                                     place_of(placed.tree, index), quote(added.light.name)));
      return;
    }
    lights.push_back(std::move(added));
  });
  return lights;
}

std::optional<Camera> placed_camera(const PlacedNodes& placed) {
  std::optional<Camera> camera;
  for_each_node(placed, [&](int, const AssetNode& node) {
    if (camera || node.camera < 0) return;
    const AssetCamera& source = placed.tree.cameras[static_cast<std::size_t>(node.camera)];
    const NodePose pose = pose_on_object(placed, node);
    if (!source.is_perspective || pose.forward == Vec3(0)) return;
    camera.emplace();
    camera->motion = at_rest_on(placed.object, pose.position, 0.0);
    camera->aim = AimDirection{pose.forward};
    camera->up = pose.up;
    camera->vertical_fov = source.vertical_fov;
  });
  return camera;
}

void add_lights(std::vector<Light> lights, Scene& scene) {
  std::set<std::string> names;
  for (const Light& light : scene.lights) names.insert(light.name);
  std::map<std::string, int> used;  // numbers behind a name
  for (Light& light : lights) {
    std::string name = light.name;
    while (!names.insert(name).second)
      name = fmt::format("{}_{}", light.name, ++used[light.name] + 1);
    light.name = std::move(name);
    scene.lights.push_back(std::move(light));
  }
}

}  // namespace restframe
