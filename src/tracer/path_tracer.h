#pragma once

#include <atomic>

#include "tracer/path_walk.h"

namespace restframe {

// The `path` integrator: light transport across rest frames. At every surface event a path adds what
// the surface emits and what lights send there, and goes on in one direction, chosen by the laws of
// optics in the surface's rest frame, through all rest frames (paper, section 2.2.1). Its frequency
// there stays (design, section 2, point 3), so moving mirrors shift without further code.
class PathTracer {
 public:
  // Both must outlive the integrator.
  PathTracer(const Scene& scene, const FrameSet& frames, LightSearch search = LightSearch::both);

  // `evaluator` belongs to the calling thread. `layers.data`, if wanted, gets the first surface that a
  // stochastic opacity test keeps.
  void trace(RayPacket& rays, const PacketId& id, TemporalEvaluator& evaluator,
             RadianceLanes& radiance, const SampleLayers& layers) const;

  // Throws InputError if a path met something of another velocity inside a medium: media nest only
  // within one rest frame.
  void check_media() const;

 private:
  void note_crossing(const MediumCrossing& crossing) const;

  PathStage stage_;
  // The objects (medium, met inside) of a fault; the least pair, so that messages do not depend on
  // threads.
  mutable std::atomic<std::uint64_t> crossed_media_;
};

}  // namespace restframe
