#pragma once

// How lights reach a surface event: retarded, aberrated, shifted (design, section 2, point 5).

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
  const SkyMap* sky_map = nullptr;  // of an environment, if it has one
};
std::vector<LightPlace> light_places(const Scene& scene);

// Surfaces that light of one frequency is to reach, in the active lanes.
struct LitLanes {
  Lanes<const Boost<in::Rest, in::World>*> rest_from_world;  // the surfaces' rest frames
  Lanes<double> omega;  // the light's frequency there over that in the camera
  Lanes<std::int32_t> active;
  bool all_rest = false;  // all surfaces rest in the world: spares the boosts
};

// What comes from one light, if nothing is in between, to the active lanes.
struct IncidentLanes {
  WaveVectorLanes<in::World> k;  // from the event to the light, back in time
  Lanes<double> s_light;         // where the light is along k; infinite for a sun
  Vec3fLanes direction;          // unit, towards the light, in the surface's rest frame
  Vec3fLanes irradiance;         // of a surface across it there, times the emitter's factor
  Lanes<double> omega;  // the light's frequency in the light's rest frame over that in the camera
  // Where spectra matter: whose it is (an index into SceneSpectra), and its temperature, if it has one.
  Lanes<std::int32_t> spectrum;
  Lanes<float> kelvin;
  Lanes<std::int32_t> group;  // where parts of light are asked for: whose it is, by LightGroups
  Lanes<std::int32_t> active;
};

// How what a light sends becomes irradiance.
struct Irradiating {
  double light_speed = 1;  // scene lengths a second
  bool beaming = false;
};

// What a point, spot or sun sends to the events. Nothing comes from a light at the event itself, and
// where its spot or clock is dark.
void incident(const LightPlace& place, const EventLanes<in::World>& event, const LitLanes& lit,
              const Irradiating& settings, TemporalEvaluator& evaluator, IncidentLanes& incident);

// What an environment radiates in a direction (unit, its rest frame), when its clock shows `clock`.
Vec3f sky_radiance(const LightPlace& place, const Vec3& direction, double clock,
                   TemporalEvaluator& evaluator);

// Radiance from an environment along a ray, times the emitter's factor.
Vec3f environment_radiance(const LightPlace& place, const Event<in::World>& origin,
                           const WaveVector<in::World>& k, bool beaming,
                           TemporalEvaluator& evaluator);

}  // namespace restframe
