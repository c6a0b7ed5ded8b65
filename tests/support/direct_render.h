#pragma once

#include "app/render_picture.h"
#include "frames/frame_set.h"
#include "scene/parallel.h"

namespace restframe {

// The first picture of a scene that need not come from a file.
inline Picture first_picture(const Scene& scene) {
  const FrameSet frames(scene, thread_count());
  const Integrator integrator = make_integrator(scene, frames);
  EvaluatorPool evaluators(scene.functions);
  Picture picture = blank_picture(scene);
  render_picture({scene, integrator, evaluators, {}}, 0, picture);
  return picture;
}

// The values of a channel, by its name in the EXR; times in full. Throws std::out_of_range.
inline std::vector<double> channel_of(const Picture& picture, const std::string& name) {
  for (const Plane& plane : picture.planes()) {
    if (plane.name != name) continue;
    if (!plane.times.empty()) return plane.times;
    return {plane.values.begin(), plane.values.end()};
  }
  throw std::out_of_range("no channel " + name);
}

}  // namespace restframe
