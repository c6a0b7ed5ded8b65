#pragma once

#include "scene/temporal_evaluator.h"
#include "tracer/random.h"
#include "tracer/sample.h"
#include "tracer/surface.h"

namespace restframe {

// The `preview` integrator: base colour times |cos| between ray and normal in the rest frame, plus emission,
// at the hit's own time; no lights. Transparent surfaces are composited exactly, front to back.
class Preview {
 public:
  // Both must outlive the integrator.
  Preview(const Scene& scene, const FrameSet& frames);

  // `evaluator` belongs to the calling thread. `data`, if wanted, gets the first surface that a stochastic
  // opacity test keeps.
  void trace(RayPacket& rays, const PacketId& id, TemporalEvaluator& evaluator,
             RadianceLanes& radiance, SurfaceDataLanes* data) const;

 private:
  struct Shaded {
    Vec3f color{0};  // premultiplied
    float alpha = 0;
  };
  // What a material is in this integrator, as far as it never changes.
  struct Plain {
    bool always =
        false;  // the numbers below are all there is: no texture, no clock, no transparency
    bool double_sided = false, unlit = false;
    Vec3f base_color{0}, emission{0};
  };
  static Plain plain(const Material& material);

  Shaded shade(const Surface& surface, HitPacket& hits, int lane,
               TemporalEvaluator& evaluator) const;
  Shaded shade_changing(const Surface& surface, double clock, TemporalEvaluator& evaluator) const;
  float coverage(const Material& material, const Surface& surface, float texture_alpha,
                 double clock, TemporalEvaluator& evaluator) const;
  Vec4f texel(const TextureUse& use, const Surface& surface) const;
  SurfaceData data_of(const Surface& surface, const RayPacket& rays, const HitPacket& hits,
                      int lane) const;

  const Scene& scene_;
  const FrameSet& frames_;
  std::vector<ObjectPlace> places_;
  std::vector<Plain> plain_;  // a material each
};

}  // namespace restframe
