#pragma once

#include <variant>

#include "tracer/preview.h"

namespace restframe {

// How light is followed. Chosen once a picture, outside of all loops; all have the same trace().
using Integrator = std::variant<Preview>;

// The one that the scene's settings name. Both must outlive it.
inline Integrator make_integrator(const Scene& scene, const FrameSet& frames) {
  return Integrator(std::in_place_type<Preview>, scene, frames);
}

}  // namespace restframe
