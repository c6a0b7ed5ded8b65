#include "importers/scene_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "importers/asset_view.h"
#include "importers/file_hash.h"
#include "importers/input_file.h"
#include "importers/material_assignment.h"
#include "importers/refraction_check.h"
#include "importers/toml_text.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t largest_scene_file = 16'000'000;

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
  for (const AssetObjects& objects : file.lit_objects) add_asset_lights(objects, file);
  const std::vector<MaterialChange> changes = read_material_changes(root, file);
  root.finish();
  if (file.names_complete) assign_materials(changes, file);
  file.faults.throw_any();
  drop_unused_meshes(file.scene);
  check_whole(file.scene, path);
  warn_of_open_glass(file.scene, path, warnings);
  return std::move(file.scene);
}

}  // namespace

void check_whole(const Scene& scene, const Path& path) {
  std::vector<std::string> faults = validate(scene);
  if (faults.empty()) return;
  for (std::string& fault : faults) fault = path.string() + ": " + fault;
  throw InputError(std::move(faults));
}

int add_scene_asset(Asset asset, const Path& path, SceneFile& file) {
  file.assets.push_back(add_asset(file.scene, std::move(asset)));
  file.authoring.push_back(read_asset_extras(file.assets.back(), path, file));
  return static_cast<int>(file.assets.size()) - 1;
}

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

Scene load_scene(const Path& path, const ImportLimits& limits, Warnings& warnings,
                 const std::optional<std::string>& variant) {
  if (lower_extension(path) != ".toml") return load_asset_scene(path, limits, warnings, variant);
  if (variant) {
    throw InputError(
        fmt::format("{}: variant {} goes with an asset; in a scene file, write it as "
                    "`variant` in [[object]]",
                    path.string(), quote(*variant)));
  }
  return load_scene_file(path, limits, warnings);
}

}  // namespace restframe
