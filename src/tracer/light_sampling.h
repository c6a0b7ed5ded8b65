#pragma once

// How lights reach a surface event: retarded, aberrated, shifted (design, section 2, point 5).

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "scene/temporal_evaluator.h"
#include "tracer/sample.h"

namespace restframe {

// A light with its coordinates: the rest frame around its reference event.
struct LightPlace {
  const Light* light = nullptr;
  AnchoredFrame<in::LightRest> frame;
  Boost<in::World, in::LightRest> world_from_light;
  double clock_at_anchor = 0;
};
std::vector<LightPlace> light_places(const Scene& scene);

// An event on a surface that light of one frequency is to reach.
struct LitEvent {
  Event<in::World> event;
  Boost<in::Rest, in::World> rest_from_world;  // the surface's rest frame
  double omega = 1;  // the light's frequency there over that in the camera
};

// What comes from one light, if nothing is in between.
struct Incident {
  WaveVector<in::World> k;  // from the event to the light, back in time
  double s_light = 0;       // where the light is along k; infinite for a sun
  Vec3f direction{0};       // unit, towards the light, in the surface's rest frame
  Vec3f irradiance{0};      // of a surface across it there, times the emitter's factor
};

// Point, spot and sun. Nothing comes from a light at the event itself, and where its spot or clock
// is dark.
std::optional<Incident> incident(const LightPlace& place, const LitEvent& lit, double light_speed,
                                 bool beaming, TemporalEvaluator& evaluator);

// Radiance from an environment along a ray, times the emitter's factor.
Vec3f environment_radiance(const LightPlace& place, const Event<in::World>& origin,
                           const WaveVector<in::World>& k, bool beaming,
                           TemporalEvaluator& evaluator);

}  // namespace restframe
