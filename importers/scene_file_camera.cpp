#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "importers/scene_file.h"

namespace restframe {
namespace {

void read_aim(TableReader& table, double light_speed, Camera& camera) {
  table.one_of({"look_at", "direction"});
  const auto up = read_direction(table, "up");
  camera.up = up.value_or(camera.up);
  if (const auto point = table.vector("look_at")) camera.aim = AimPoint{*point / light_speed};
  const auto direction = read_direction(table, "direction");
  if (!direction) return;
  camera.aim = AimDirection{*direction};
  if (glm::length(glm::cross(*direction, camera.up)) < 1e-9) {
    table.report(table.place("direction"),
                 "direction is along up, which leaves the orientation open");
  }
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

void read_camera(TableReader& root, SceneFile& file) {
  const ConfigTable* table = root.table("camera");
  if (!table) return;
  TableReader reader(*table, {file.faults, "camera"});
  Camera& camera = file.scene.camera;
  file.scene.camera_given = true;
  if (!reader.has("position")) reader.report(table->at, "position is missing");
  camera.worldline.reference.x =
      reader.vector("position").value_or(Vec3(0)) / file.scene.light_speed;
  camera.worldline.reference.t = reader.number("time").value_or(0);
  camera.worldline.velocity = read_velocity(reader);
  read_aim(reader, file.scene.light_speed, camera);
  camera.vertical_fov = glm::radians(reader.number("fov", between(0, 180)).value_or(60));
  read_lens_and_rolling(reader, file.scene.light_speed, camera);
  reader.not_supported({"track", "on", "key", "leg"});
  reader.finish();
}

}  // namespace restframe
