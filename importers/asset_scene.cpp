// An asset in place of a scene file. Its nodes are the objects, its cameras and lights are there, and
// what the scene says of itself (glTF's `extras.restframe`) are the other tables of a scene file.

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "importers/asset_view.h"
#include "importers/material_assignment.h"
#include "importers/moving_nodes.h"
#include "importers/refraction_check.h"
#include "importers/scene_file_light.h"

namespace restframe {
namespace {

std::string default_output(const Path& path) {
  std::string stem = path.stem().string();
  std::replace(stem.begin(), stem.end(), '#', '_');
  return fmt::format("out/{}.####.exr", stem);
}

void refuse_objects(TableReader& root) {
  if (!root.has("object")) return;
  root.report(root.key_place("object"),
              "object goes with scene files only: the objects of an asset are its nodes");
}

// What rests, as one object at the world's origin, and every node that moves.
AssetObjects add_objects(const Path& path, int variant, SceneFile& file) {
  const SceneAsset& asset = file.assets[0];
  NodeRanges nodes = nodes_of_default_scene(asset.tree);
  const NodeGroups groups = grouped(file.authoring[0], nodes);
  const Mat4 object_from_asset = glm::scale(Mat4(1), Vec3(1 / file.scene.light_speed));
  Object object;
  object.name = path.stem().string();
  object.parts = placed_parts(asset, groups.resting, object_from_asset);
  if (wants_part_names(file.scene)) name_parts(asset, groups.resting, "", object);
  file.object_of_name.emplace(object.name, 0);
  file.scene.objects.push_back(std::move(object));
  file.object_from_asset.push_back(object_from_asset);
  ObjectMaterials materials;
  materials.asset = 0;
  materials.variant = variant;
  file.object_materials.push_back(materials);
  return {0, add_moving_nodes(0, groups.moving, "", file), "", std::move(nodes)};
}

// Where everything moves, nothing is left of the asset as a whole.
void drop_empty_whole(Scene& scene) {
  if (scene.objects.size() > 1 && scene.objects[0].parts.empty()) {
    scene.objects.erase(scene.objects.begin());
  }
}

int variant_of(const SceneAsset& asset, const std::optional<std::string>& name, const Path& path) {
  if (!name) return no_variant;
  try {
    return find_variant(asset, *name);
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

void read_all(const ConfigTable& said, const Path& path, int variant, SceneFile& file) {
  TableReader root(said, {file.faults, ""});
  read_settings(root, file);
  refuse_objects(root);
  const AssetObjects objects = add_objects(path, variant, file);
  read_asset_camera(root, objects, file);
  if (add_asset_lights(objects, file)) {
    const int place = file.faults.add_place(path.string() + ":/extensions/KHR_lights_punctual");
    warn_of_unused_lights({0, 0, place}, file);
  }
  read_lights(root, file);
  const std::vector<MaterialChange> changes = read_material_changes(root, file);
  root.finish();
  if (file.names_complete) assign_materials(changes, file);
}

}  // namespace

Scene load_asset_scene(const Path& path, const ImportLimits& limits, Warnings& warnings,
                       const std::optional<std::string>& variant) {
  SceneFile file(path, limits, warnings);
  file.asset_being_read = path;
  file.scene.output.path = default_output(path);
  Asset asset = load_asset(path, limits, warnings);
  add_asset_sources(file.scene, path.filename().string(), path, asset);
  add_scene_asset(std::move(asset), path, file);
  const int chosen = variant_of(file.assets[0], variant, path);
  read_all(file.authoring[0].scene.value_or(ConfigTable{}), path, chosen, file);
  file.faults.throw_any();
  drop_empty_whole(file.scene);
  drop_unused_meshes(file.scene);
  check_whole(file.scene, path);
  warn_of_open_glass(file.scene, path, warnings);
  return std::move(file.scene);
}

}  // namespace restframe
