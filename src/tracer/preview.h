#pragma once

#include "scene/temporal_evaluator.h"
#include "tracer/random.h"
#include "tracer/sample.h"
#include "tracer/surface.h"

namespace restframe {

// The `preview` integrator: base colour times |cos| between ray and normal in the rest frame, plus
// emission, at the hit's own time; no lights. Transparent surfaces are composited exactly, front to
// back.
class Preview {
 public:
  // Both must outlive the integrator.
  Preview(const Scene& scene, const FrameSet& frames);

  // `evaluator` belongs to the calling thread. `data`, if wanted, gets the first surface that a
  // stochastic opacity test keeps; ids: one a lane.
  void trace(RayPacket& rays, const Lanes<SampleId>& ids, TemporalEvaluator& evaluator,
             RadianceLanes& radiance, SurfaceDataLanes* data) const;

 private:
  struct Shaded {
    Vec3f color{0};
    float alpha = 0;
  };
  Shaded shade(const Surface& surface, TemporalEvaluator& evaluator) const;
  float coverage(const Material& material, const Surface& surface, float texture_alpha,
                 TemporalEvaluator& evaluator) const;
  Vec4f texel(const TextureUse& use, const Surface& surface) const;
  SurfaceData data_of(const Surface& surface, const RayPacket& rays, const HitPacket& hits,
                      int lane) const;

  const Scene& scene_;
  const FrameSet& frames_;
  std::vector<ObjectPlace> places_;
};

}  // namespace restframe
