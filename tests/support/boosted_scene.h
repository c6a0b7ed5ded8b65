#pragma once

#include "scene/scene.h"

namespace restframe {

// The rotation that takes the coordinates of the rest frame of something that moves with `velocity`
// in the world (axes: a pure boost of the world's) to those of the same rest frame when its axes
// are a pure boost of another world's, which moves with `new_world` in the first.
Mat3 wigner_rotation(const Velocity& velocity, const Velocity& new_world);

// The same scene as it is written in another world frame, which moves with `new_world` in the
// scene's own. Both worlds share their origin event. Pictures of the two scenes are the same.
// Throws std::invalid_argument unless the camera's aim is an AimDirection: a point at rest in the
// old world moves in the new one.
Scene boosted(const Scene& scene, const Velocity& new_world);

}  // namespace restframe
