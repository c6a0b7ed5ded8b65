#pragma once

// The scene file, read section by section (design, section 5). Sections add to one SceneFile;
// lengths are divided by the scene's light_speed on the way in. Nothing throws but for memory
// and for too many faults: they are collected.

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "importers/importers.h"
#include "importers/scene_assets.h"
#include "importers/toml_reader.h"
#include "importers/value_rule.h"

namespace restframe {

// A name in the file that means a material.
struct MaterialReference {
  TextPosition at;
  std::string name;
};

// Where an object takes its materials from.
struct ObjectMaterials {
  int asset = -1;  // index into SceneFile::assets; -1: it could not be read
  std::optional<MaterialReference> all_slots;
  std::map<int, MaterialReference> slots;
};

struct SceneFile {
  SceneFile(Path file, const ImportLimits& import_limits, Warnings& import_warnings)
      : path(std::move(file)),
        limits(import_limits),
        warnings(import_warnings),
        faults(path.string()) {}

  Path path;
  const ImportLimits& limits;
  Warnings& warnings;
  FaultList faults;
  Scene scene;
  std::vector<SceneAsset> assets;
  std::size_t triangles = 0;  // of all assets
  std::map<std::string, int> object_of_name;
  std::map<std::string, int> asset_of_key;  // by canonical path, or by a generator's settings
  bool names_complete = true;  // else an asset or a [[material]] is lost: names can not be checked
  std::vector<ObjectMaterials> object_materials;  // one an object
  std::vector<Mat4> object_from_asset;            // likewise; the asset's units to light-seconds
};

// A property as a file gives it: constant, or an index into Scene::functions.
using Property = std::variant<TemporalValue, FunctionIndex>;

// What one [[material]] says.
struct MaterialChange {
  TextPosition at;
  std::string name;                         // exact, or a pattern in which * stands for anything
  std::optional<MaterialReference> object;  // only there
  std::optional<Property> base_color, metallic, roughness, emission, emission_strength, opacity,
      ior, transmission, attenuation_color, attenuation_distance;
  std::optional<bool> base_color_texture, unlit;
};

// [scene], [animation], [exposure], [render], [output]
void read_settings(TableReader& root, SceneFile& file);
void read_exposure(TableReader& root, SceneFile& file);
void read_objects(TableReader& root, SceneFile& file);
// After the objects, which they may name.
void read_camera(TableReader& root, SceneFile& file);
void read_lights(TableReader& root, SceneFile& file);
std::vector<MaterialChange> read_material_changes(TableReader& root, SceneFile& file);

// The asset, lattice or sphere that an object's table asks for, as an index into SceneFile::assets.
std::optional<int> read_asset(TableReader& object, SceneFile& file);

// The index of the object whose name stands under `key`.
std::optional<int> read_object_reference(TableReader& table, const std::string& key,
                                         const SceneFile& file);

// A point in the coordinates of an object's asset as it is placed, from the object's origin in
// light-seconds.
Vec3 object_point(const SceneFile& file, int object, const Vec3& point);

std::optional<Property> read_property(TableReader& table, const std::string& key,
                                      const ValueRule& rule, SceneFile& file);

// The function in the file that the table's `file` names: rows of a .csv, or the paper's intervals.
std::optional<TemporalFunction> read_function_file(TableReader& table,
                                                   const std::optional<double>& period,
                                                   const ValueRule& rule, SceneFile& file);

// [camera]'s `aperture`, `focus` and `rolling`.
void read_lens_and_rolling(TableReader& camera_table, double light_speed, Camera& camera);

// `velocity`, in fractions of c; at rest if it is not given.
Velocity read_velocity(TableReader& table);

// A vector of any length but zero, made one of length one.
std::optional<Vec3> read_direction(TableReader& table, const std::string& key);

// Notes a file that went into the scene. Throws InputError if it can not be read.
void add_source(Scene& scene, const std::string& name, const Path& path);
// Likewise an asset's file, and all that it was read from besides.
void add_asset_sources(Scene& scene, const std::string& name, const Path& path, const Asset& asset);

}  // namespace restframe
