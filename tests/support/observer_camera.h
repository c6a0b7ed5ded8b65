#pragma once

// The reference's own camera: a pinhole in uniform motion, from film to the world and back, written
// without src/physics and src/scene. Events are world events; c = 1.

#include <optional>

#include "support/long_vectors.h"

namespace restframe::reference {

struct FilmPoint {
  double x = 0, y = 0;  // pixels: right from the left edge, down from the top
};

// At `position` at world time `time`, when its clock shows 0. The axes are unit vectors in its rest
// frame, whose axes are a pure boost of the world's; it looks against `back`.
struct ObserverCamera {
  Vec3 position{0, 0, 0};
  double time = 0;
  Vec3 gamma_beta{0, 0, 0};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
  double vertical_fov = 1;  // radians
  int width = 1280, height = 720;
};

Vec3 gamma_beta_from_beta(const Vec3& beta);
Vec3 gamma_beta_from_gamma(double gamma, const Vec3& direction);

// Turns the axes to look along `direction` with `up` upwards; both in the camera's rest frame.
void aim(ObserverCamera& camera, const Vec3& direction, const Vec3& up = {0, 1, 0});

// The world event at which the camera's clock shows `proper_time`.
Long4 camera_event(const ObserverCamera& camera, double proper_time);

// Unit direction in the camera's rest frame of what is seen at a film point, and back; nothing
// where it is not in front of the camera. The film point may lie outside the picture.
Long3 direction_through(const ObserverCamera& camera, const FilmPoint& film);
std::optional<FilmPoint> film_point(const ObserverCamera& camera, const Long3& direction);

// A sight line as the world measures it: its direction, and the world's frequency of light over the
// camera's.
struct WorldSight {
  Long3 direction;
  long double frequency = 1;
};
WorldSight world_sight(const ObserverCamera& camera, const Long3& direction_in_camera);

// The direction in the camera's rest frame of what the world sees along `world_direction`.
Long3 camera_sight(const ObserverCamera& camera, const Long3& world_direction);

}  // namespace restframe::reference
