#include "tracer/light_sampling.h"
#include "physics/clones.h"

#include <cmath>
#include <limits>

#include "physics/doppler.h"
#include "tracer/light_arrival.h"
#include "tracer/light_emission.h"

namespace restframe {
namespace {

void scale_irradiance(const Irradiating& settings, const Arrival& arrival,
                      const Lanes<double>& length, IncidentLanes& incident) {
  const bool beaming = settings.beaming;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double squared = arrival.doppler[i] * arrival.doppler[i];
    const float emitter = beaming ? static_cast<float>(squared * squared) : 1.0F;
    const float factor = emitter / static_cast<float>(length[i] * length[i]);
    incident.irradiance.set(i, incident.irradiance.at(i) * factor);
  }
}

void from_place(const LightPlace& place, const EventLanes<in::World>& event, const LitLanes& lit,
                const Irradiating& settings, TemporalEvaluator& evaluator,
                IncidentLanes& incident) {
  EventLanes<in::LightRest> at;
  to_light(place, event, at);
  Lanes<double> distance, clock;
  Vec3Lanes towards_light;
  const double clock_at_anchor = place.clock_at_anchor;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double d = std::sqrt(glm::dot(at.x.at(i), at.x.at(i)));
    distance[i] = d;
    clock[i] = at.t[i] - d + clock_at_anchor;
    towards_light.set(i, at.x.at(i) * (-1.0 / d));
    incident.active[i] = d > 0.0 ? lit.active[i] : 0;
  }
  set_emitted(*place.light, clock, evaluator, incident);
  if (place.light->kind == LightKind::spot) {
    narrow_to_spot(*place.light, clock, towards_light, incident);
  }
  Arrival arrival;
  arrive(place, lit, towards_light, arrival, incident);
  const double light_speed = settings.light_speed;
  Lanes<double> length;  // the distance in the surface's rest frame, in the unit of the intensity
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    incident.s_light[i] = distance[i] * arrival.doppler[i];
    length[i] = distance[i] * arrival.frequency[i] * light_speed;
  }
  scale_irradiance(settings, arrival, length, incident);
}

// The limit of a far point light: what is W/m^2 in the sun's frame has 1/D^2 of that where the
// distance has grown by D, before the emitter's factor.
void from_sun(const LightPlace& place, const EventLanes<in::World>& event, const LitLanes& lit,
              const Irradiating& settings, TemporalEvaluator& evaluator, IncidentLanes& incident) {
  EventLanes<in::LightRest> at;
  to_light(place, event, at);
  const Vec3 direction = place.light->direction;
  Lanes<double> clock;
  Vec3Lanes towards_light;
  for (int i = 0; i < packet_size; ++i) {
    clock[i] = at.t[i] - glm::dot(direction, at.x.at(i)) + place.clock_at_anchor;
    towards_light.set(i, -direction);
  }
  incident.active = lit.active;
  set_emitted(*place.light, clock, evaluator, incident);
  Arrival arrival;
  arrive(place, lit, towards_light, arrival, incident);
  incident.s_light.fill(std::numeric_limits<double>::infinity());
  scale_irradiance(settings, arrival, arrival.frequency, incident);
}

}  // namespace

std::vector<LightPlace> light_places(const Scene& scene) {
  std::vector<LightPlace> places;
  for (const Light& light : scene.lights) {
    const Worldline& line = light.worldline;
    LightPlace place;
    place.light = &light;
    place.frame = {line.reference, Boost<in::LightRest, in::World>(line.velocity)};
    place.world_from_light = place.frame.from_world.inverse();
    place.clock_at_anchor = light.frame_clock
                                ? place.frame.from_world(line.reference - Event<in::World>{}).t
                                : light.clock;
    if (light.sky_map >= 0)
      place.sky_map = &scene.sky_maps[static_cast<std::size_t>(light.sky_map)];
    places.push_back(place);
  }
  return places;
}

RESTFRAME_CLONES void incident(const LightPlace& place, const EventLanes<in::World>& event,
                               const LitLanes& lit, const Irradiating& settings,
                               TemporalEvaluator& evaluator, IncidentLanes& incident) {
  switch (place.light->kind) {
    case LightKind::point:
    case LightKind::spot:
      return from_place(place, event, lit, settings, evaluator, incident);
    case LightKind::sun:
      return from_sun(place, event, lit, settings, evaluator, incident);
    case LightKind::environment:
      incident.active.fill(0);
  }
}

Vec3f sky_radiance(const LightPlace& place, const Vec3& direction, double clock,
                   TemporalEvaluator& evaluator) {
  const Vec3f everywhere = emitted(*place.light, clock, evaluator);
  if (place.sky_map == nullptr) return everywhere;
  const Vec3 in_map = direction * place.light->rest_from_map;
  return everywhere * radiance_at(*place.sky_map, sky_place(*place.sky_map, in_map));
}

Vec3f environment_radiance(const LightPlace& place, const Event<in::World>& origin,
                           const WaveVector<in::World>& k, bool beaming,
                           TemporalEvaluator& evaluator) {
  const double clock = place.frame(origin).t + place.clock_at_anchor;
  const WaveVector<in::LightRest> there = place.frame.from_world(k);
  return sky_radiance(place, sight_direction(there), clock, evaluator) *
         emitter_factor(beaming, doppler_factor(there));
}

}  // namespace restframe
