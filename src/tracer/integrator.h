#pragma once

#include <variant>

#include "tracer/path_tracer.h"
#include "tracer/preview.h"

namespace restframe {

// How light is followed. Chosen once a picture, outside of all loops; all have the same trace().
using Integrator = std::variant<Preview, PathTracer>;

// The one that the scene's settings name. Both must outlive it.
inline Integrator make_integrator(const Scene& scene, const FrameSet& frames) {
  if (scene.render.integrator == IntegratorKind::path) {
    return Integrator(std::in_place_type<PathTracer>, scene, frames);
  }
  return Integrator(std::in_place_type<Preview>, scene, frames);
}

// Throws InputError where what was rendered so far was not a scene that the integrator can do.
inline void check_faults(const Preview&) {}
inline void check_faults(const PathTracer& tracer) {
  tracer.check_media();
}

}  // namespace restframe
