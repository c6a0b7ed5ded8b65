#include <fmt/format.h>

#include "importers/input_file.h"
#include "importers/scene_file.h"

namespace restframe {
namespace {

std::size_t stored_triangles(const std::vector<Mesh>& meshes) {
  std::size_t triangles = 0;
  for (const Mesh& mesh : meshes) triangles += mesh.triangles.size();
  return triangles;
}

// What is said of a scene as a whole is said by the scene file.
void warn_of_scene(const AssetAuthoring& said, SceneFile& file) {
  if (!said.scene) return;
  file.warnings.push_back(file.faults.located(
      said.scene->at, "is left out: the scene file says it, which names this asset"));
}

bool within_limit(std::size_t triangles, const SceneFile& file, TextPosition at,
                  const Reporter& report) {
  if (triangles <= file.limits.triangles) return true;
  report(at, fmt::format("the scene has {} triangles up to here, must have at most {}", triangles,
                         file.limits.triangles));
  return false;
}

// Adds what `load` returns, unless the scene has it under `key` already; its file, if it has one,
// lies at `path`. Faults are reported at `at`. Nothing is loaded that is known to have too many
// triangles: `expected` of them at least.
template <class Load>
std::optional<int> shared_asset(SceneFile& file, TextPosition at, const std::string& key,
                                const Path& path, const Reporter& report, std::size_t expected,
                                const Load& load) {
  const auto known = file.asset_of_key.find(key);
  if (known != file.asset_of_key.end()) return known->second;
  if (!within_limit(file.triangles + expected, file, at, report)) return std::nullopt;
  try {
    Asset asset = load();
    file.triangles += stored_triangles(asset.meshes);
    if (!within_limit(file.triangles, file, at, report)) return std::nullopt;
    add_scene_asset(std::move(asset), path, file);
    warn_of_scene(file.authoring.back(), file);
  } catch (const InputError& error) {
    file.faults.add(at, error);
    return std::nullopt;
  }
  return file.asset_of_key[key] = static_cast<int>(file.assets.size()) - 1;
}

std::optional<int> read_asset_file(TableReader& object, SceneFile& file) {
  const std::optional<std::string> name = object.text("asset");
  if (!name) return std::nullopt;
  const TextPosition at = object.place("asset");
  const Path path = file.path.parent_path() / Path(*name);
  if (const auto fault = input_file_fault(path)) {
    object.report(at, fmt::format("asset \"{}\": {}", *name, *fault));
    return std::nullopt;
  }
  std::error_code ignored;
  const Path canonical = std::filesystem::weakly_canonical(path, ignored);
  return shared_asset(file, at, "file " + canonical.string(), path, object.report, 0, [&] {
    Asset asset = load_asset(path, file.limits, file.warnings);
    add_asset_sources(file.scene, *name, path, asset);
    return asset;
  });
}

void read_cells(TableReader& table, LatticeSettings& settings) {
  const ConfigValue* value = table.find("cells");
  if (!value) return;
  const auto* array = std::get_if<ConfigArray>(&value->data);
  if (!array || array->size() != 3) {
    table.report(value->at, "cells must be three whole numbers [x, y, z]");
    return;
  }
  const auto count = [&](std::size_t i) {
    const std::string what = fmt::format("cells[{}]", i);
    return static_cast<int>(
        read_whole_number((*array)[i], what, 1, 10'000, table.report).value_or(1));
  };
  settings.cells_x = count(0);
  settings.cells_y = count(1);
  settings.cells_z = count(2);
}

// Reports the generator's own faults at the table's place; true if there are none.
bool accepted(const std::vector<std::string>& faults, TextPosition at, const Reporter& report) {
  for (const std::string& fault : faults) report(at, fault);
  return faults.empty();
}

std::optional<int> read_lattice(TableReader& object, SceneFile& file) {
  const ConfigTable* table = object.table("lattice");
  if (!table) return std::nullopt;
  TableReader reader(*table, {file.faults, object.report.name + ": lattice"});
  LatticeSettings settings;
  read_cells(reader, settings);
  settings.pitch = reader.number("pitch", above(0)).value_or(settings.pitch);
  settings.ball_radius = reader.number("ball", above(0)).value_or(settings.ball_radius);
  settings.rod_radius = reader.number("rod", above(0)).value_or(settings.rod_radius);
  settings.fineness = reader.integer("fineness", 0, 8).value_or(settings.fineness);
  const bool flat = reader.choice("instances", {"nodes", "none"}).value_or(0) == 1;
  reader.finish();
  if (!accepted(lattice_faults(settings, flat), table->at, reader.report)) return std::nullopt;
  if (const auto parts = lattice_parts(settings); !flat && parts > file.limits.nodes) {
    reader.report(table->at,
                  fmt::format("{} balls and rods, the limit is {}; --max-nodes raises it", parts,
                              file.limits.nodes));
    return std::nullopt;
  }
  const std::size_t expected =
      flat ? lattice_triangles(settings) : ball_triangles(settings.fineness);
  const std::string key = fmt::format(
      "lattice {} {} {} {} {} {} {} {}", settings.cells_x, settings.cells_y, settings.cells_z,
      settings.pitch, settings.ball_radius, settings.rod_radius, settings.fineness, flat);
  return shared_asset(file, table->at, key, {}, reader.report, expected,
                      [&] { return make_lattice(settings, flat); });
}

std::optional<int> read_sphere(TableReader& object, SceneFile& file) {
  const ConfigTable* table = object.table("sphere");
  if (!table) return std::nullopt;
  TableReader reader(*table, {file.faults, object.report.name + ": sphere"});
  BallSettings settings;
  settings.radius = reader.number("radius", above(0)).value_or(settings.radius);
  settings.fineness = reader.integer("fineness", 0, 10).value_or(settings.fineness);
  reader.finish();
  if (!accepted(ball_faults(settings), table->at, reader.report)) return std::nullopt;
  const std::string key = fmt::format("sphere {} {}", settings.radius, settings.fineness);
  return shared_asset(file, table->at, key, {}, reader.report, ball_triangles(settings.fineness),
                      [&] { return make_sphere_asset(settings); });
}

}  // namespace

std::optional<int> read_asset(TableReader& object, SceneFile& file) {
  const std::vector<std::string> kinds = {"asset", "lattice", "sphere"};
  const std::optional<std::string> kind = object.one_of(kinds);
  std::optional<int> asset;
  if (!kind) {
    object.report(object.place(), "must have an asset, a lattice or a sphere");
  } else if (*kind == "asset") {
    asset = read_asset_file(object, file);
  } else {
    asset = *kind == "lattice" ? read_lattice(object, file) : read_sphere(object, file);
  }
  if (!asset) file.names_complete = false;
  return asset;
}

}  // namespace restframe
