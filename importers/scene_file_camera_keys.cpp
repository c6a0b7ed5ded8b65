#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "importers/scene_file_camera.h"

namespace restframe {
namespace {

Reporter key_reporter(const Reporter& camera, std::size_t index) {
  return {camera.faults, fmt::format("{}: key {}", camera.name, index + 1)};
}

void read_time(TableReader& table, const std::vector<CameraKey>& before, CameraKey& key) {
  const std::optional<double> time = table.number("time");
  if (!table.has("time")) table.report(table.place(), "time is missing");
  key.time = time.value_or(before.empty() ? 0 : before.back().time);
  if (!time || before.empty() || key.time > before.back().time) return;
  table.report(table.place("time"),
               fmt::format("time is {}, must be above that of the key before, {}", key.time,
                           before.back().time));
}

// A path needs every key's position, or every key's velocity.
void check_like_first(TableReader& table, const std::string& what, bool first_has_it) {
  if (table.has(what) && !first_has_it) {
    table.report(table.key_place(what), what + " is not given by the first key: all keys or none");
  } else if (!table.has(what) && first_has_it) {
    table.report(table.place(), what + " is missing, the first key has it: all keys or none");
  }
}

CameraKey read_key(TableReader& table, const std::vector<CameraKey>& before,
                   const SceneFile& file) {
  CameraKey key;
  key.at = key.aim_at = table.place();
  read_time(table, before, key);
  if (const auto position = table.vector("position")) {
    key.position = *position / file.scene.light_speed;
  }
  key.position_at = table.place("position");
  if (table.has("velocity")) {
    key.velocity = read_velocity(table);
    if (!table.has("position")) {
      table.report(table.key_place("velocity"), "velocity needs a position");
    }
  }
  key.aim = read_aim(table, file.scene.camera.up, file);
  for (const char* name : {"look_at", "direction", "track"}) {
    if (table.has(name)) key.aim_at = table.place(name);
  }
  if (const auto fov = table.number("fov", between(0, 180))) key.fov = glm::radians(*fov);
  table.finish();
  return key;
}

const char* kind_of(const Aim& aim) {
  static constexpr const char* kinds[] = {"a direction", "a look_at", "a track"};
  return kinds[aim.index()];
}

// Faults of a key's aim beside that of the key before.
void check_aim(const ViewKey& before, const CameraKey& key, const Aim& aim,
               const Reporter& report) {
  if (aim.index() != before.aim.index()) {
    report(key.aim_at,
           fmt::format("its aim is {}{}, that of the key before is {}: all keys must "
                       "aim alike",
                       kind_of(aim), key.aim ? "" : ", the camera's own", kind_of(before.aim)));
    return;
  }
  const auto *from = std::get_if<AimDirection>(&before.aim), *to = std::get_if<AimDirection>(&aim);
  if (from && to && glm::length(from->direction + to->direction) < 1e-9) {
    report(key.aim_at, "direction is opposite to that of the key before; put a key between them");
  }
}

AccelerationLeg read_leg(TableReader& table) {
  for (const char* key : {"duration", "acceleration"}) {
    if (!table.has(key)) table.report(table.place(), std::string(key) + " is missing");
  }
  const double duration = table.number("duration", above(0)).value_or(1);
  const Vec3 acceleration = table.vector("acceleration").value_or(Vec3(0));
  table.finish();
  return {duration, acceleration};
}

}  // namespace

std::vector<CameraKey> read_camera_keys(TableReader& camera, const SceneFile& file) {
  std::vector<CameraKey> keys;
  bool first_has_position = false, first_has_velocity = false;
  for (const ConfigTable* table : camera.tables("key")) {
    TableReader reader(*table, key_reporter(camera.report, keys.size()));
    if (keys.empty()) {
      first_has_position = reader.has("position");
      first_has_velocity = reader.has("velocity");
    }
    keys.push_back(read_key(reader, keys, file));
    check_like_first(reader, "position", first_has_position);
    check_like_first(reader, "velocity", first_has_velocity);
  }
  return keys;
}

KeyedPath path_through(const std::vector<CameraKey>& keys, double time, const Reporter& report) {
  std::vector<PathKey> path;
  const bool states_velocity = keys.front().velocity.has_value();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const CameraKey& key = keys[i];
    path.push_back({key.time, key.position.value_or(Vec3(0)), key.velocity.value_or(Velocity())});
    if (i == 0 || states_velocity || !(key.time > path[i - 1].proper_time)) continue;
    const Vec3 way = path[i].position - path[i - 1].position;
    const double gamma =
        Velocity::from_gamma_beta(way / (key.time - path[i - 1].proper_time)).gamma();
    if (gamma <= largest_camera_gamma) continue;
    key_reporter(report, i)(key.position_at,
                            fmt::format("position is so far from that of the key before that gamma "
                                        "is {} in between, must be at most {}",
                                        gamma, largest_camera_gamma));
  }
  return {time, std::move(path), states_velocity};
}

std::vector<ViewKey> view_keys(const std::vector<CameraKey>& keys, const Camera& camera,
                               const Reporter& report) {
  std::vector<ViewKey> views;
  bool says_something = false;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const CameraKey& key = keys[i];
    says_something = says_something || key.aim || key.fov;
    const Aim aim = key.aim.value_or(camera.aim);
    if (i > 0) check_aim(views.back(), key, aim, key_reporter(report, i));
    views.push_back({key.time, aim, key.fov.value_or(camera.vertical_fov)});
  }
  if (!says_something) views.clear();
  return views;
}

CameraMotion read_camera_legs(TableReader& camera, const Worldline& start) {
  std::vector<AccelerationLeg> legs;
  Worldline here = start;
  bool too_fast = false;
  for (const ConfigTable* table : camera.tables("leg")) {
    TableReader reader(*table, {camera.report.faults,
                                fmt::format("{}: leg {}", camera.report.name, legs.size() + 1)});
    legs.push_back(read_leg(reader));
    here = AcceleratedPath(here, {legs.back()}).after_leg(0);
    // It is not a number where sinh overflows.
    const double gamma = std::fmin(here.velocity.gamma(), std::numeric_limits<double>::infinity());
    if (too_fast || gamma <= largest_camera_gamma) continue;
    too_fast = true;
    reader.report(reader.place("acceleration"),
                  fmt::format("gamma is {} at the end of this leg, must be at most {}", gamma,
                              largest_camera_gamma));
  }
  if (legs.empty()) return start;
  return AcceleratedPath(start, std::move(legs));
}

}  // namespace restframe
