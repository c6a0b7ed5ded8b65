#pragma once

// What lights send, in their own rest frames, by their own clocks.

#include "tracer/light_sampling.h"

namespace restframe {

// Intensity, irradiance or radiance, whatever the light's kind has.
Vec3f emitted(const Light& light, double clock, TemporalEvaluator& evaluator);

// Likewise, as `incident.irradiance`, for the active lanes; lanes in the dark become inactive.
void set_emitted(const Light& light, const Lanes<double>& clock, TemporalEvaluator& evaluator,
                 IncidentLanes& incident);

// The temperature of a light that has one.
void set_temperature(const Light& light, const Lanes<double>& clock, TemporalEvaluator& evaluator,
                     IncidentLanes& incident);

// What a spot's cones let through. towards_light: unit, in the light's rest frame.
void narrow_to_spot(const Light& light, const Lanes<double>& clock, const Vec3Lanes& towards_light,
                    IncidentLanes& incident);

}  // namespace restframe
