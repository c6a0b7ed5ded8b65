#pragma once

#include "scene/scene.h"

namespace restframe {

// A camera at rest in the world that frames all objects as they are seen at `proper_time` of its clock,
// from the front (+Z), a little to the right and above, as near as they fit.
Camera framing_camera(const Scene& scene, double proper_time);

}  // namespace restframe
