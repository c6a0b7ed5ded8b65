#pragma once

// The scene file, read section by section (design, section 5). Sections add to one SceneFile;
// lengths are divided by the scene's light_speed on the way in. Nothing throws but for memory
// and for too many faults: they are collected.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "importers/asset_extras.h"
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
  int asset = -1;            // index into SceneFile::assets; -1: it could not be read
  int variant = no_variant;  // of that asset
  std::optional<MaterialReference> all_slots;
  std::map<int, MaterialReference> slots;
  int part_of =
      -1;  // the object that this one is a moving node of: its `slots` are this one's, too
};

// The objects that an asset is placed as.
struct AssetObjects {
  int whole = 0;                 // what has no motion of its own
  std::map<int, int> of_motion;  // those of its authoring's motions
  std::string prefix;            // of the names of its lights
  NodeRanges nodes;              // of the asset; those that are shown
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
  std::vector<AssetAuthoring> authoring;  // one an asset
  std::optional<Path> asset_being_read;   // its extras: what they name lies in its folder
  std::size_t triangles = 0;              // of all assets
  std::size_t placed_bytes = 0;           // of what objects take of their assets
  std::map<std::string, int> object_of_name;
  std::map<std::string, int> light_names;      // with the last number that made one of it
  std::map<std::string, int> asset_of_key;     // by canonical path, or by a generator's settings
  std::map<std::string, int> sky_map_of_path;  // canonical
  bool names_complete = true;  // else an asset or a [[material]] is lost: names can not be checked
  int object_tables = 0;       // [[object]]s so far
  std::vector<ObjectMaterials> object_materials;  // one an object
  std::vector<Mat4> object_from_asset;            // likewise; the asset's units to light-seconds
  std::vector<AssetObjects> lit_objects;          // whose assets' lights shine
};

// A property as a file gives it: constant, or an index into Scene::functions.
using Property = std::variant<TemporalValue, FunctionIndex>;

// What a light or a material says of its spectrum.
struct SpectrumChange {
  std::optional<Property> temperature;
  std::optional<std::vector<SpectrumPoint>> points;
  std::optional<std::vector<EmissionLine>> lines;

  bool any() const { return temperature || points || lines; }
};

// What one [[material]] says.
struct MaterialChange {
  TextPosition at;
  std::string name;                         // exact, or a pattern in which * stands for anything
  std::optional<MaterialReference> object;  // only there
  std::vector<std::pair<TemporalNumber Material::*, Property>> numbers;
  std::vector<std::pair<TemporalColor Material::*, Property>> colors;
  SpectrumChange spectrum;  // of its emission
  std::optional<bool> base_color_texture, thin_walled, unlit;
  std::optional<std::string> group;
};

// [scene], [animation], [exposure], [render], [output]
void read_settings(TableReader& root, SceneFile& file);
void read_exposure(TableReader& root, SceneFile& file);
void read_objects(TableReader& root, SceneFile& file);
// After the objects, which they may name.
void read_camera(TableReader& root, SceneFile& file);
void read_lights(TableReader& root, SceneFile& file);
std::vector<MaterialChange> read_material_changes(TableReader& root, SceneFile& file);
// What a material may say besides its name.
void read_material_properties(TableReader& material, MaterialChange& change, SceneFile& file);

// The asset, lattice or sphere that an object's table asks for, as an index into SceneFile::assets.
std::optional<int> read_asset(TableReader& object, SceneFile& file);

// The nodes of the asset that an object's table picks: of a scene, of names, without others.
NodeRanges read_nodes(TableReader& object, SceneAsset& asset);

// The index of the object whose name stands under `key`.
std::optional<int> read_object_reference(TableReader& table, const std::string& key,
                                         const SceneFile& file);

// A point in the coordinates of an object's asset as it is placed, from the object's origin in
// light-seconds.
Vec3 object_point(const SceneFile& file, int object, const Vec3& point);

// The name of a group of lights.
std::optional<std::string> read_group(TableReader& table);

std::optional<Property> read_property(TableReader& table, const std::string& key,
                                      const ValueRule& rule, SceneFile& file);

// The function in the file that the table's `file` names: rows of a .csv, or the paper's intervals.
std::optional<TemporalFunction> read_function_file(TableReader& table,
                                                   const std::optional<double>& period,
                                                   const ValueRule& rule, SceneFile& file);

// Where a file lies that a table names, at `at`; one from a stranger names only files beside it. Throws
// InputError if it names others.
Path named_path(const std::string& name, TextPosition at, const SceneFile& file);
// What that file is called from where the file of the scene lies.
std::string source_name(const std::string& name, const Path& path, const SceneFile& file);

// An environment's `file` and `rotation`.
void read_sky_map(TableReader& table, SceneFile& file, Light& light);

// [camera]'s `aperture`, `focus` and `rolling`.
void read_lens_and_rolling(TableReader& camera_table, double light_speed, Camera& camera);

// `velocity`, in fractions of c; at rest if it is not given.
Velocity read_velocity(TableReader& table);

// By degrees about the fixed axes: first x, then y, then z.
Mat4 rotation_matrix(const Vec3& degrees);

// A vector of any length but zero, made one of length one.
std::optional<Vec3> read_direction(TableReader& table, const std::string& key);

// Adds the asset to the scene with all that it says, and returns its index in SceneFile::assets.
int add_scene_asset(Asset asset, const Path& path, SceneFile& file);

// What a scene must pass however it was made. Throws InputError, the file's name before each fault.
void check_whole(const Scene& scene, const Path& path);

// An asset in place of a scene file: what it says of itself is the scene.
Scene load_asset_scene(const Path& path, const ImportLimits& limits, Warnings& warnings,
                       const std::optional<std::string>& variant);

// Notes a file that went into the scene. Throws InputError if it can not be read.
void add_source(Scene& scene, const std::string& name, const Path& path);
// Likewise an asset's file, and all that it was read from besides.
void add_asset_sources(Scene& scene, const std::string& name, const Path& path, const Asset& asset);

}  // namespace restframe
