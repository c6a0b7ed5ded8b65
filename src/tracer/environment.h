#pragma once

// Environments: radiance from infinity. Paths meet them where they leave the scene; those whose
// brightness varies much over the sky of some surface are sampled as lights, too.

#include <memory>
#include <optional>
#include <vector>

#include "tracer/light_sampling.h"
#include "tracer/sky_distribution.h"

namespace restframe {

struct Environment {
  LightPlace place;
  std::unique_ptr<const SkyDistribution> distribution;  // null: evenly from everywhere
  bool is_sampled = false;
  // What it radiates in every direction, always, times any emitter's factor, if that is one colour.
  std::optional<Vec3f> uniform;
};
std::vector<Environment> environments(const Scene& scene);

// Per steradian in the environment's rest frame, with which its directions are chosen. direction:
// unit, there.
double sky_density(const Environment& environment, const Vec3& direction);

// One direction a lane, by two numbers in [0, 1) each: what comes from there, as from a light. The
// irradiance is over the density in the surface's rest frame, which is `density`.
void incident_from_sky(const Environment& environment, const EventLanes<in::World>& event,
                       const LitLanes& lit, const Irradiating& settings, const Lanes<float>& u,
                       const Lanes<float>& v, TemporalEvaluator& evaluator, IncidentLanes& incident,
                       Lanes<double>& density);

}  // namespace restframe
