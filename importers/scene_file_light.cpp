// [[light]]: what shines, with a velocity and a clock of its own or those of an object.

#include <fmt/format.h>

#include <algorithm>

#include "importers/material_change.h"
#include "importers/moving_nodes.h"
#include "importers/scene_file_light.h"
#include "importers/scene_file_motion.h"
#include "importers/scene_file_spectrum.h"
#include "scene/light_groups.h"

namespace restframe {
namespace {

// In the order of the enumeration LightKind.
const std::vector<std::string> type_names = {"point", "spot", "sun", "environment"};

bool is_one_of(LightKind kind, std::initializer_list<LightKind> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool is_directed(LightKind kind) {
  return is_one_of(kind, {LightKind::spot, LightKind::sun});
}

// Keys that other types of light have.
void refuse_keys_of_others(TableReader& table, LightKind kind) {
  const auto refuse = [&](const char* key, bool allowed, const char* types) {
    if (allowed || !table.has(key)) return;
    table.report(table.key_place(key),
                 fmt::format("{} goes with {}, not with type = \"{}\"", key, types,
                             type_names[static_cast<std::size_t>(kind)]));
  };
  const bool is_environment = kind == LightKind::environment;
  refuse("position", !is_environment, "a point, spot or sun");
  refuse("direction", is_directed(kind), "a spot or sun");
  refuse("cone", kind == LightKind::spot, "a spot");
  refuse("sweep", kind == LightKind::spot, "a spot");
  refuse("file", is_environment, "an environment");
  refuse("rotation", is_environment, "an environment");
}

void read_cone(TableReader& table, Light& light) {
  const ConfigValue* value = table.find("cone");
  if (!value) return;
  const auto* array = std::get_if<ConfigArray>(&value->data);
  if (!array || array->size() != 2) {
    table.report(value->at, "cone must be [inner, outer], half-angles in degrees");
    return;
  }
  const Range inner_range = from_to(0, 90), outer_range{0, 90, true, false};
  const auto inner = read_number((*array)[0], "the inner angle", inner_range, table.report);
  const auto outer = read_number((*array)[1], "the outer angle", outer_range, table.report);
  if (!inner || !outer) return;
  if (*inner > *outer) {
    table.report(value->at, fmt::format("cone is [{}, {}], the inner angle must be at most the "
                                        "outer one",
                                        *inner, *outer));
  }
  light.inner_cone = glm::radians(*inner);
  light.outer_cone = glm::radians(*outer);
}

// A direction in the coordinates of an object's asset, in its rest frame.
Vec3 turned(const Mat4& object_from_asset, const Vec3& direction) {
  return glm::normalize(Mat3(object_from_asset) * direction);
}

// The rotation nearest to what it does to the axes of the light's map.
Mat3 turned_axes(const Mat4& object_from_asset, const Light& light) {
  const Mat3 axes = Mat3(object_from_asset) * light.rest_from_map;
  const Vec3 x = glm::normalize(axes[0]);
  const Vec3 y = glm::normalize(axes[1] - glm::dot(axes[1], x) * x);
  return {x, y, glm::cross(x, y)};
}

// In the coordinates of the light's asset, if it has one.
std::optional<Vec3> read_turned(TableReader& table, const std::string& key,
                                const LightStart* start) {
  const auto direction = read_direction(table, key);
  if (!direction || start == nullptr) return direction;
  return turned(start->object_from_asset, *direction);
}

void read_sweep(TableReader& light_table, const LightStart* start, SceneFile& file, Light& light) {
  const ConfigTable* table = light_table.table("sweep");
  if (!table) return;
  TableReader reader(*table, {file.faults, light_table.report.name + ": sweep"});
  Sweep sweep;
  sweep.axis = read_turned(reader, "axis", start).value_or(sweep.axis);
  if (!reader.has("period")) reader.report(table->at, "period is missing");
  sweep.period = reader.number("period", above(0)).value_or(1);
  reader.finish();
  light.sweep = sweep;
}

// A map that something carries is turned with it.
void read_sky(TableReader& table, const LightStart* start, SceneFile& file, Light& light) {
  if (light.kind != LightKind::environment) return;
  read_sky_map(table, file, light);
  if (light.sky_map < 0) return;
  if (start != nullptr) light.rest_from_map = turned_axes(start->object_from_asset, light);
}

void ride(int index, const Vec3& position, const SceneFile& file, Light& light) {
  const auto i = static_cast<std::size_t>(index);
  const Object& object = file.scene.objects[i];
  light.worldline =
      at_rest_on(object, object_point(file, index, position), clock_at_reference(object));
  light.clock = object.clock;
  light.frame_clock = object.frame_clock;
  light.direction = turned(file.object_from_asset[i], light.direction);
  light.rest_from_map = turned_axes(file.object_from_asset[i], light);
  if (light.sweep) light.sweep->axis = turned(file.object_from_asset[i], light.sweep->axis);
}

void read_ride(TableReader& table, const SceneFile& file, Light& light) {
  for (const char* key : {"time", "velocity", "gamma", "motion", "clock"}) {
    if (!table.has(key)) continue;
    table.report(table.key_place(key),
                 fmt::format("on and {} exclude each other: the light has the object's", key));
  }
  const Vec3 position = table.vector("position").value_or(Vec3(0));
  const std::optional<int> index = read_object_reference(table, "on", file);
  if (index) ride(*index, position, file, light);
}

void set(const ClockedWorldline& own, Light& light) {
  light.worldline = own.worldline;
  light.clock = own.clock;
  light.frame_clock = own.frame_clock;
}

// Of a light of an asset, which has a place already.
void read_start(TableReader& table, const LightStart& start, const SceneFile& file, Light& light) {
  bool says_motion = false;
  for (const char* key : {"position", "time", "velocity", "gamma", "motion", "clock"}) {
    if (!table.has(key)) continue;
    says_motion = true;
    if (!start.carried) continue;
    table.report(table.key_place(key), fmt::format("{} goes with a light at rest only: this one is "
                                                   "carried by a node or object that has a motion",
                                                   key));
  }
  if (!says_motion || start.carried) return;
  const Object& base = file.scene.objects[static_cast<std::size_t>(start.object)];
  ClockedWorldline own = read_clocked_worldline(table, "motion", 1, start.position);
  own.worldline = in_world(own.worldline, base, start.object_from_asset);
  if (!table.has("clock")) {
    own.clock = base.clock;
    own.frame_clock = base.frame_clock;
  }
  set(own, light);
}

void read_place(TableReader& table, const LightStart* start, const SceneFile& file, Light& light) {
  if (table.has("on")) return read_ride(table, file, light);
  if (start != nullptr) return read_start(table, *start, file, light);
  set(read_clocked_worldline(table, "motion", file.scene.light_speed), light);
}

// An intensity over time is none in its gaps: the light is off.
void read_emission(TableReader& table, SceneFile& file, Light& light) {
  const auto color = read_property(table, "color", {true, at_least(0)}, file);
  const auto intensity = read_property(table, "intensity", {false, at_least(0)}, file);
  const SpectrumChange spectrum = read_spectrum(table, "", file);
  set(spectrum, light.temperature, light.spectrum);
  if (spectrum.any()) light.color = {Vec3f(1)};
  set(color, light.color);
  set(intensity, light.intensity);
  if (light.intensity.function != no_function) light.intensity.value = 0;
}

// The name, or with a number that makes it one of its own.
std::string claim_name(const std::string& wanted, SceneFile& file) {
  const auto [known, is_new] = file.light_names.emplace(wanted, 1);
  std::string name = wanted;
  if (is_new) return name;
  do {
    name = fmt::format("{}_{}", wanted, ++known->second);
  } while (!file.light_names.emplace(name, 1).second);
  return name;
}

std::string read_light_name(TableReader& table, const LightStart* start, SceneFile& file) {
  const std::optional<std::string> given = table.text("name");
  if (start && !given) return claim_name(start->light.name, file);
  std::string name = given.value_or(table.report.name);
  if (!file.light_names.emplace(name, 1).second) {
    table.report.faults.add(table.place("name"),
                            fmt::format("two lights have the name \"{}\"", name));
  }
  return name;
}

void read_type(TableReader& reader, const LightStart* start, Light& light) {
  const std::optional<std::size_t> type = reader.choice("type", type_names);
  if (!reader.has("type") && !start) {
    reader.report(reader.place(),
                  fmt::format("type is missing, must be one of {}", fmt::join(type_names, ", ")));
  }
  if (type) light.kind = static_cast<LightKind>(*type);
  if (type || start) refuse_keys_of_others(reader, light.kind);
}

}  // namespace

// Layers are called light_GROUP.
std::optional<std::string> read_group(TableReader& table) {
  auto group = table.text("group");
  if (group && !is_group_name(*group)) {
    table.report(table.place("group"),
                 fmt::format("group is \"{}\", must be up to {} letters, digits, _ and -", *group,
                             longest_group_name));
  }
  return group;
}

void read_light(const ConfigTable& table, const LightStart* start, SceneFile& file) {
  TableReader unnamed(table, {file.faults, fmt::format("light_{}", file.scene.lights.size() + 1)});
  Light light = start ? start->light : Light{};
  light.name = read_light_name(unnamed, start, file);
  TableReader reader(table, {file.faults, fmt::format("light \"{}\"", light.name)});
  reader.find("name");
  read_type(reader, start, light);
  light.direction = read_turned(reader, "direction", start).value_or(light.direction);
  read_cone(reader, light);
  read_sweep(reader, start, file, light);
  read_sky(reader, start, file, light);
  read_place(reader, start, file, light);
  read_emission(reader, file, light);
  light.group = read_group(reader).value_or(light.group);
  reader.finish();
  file.scene.lights.push_back(std::move(light));
}

void warn_of_unused_lights(TextPosition at, SceneFile& file) {
  if (file.scene.render.integrator == IntegratorKind::path) return;
  file.warnings.push_back(
      file.faults.located(at, "lights are used by integrator = \"path\" only, see [render]"));
}

void read_lights(TableReader& root, SceneFile& file) {
  for (const ConfigTable* table : root.tables("light")) read_light(*table, nullptr, file);
  if (root.has("light")) warn_of_unused_lights(root.place("light"), file);
}

}  // namespace restframe
