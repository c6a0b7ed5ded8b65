#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "importers/scene_file_camera.h"

namespace restframe {
namespace {

// Directions of a camera that rides an object are in the object's coordinates.
void turn(const Mat4& object_from_asset, Aim& aim) {
  auto* ahead = std::get_if<AimDirection>(&aim);
  if (ahead) ahead->direction = glm::normalize(Mat3(object_from_asset) * ahead->direction);
}

void turn_with_object(const Mat4& object_from_asset, Camera& camera) {
  turn(object_from_asset, camera.aim);
  for (ViewKey& key : camera.view_keys) turn(object_from_asset, key.aim);
  const Aim& aim = camera.view_keys.empty() ? camera.aim : camera.view_keys[0].aim;
  if (!std::holds_alternative<AimDirection>(aim)) return;  // `up` is the world's
  camera.up = glm::normalize(Mat3(object_from_asset) * camera.up);
}

// Whose place and clock the camera has, in coordinates of its asset.
void ride(int index, const Vec3& point, const SceneFile& file, Camera& camera) {
  const auto i = static_cast<std::size_t>(index);
  camera.motion = at_rest_on(file.scene.objects[i], object_point(file, index, point), 0.0);
  turn_with_object(file.object_from_asset[i], camera);
}

void check_exclusions(TableReader& camera, bool keys_move) {
  camera.one_of({"key", "leg"});
  for (const char* key : {"time", "velocity", "leg"}) camera.one_of({"on", key});
  if (!keys_move) return;
  for (const char* key : {"position", "velocity", "on"}) {
    if (!camera.has(key)) continue;
    camera.report(camera.key_place(key),
                  fmt::format("{} and keys with positions exclude each other", key));
  }
}

// The node that carries the camera has the motion.
void refuse_motion(TableReader& camera, bool keys_move) {
  const auto refuse = [&](const char* key) {
    camera.report(camera.key_place(key), fmt::format("{} goes with a camera at rest only: this one "
                                                     "is carried by a node that has a motion",
                                                     key));
  };
  for (const char* key : {"position", "time", "velocity", "on", "leg"}) {
    if (camera.has(key)) refuse(key);
  }
  if (keys_move) refuse("key");
}

void read_motion(TableReader& reader, const std::vector<CameraKey>& keys,
                 const std::optional<CameraStart>& start, SceneFile& file) {
  Camera& camera = file.scene.camera;
  const bool keys_move = !keys.empty() && keys[0].position;
  check_exclusions(reader, keys_move);
  if (!reader.has("position") && !reader.has("on") && !keys_move && !start) {
    reader.report(reader.place(), "position is missing");
  }
  const std::optional<Vec3> position = reader.vector("position");
  const Vec3 place =
      position ? *position / file.scene.light_speed : start.value_or(CameraStart{}).position;
  const double time = reader.number("time").value_or(0);
  const Velocity velocity = read_velocity(reader);
  const std::optional<int> ridden = read_object_reference(reader, "on", file);
  const CameraMotion free = read_camera_legs(reader, {{time, place}, velocity});
  if (start && start->carried) {
    refuse_motion(reader, keys_move);
    camera.motion = *start->carried;
  } else if (ridden) {
    ride(*ridden, position.value_or(Vec3(0)), file, camera);
  } else {
    camera.motion = keys_move ? path_through(keys, time, reader.report) : free;
  }
}

// Whether the table aims the camera, itself or by keys.
bool says_aim(TableReader& camera) {
  const auto is_aim = [](const std::string& key) {
    return key == "look_at" || key == "direction" || key == "track";
  };
  bool says = camera.has("look_at") || camera.has("direction") || camera.has("track");
  for (const ConfigTable* key : camera.tables("key")) {
    for (const ConfigEntry& entry : key->entries) says = says || is_aim(entry.key);
  }
  return says;
}

// Aim, up and field of view as an asset's camera has them; its up goes with its own direction only.
void begin_at(const CameraStart& start, TableReader& table, Camera& camera) {
  camera.vertical_fov = start.vertical_fov;
  camera.aim = AimDirection{start.direction};
  if (!says_aim(table)) camera.up = start.up;
}

}  // namespace

std::optional<Vec3> read_direction(TableReader& table, const std::string& key) {
  const std::optional<Vec3> given = table.vector(key);
  if (!given) return std::nullopt;
  const double largest = std::max({std::abs(given->x), std::abs(given->y), std::abs(given->z)});
  if (largest > 0) return glm::normalize(*given / largest);
  table.report(table.place(key), key + " is [0, 0, 0], must point somewhere");
  return std::nullopt;
}

Velocity read_velocity(TableReader& table) {
  const std::optional<Vec3> beta = table.vector("velocity");
  if (!beta) return {};
  const double speed = glm::length(*beta);
  if (speed < 1) return Velocity::from_beta(*beta);
  table.report(table.place("velocity"), fmt::format("|velocity| is {}, must be below 1", speed));
  return {};
}

void read_camera_table(const ConfigTable& table, const std::optional<CameraStart>& start,
                       SceneFile& file) {
  TableReader reader(table, {file.faults, "camera"});
  Camera& camera = file.scene.camera;
  file.scene.camera_given = true;
  camera.vertical_fov = glm::radians(60.0);
  if (start) begin_at(*start, reader, camera);
  camera.up = read_direction(reader, "up").value_or(camera.up);
  camera.aim = read_aim(reader, camera.up, file).value_or(camera.aim);
  if (const auto fov = reader.number("fov", between(0, 180))) {
    camera.vertical_fov = glm::radians(*fov);
  }
  const std::vector<CameraKey> keys = read_camera_keys(reader, file);
  camera.view_keys = view_keys(keys, camera, reader.report);
  read_motion(reader, keys, start, file);
  read_lens_and_rolling(reader, file.scene.light_speed, camera);
  reader.finish();
}

void read_camera(TableReader& root, SceneFile& file) {
  const ConfigTable* table = root.table("camera");
  if (table) read_camera_table(*table, std::nullopt, file);
}

}  // namespace restframe
