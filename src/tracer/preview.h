#pragma once

#include "scene/temporal_evaluator.h"
#include "tracer/emitter_spectrum.h"
#include "tracer/random.h"
#include "tracer/sample.h"
#include "tracer/sample_parts.h"
#include "tracer/surface.h"
#include "tracer/surface_material.h"

namespace restframe {

// The `preview` integrator: base colour times |cos| between ray and normal in the rest frame, plus emission,
// at the hit's own time; no lights. Transparent surfaces are composited exactly, front to back.
class Preview {
 public:
  // Both must outlive the integrator.
  Preview(const Scene& scene, const FrameSet& frames);

  // `evaluator` belongs to the calling thread. `layers.data`, if wanted, gets the first surface that a stochastic
  // opacity test keeps; `layers.covers` all that alpha is made of.
  void trace(RayPacket& rays, const PacketId& id, TemporalEvaluator& evaluator,
             RadianceLanes& radiance, const SampleLayers& layers) const;

 private:
  // What a material is in this integrator, as far as it never changes. Red, green, blue and coverage.
  struct Plain {
    bool always =
        false;  // the numbers below are all there is: no texture, no clock, no transparency
    bool double_sided = false;
    Vec4f lit{0}, unlit{0};  // base colour: times the cosine, and as it is
    Vec4f emission{0};
  };
  static Plain plain(const Material& material);

  // Like Plain, where vertices have no colours. Of the material before the first: where nothing is hit.
  struct Simple {
    Vec4f lit{0}, rest{0};
    std::int32_t ends = 0;        // covers all that lies behind, seen from the front ...
    std::int32_t both_sides = 0;  // ... and from the back
  };
  static Simple simple(const Plain& plain);

  // The usual packet at once: false if anything in it needs more than Simple says.
  bool shade_simple(const RayPacket& rays, const HitPacket& hits, const SurfaceLanes& surfaces,
                    RadianceLanes& radiance) const;

  // One lane of what a packet met. Hits are refined where something depends on exactly when they are.
  struct Met {
    const RayPacket& rays;
    SurfaceLanes& surfaces;
    HitPacket& hits;
    int lane;
  };
  MetSurface met_surface(const Met& met) const;
  Vec4f shade(const Met& met, TemporalEvaluator& evaluator) const;
  Vec4f shade_changing(const Met& met, TemporalEvaluator& evaluator) const;
  Vec3f as_seen(const Vec3f& color, const Met& met) const;
  Vec3f own_spectrum(const Met& met, const Vec3f& filter, double clock,
                     TemporalEvaluator& evaluator) const;
  SurfaceData data_of(const Met& met) const;

  // What a surface sends by itself, and its base colour.
  struct Own {
    Vec3f shines{0}, base{0};
  };
  Own own(const Met& met, float there, TemporalEvaluator& evaluator) const;
  void add_parts(const Met& met, float left, const Vec4f& shaded, TemporalEvaluator& evaluator,
                 SampleParts& parts) const;

  const Scene& scene_;
  const FrameSet& frames_;
  SurfaceTables tables_;
  std::vector<ObjectPlace> places_;
  SceneSpectra spectra_;
  LightGroups groups_;
  std::vector<Plain> plain_;    // a material each
  std::vector<Simple> simple_;  // nothing, then a material each
};

}  // namespace restframe
