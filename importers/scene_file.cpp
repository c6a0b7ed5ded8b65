#include "importers/scene_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "importers/asset_placing.h"
#include "importers/file_hash.h"
#include "importers/input_file.h"
#include "importers/material_assignment.h"
#include "importers/refraction_check.h"
#include "importers/toml_text.h"
#include "scene/file_names.h"

namespace restframe {
namespace {

constexpr std::size_t largest_scene_file = 16'000'000;

// What a scene built of these files must pass all the same; what a file could say is reported with
// its position before.
void check_whole(const Scene& scene, const Path& path) {
  std::vector<std::string> faults = validate(scene);
  if (faults.empty()) return;
  for (std::string& fault : faults) fault = path.string() + ": " + fault;
  throw InputError(std::move(faults));
}

Scene load_scene_file(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  SceneFile file(path, limits, warnings);
  const std::string text =
      read_input_file(path, std::min(limits.json_bytes, largest_scene_file), path.string());
  const ConfigTable table = parse_toml(text, path.string());
  add_source(file.scene, path.filename().string(), path);
  TableReader root(table, {file.faults, ""});
  read_settings(root, file);
  read_objects(root, file);
  read_camera(root, file);
  read_lights(root, file);
  const std::vector<MaterialChange> changes = read_material_changes(root, file);
  root.finish();
  if (file.names_complete) assign_materials(changes, file);
  file.faults.throw_any();
  add_lights(std::move(file.asset_lights), file.scene);
  drop_unused_meshes(file.scene);
  check_whole(file.scene, path);
  warn_of_open_glass(file.scene, path, warnings);
  return std::move(file.scene);
}

// The camera and the lights that the asset places, as they are at rest.
void add_camera_and_lights(const SceneAsset& asset, const Object& object, const Path& path,
                           Scene& scene, Warnings& warnings) {
  const NodeRanges nodes = nodes_of_default_scene(asset.tree);
  const PlacedNodes placed{asset.tree, nodes, object, Mat4(1)};
  std::vector<Light> lights;
  for (PlacedLight& each : placed_lights(placed, path.string(), warnings)) {
    lights.push_back(std::move(each.light));
  }
  add_lights(std::move(lights), scene);
  const std::optional<Camera> camera = placed_camera(placed);
  scene.camera_given = camera.has_value();
  if (camera) scene.camera = *camera;
}

// The asset as one object at rest at the world's origin.
Scene load_asset_scene(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  Scene scene;
  Asset read = load_asset(path, limits, warnings);
  add_asset_sources(scene, path.filename().string(), path, read);
  SceneAsset asset = add_asset(scene, std::move(read));
  Object object;
  object.name = path.stem().string();
  object.parts = placed_parts(asset, nodes_of_default_scene(asset.tree), Mat4(1));
  scene.materials = std::move(asset.materials);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    object.materials.push_back(static_cast<int>(i));
  }
  add_camera_and_lights(asset, object, path, scene, warnings);
  scene.objects.push_back(std::move(object));
  drop_unused_meshes(scene);
  std::string stem = path.stem().string();
  std::replace(stem.begin(), stem.end(), '#', '_');
  scene.output.path = fmt::format("out/{}.####.exr", stem);
  check_whole(scene, path);
  warn_of_open_glass(scene, path, warnings);
  return scene;
}

}  // namespace

void add_source(Scene& scene, const std::string& name, const Path& path) {
  const auto has_name = [&](const SourceFile& source) { return source.name == name; };
  if (std::any_of(scene.sources.begin(), scene.sources.end(), has_name)) return;
  scene.sources.push_back({name, file_hash(path)});
}

void add_asset_sources(Scene& scene, const std::string& name, const Path& path,
                       const Asset& asset) {
  add_source(scene, name, path);
  const Path folder = std::filesystem::canonical(folder_of(path));
  for (const Path& file : asset.files) {
    const Path its_name = Path(name).parent_path() / file.lexically_relative(folder);
    add_source(scene, its_name.generic_string(), file);
  }
}

Scene load_scene(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  const bool is_scene_file = lower_extension(path) == ".toml";
  return is_scene_file ? load_scene_file(path, limits, warnings)
                       : load_asset_scene(path, limits, warnings);
}

}  // namespace restframe
