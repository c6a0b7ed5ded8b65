#include "importers/scene_file.h"

#include <fmt/format.h>

#include <algorithm>

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
  check_whole(file.scene, path);
  warn_of_open_glass(file.scene, path, warnings);
  return std::move(file.scene);
}

int find_variant_of(const SceneAsset& asset, const std::string& name, const Path& path) {
  try {
    return find_variant(asset, name);
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

// The asset as one object at rest at the world's origin.
Scene load_asset_scene(const Path& path, const ImportLimits& limits, Warnings& warnings,
                       const std::optional<std::string>& variant_name) {
  Scene scene;
  Asset read = load_asset(path, limits, warnings);
  add_asset_sources(scene, path.filename().string(), path, read);
  SceneAsset asset = add_asset(scene, std::move(read));
  Object object;
  object.name = path.stem().string();
  object.parts = std::move(asset.parts);
  const int variant = variant_name ? find_variant_of(asset, *variant_name, path) : no_variant;
  for (int slot = 0; slot < slot_count(asset); ++slot) {
    object.materials.push_back(material_of_slot(asset, slot, variant));
  }
  scene.materials = std::move(asset.materials);
  scene.objects.push_back(std::move(object));
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
