#include "tracer/light_sampling.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "physics/doppler.h"

namespace restframe {
namespace {

// Rodrigues' rotation of the light's direction to where its sweep has brought it.
Vec3 direction_at(const Light& light, double clock) {
  if (!light.sweep) return light.direction;
  const double turns = clock / light.sweep->period;
  const double angle = 2.0 * glm::pi<double>() * (turns - std::floor(turns));
  const Vec3& axis = light.sweep->axis;
  const Vec3& d = light.direction;
  return std::cos(angle) * d + std::sin(angle) * glm::cross(axis, d) +
         (1.0 - std::cos(angle)) * glm::dot(axis, d) * axis;
}

// 1 - cos, without the loss of digits of small angles: a laser's cone is as exact as a lamp's.
double one_minus_cos(double angle) {
  const double s = std::sin(0.5 * angle);
  return 2.0 * s * s;
}

// As KHR_lights_punctual has it: smooth between the cones.
float spot_factor(const Light& light, double clock, const Vec3& outwards) {
  const Vec3 aside = direction_at(light, clock) - outwards;
  const double outer = one_minus_cos(light.outer_cone);
  const double within = outer - 0.5 * glm::dot(aside, aside);
  const double width = outer - one_minus_cos(light.inner_cone);
  if (within <= 0.0) return 0.0F;
  const double inside = within < width ? within / width : 1.0;
  return static_cast<float>(inside * inside);
}

Vec3f emitted(const Light& light, double clock, TemporalEvaluator& evaluator) {
  // Formulas may ask for less than nothing.
  return glm::max(evaluator(light.color, clock) * evaluator(light.intensity, clock), Vec3f(0));
}

// A ray of unit frequency in the light's frame, as the surface has it.
struct Arrival {
  WaveVector<in::World> k;
  double frequency = 1;  // in the surface's rest frame
  Vec3f direction{0};
};

// Most lights and surfaces rest in the world: that costs nothing.
template <class To, class From>
WaveVector<To> boosted(const Boost<To, From>& to_from, const WaveVector<From>& k) {
  return to_from.is_identity() ? WaveVector<To>{k.t, k.x} : to_from(k);
}

Arrival arrival(const LightPlace& place, const LitEvent& lit, const Vec3& towards_light) {
  const WaveVector<in::World> k =
      boosted(place.world_from_light, looking_along<in::LightRest>(towards_light));
  const WaveVector<in::Rest> at_surface = boosted(lit.rest_from_world, k);
  return {k, -at_surface.t, Vec3f(sight_direction(at_surface))};
}

// Gives the ray the frequency that the path asks for; D of the light follows.
Incident with_frequency(const Arrival& arrival, double omega, double& doppler) {
  const double omega_emitted = omega / arrival.frequency;
  doppler = 1.0 / omega_emitted;
  Incident result;
  result.k = {arrival.k.t * omega_emitted, arrival.k.x * omega_emitted};
  result.direction = arrival.direction;
  return result;
}

std::optional<Incident> from_place(const LightPlace& place, const LitEvent& lit, double light_speed,
                                   bool beaming, TemporalEvaluator& evaluator) {
  const Event<in::LightRest> at = place.frame(lit.event);
  const double distance = glm::length(at.x);
  if (!(distance > 0.0)) return std::nullopt;
  const Vec3 outwards = at.x / distance;
  const double clock = at.t - distance + place.clock_at_anchor;
  Vec3f intensity = emitted(*place.light, clock, evaluator);
  if (place.light->kind == LightKind::spot) intensity *= spot_factor(*place.light, clock, outwards);
  if (intensity == Vec3f(0)) return std::nullopt;

  const Arrival arriving = arrival(place, lit, -outwards);
  double doppler = 1;
  Incident result = with_frequency(arriving, lit.omega, doppler);
  result.s_light = distance * doppler;
  // The distance in the surface's rest frame, in the unit of the intensity.
  const double distance_there = distance * arriving.frequency * light_speed;
  result.irradiance = intensity * (emitter_factor(beaming, doppler) /
                                   static_cast<float>(distance_there * distance_there));
  return result;
}

// The limit of a far point light: what is W/m^2 in the sun's frame has 1/D^2 of that where the
// distance has grown by D, before the emitter's factor.
std::optional<Incident> from_sun(const LightPlace& place, const LitEvent& lit, bool beaming,
                                 TemporalEvaluator& evaluator) {
  const Event<in::LightRest> at = place.frame(lit.event);
  const Vec3& direction = place.light->direction;
  const double clock = at.t - glm::dot(direction, at.x) + place.clock_at_anchor;
  const Vec3f irradiance = emitted(*place.light, clock, evaluator);
  if (irradiance == Vec3f(0)) return std::nullopt;
  const Arrival arriving = arrival(place, lit, -direction);
  double doppler = 1;
  Incident result = with_frequency(arriving, lit.omega, doppler);
  result.s_light = std::numeric_limits<double>::infinity();
  result.irradiance = irradiance * (emitter_factor(beaming, doppler) /
                                    static_cast<float>(arriving.frequency * arriving.frequency));
  return result;
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
    places.push_back(place);
  }
  return places;
}

std::optional<Incident> incident(const LightPlace& place, const LitEvent& lit, double light_speed,
                                 bool beaming, TemporalEvaluator& evaluator) {
  switch (place.light->kind) {
    case LightKind::point:
    case LightKind::spot:
      return from_place(place, lit, light_speed, beaming, evaluator);
    case LightKind::sun:
      return from_sun(place, lit, beaming, evaluator);
    case LightKind::environment:
      return std::nullopt;
  }
  return std::nullopt;
}

Vec3f environment_radiance(const LightPlace& place, const Event<in::World>& origin,
                           const WaveVector<in::World>& k, bool beaming,
                           TemporalEvaluator& evaluator) {
  const double clock = place.frame(origin).t + place.clock_at_anchor;
  const double doppler = doppler_factor(place.frame.from_world(k));
  return emitted(*place.light, clock, evaluator) * emitter_factor(beaming, doppler);
}

}  // namespace restframe
