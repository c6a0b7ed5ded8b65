#pragma once

// The parts of read_camera. Directions and points of a camera that rides an object are as the file
// has them, in the object's coordinates.

#include "importers/scene_file.h"

namespace restframe {

// Where an asset's camera stands: what holds of it where its table says nothing else.
struct CameraStart {
  Vec3 position{0};  // light-seconds, world
  Vec3 direction{0, 0, -1}, up{0, 1, 0};
  double vertical_fov = 1;           // radians
  std::optional<Worldline> carried;  // by a node that moves: its clock shows 0 at the reference
};

// The keys of [camera] in `table`, into the scene's camera.
void read_camera_table(const ConfigTable& table, const std::optional<CameraStart>& start,
                       SceneFile& file);

// `look_at`, `direction` or `track`; nothing if the table has none of them, or a faulty one.
std::optional<Aim> read_aim(TableReader& table, const Vec3& up, const SceneFile& file);

// One [[camera.key]].
struct CameraKey {
  TextPosition at;      // of the table
  TextPosition aim_at;  // of its aim, or of the table
  double time = 0;
  std::optional<Vec3> position;
  TextPosition position_at;
  std::optional<Velocity> velocity;
  std::optional<Aim> aim;
  std::optional<double> fov;
};
std::vector<CameraKey> read_camera_keys(TableReader& camera, const SceneFile& file);

// The path through keys that have positions; `time`: the world's at clock 0.
KeyedPath path_through(const std::vector<CameraKey>& keys, double time, const Reporter& report);

// What the camera looks at by its keys; empty if no key says. A key without an aim or a field of
// view has the camera's own.
std::vector<ViewKey> view_keys(const std::vector<CameraKey>& keys, const Camera& camera,
                               const Reporter& report);

// [[camera.leg]]; uniform motion if there is none.
CameraMotion read_camera_legs(TableReader& camera, const Worldline& start);

}  // namespace restframe
