#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "physics/worldline.h"
#include "scene/camera_motion.h"

namespace restframe {

// Aim: a unit direction in the camera's rest frame, or a point at rest in the world, aimed at where
// it is seen (design, section 1).
struct AimDirection {
  Vec3 direction{0, 0, -1};
};
struct AimPoint {
  Vec3 point{0, 0, 0};
};
// Or something that moves uniformly, kept at the picture's centre where it is seen (paper, section
// 4.4).
struct AimTrack {
  Worldline target;
  std::string name;  // of the object it belongs to, for messages
};
using Aim = std::variant<AimDirection, AimPoint, AimTrack>;

// What the camera looks at when its clock shows `proper_time`.
struct ViewKey {
  double proper_time = 0;
  Aim aim;
  double vertical_fov = 1;  // radians
};

// Two pinholes or lenses side by side, at rest in the camera's frame: their exposures begin at the same
// time there. They look the same way; their films are shifted, so that what is at the distance of
// convergence along the view falls on the same place of both.
struct StereoSettings {
  double separation = 0;   // of the eyes, light-seconds
  double convergence = 0;  // light-seconds; 0: at infinity, no shift
};

enum class Eye : std::uint8_t { centre, left, right };

// As OpenEXR calls it; empty for the centre.
inline const char* eye_name(Eye eye) {
  return eye == Eye::left ? "left" : eye == Eye::right ? "right" : "";
}

// A perspective camera. In uniform motion, its clock shows 0 at the worldline's reference.
struct Camera {
  CameraMotion motion;
  Aim aim;
  // In place of aim and vertical_fov, if there are any: in rising time, of one kind of aim. Between
  // two keys the field of view, the look_at point or the direction goes straight from one to the
  // other; a track is that of the key before. Before the first and after the last, theirs hold.
  std::vector<ViewKey> view_keys;
  Vec3 up{0, 1, 0};         // in the camera's axes with a direction; else the world's, aberrated
  double vertical_fov = 1;  // radians
  double aperture = 0;      // radius of the lens, light-seconds; 0: a pinhole
  double focus = 1;         // distance of the plane that is sharp, light-seconds, camera's frame
  double rolling = 0;       // seconds of the camera's time from the top row to the bottom one
  std::optional<StereoSettings> stereo;
};

// Those whose pictures are taken, the first one's being the one that stands for all.
std::vector<Eye> eyes_of(const Camera& camera);

// The camera at one moment of its clock: an event, and axes in its rest frame.
struct CameraPose {
  Event<in::World> event;
  Boost<in::World, in::Camera> world_from_camera;
  Mat3 axes{1};             // columns: right, up, backwards, in the camera's rest frame
  double vertical_fov = 1;  // radians
  // Where the middle of the film is, to the right of where the camera looks; at the distance 1.
  double film_shift = 0;
};

// Exact for any time. The centre's stands between the eyes. Throws InputError where the aim leaves the orientation open: the camera is at its look_at point,
// or it looks along `up`.
CameraPose pose_at(const Camera& camera, double proper_time, Eye eye = Eye::centre);

// Whether velocity, axes and field of view are the same at all times: only the event moves.
bool is_steady(const Camera& camera);

// From film to rays. Film coordinates are pixels: x to the right from the left edge, y down from
// the top.
class Projection {
 public:
  Projection(const CameraPose& pose, double vertical_fov, int width, int height);

  // Unit direction in the camera's rest frame.
  Vec3 direction(double film_x, double film_y) const {
    return glm::normalize(corner_ + film_x * step_x_ + film_y * step_y_);
  }
  // The un-normalised direction is corner + film_x step_x + film_y step_y.
  const Vec3& corner() const { return corner_; }
  const Vec3& step_x() const { return step_x_; }
  const Vec3& step_y() const { return step_y_; }

 private:
  Vec3 corner_, step_x_, step_y_;
};

}  // namespace restframe
