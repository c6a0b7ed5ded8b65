#include "tracer/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "physics/clones.h"
#include "tracer/light_arrival.h"
#include "tracer/light_emission.h"

namespace restframe {
namespace {

constexpr double everywhere = 1.0 / (4.0 * glm::pi<double>());  // per steradian

// A sky that moves past a surface and beams is brighter by D^8 in front than behind: from here on it
// is worth a search for where its light comes from.
constexpr double least_gamma = 1.1;

bool beams_unevenly(const Scene& scene, const Light& sky) {
  if (!scene.render.beaming) return false;
  const Boost<in::LightRest, in::World> sky_from_world(sky.worldline.velocity);
  return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
    const Velocity& velocity = object.worldline.velocity;
    const Displacement<in::World> along{velocity.gamma(), velocity.gamma_beta()};
    return sky_from_world(along).t > least_gamma;
  });
}

std::optional<Vec3f> uniform_radiance(const Scene& scene, const LightPlace& place) {
  const Light& sky = *place.light;
  const bool constant = sky.color.function == no_function && sky.intensity.function == no_function;
  if (!constant || place.sky_map != nullptr || scene.render.beaming) return std::nullopt;
  return glm::max(sky.color.value * sky.intensity.value, Vec3f(0));
}

SkyDistribution::Chosen choose_direction(const Environment& environment, float u, float v) {
  if (environment.distribution == nullptr) {
    const double z = 1.0 - 2.0 * static_cast<double>(v);
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double phi = 2.0 * glm::pi<double>() * static_cast<double>(u);
    return {{r * std::cos(phi), r * std::sin(phi), z}, everywhere};
  }
  SkyDistribution::Chosen chosen =
      environment.distribution->choose(static_cast<double>(u), static_cast<double>(v));
  chosen.direction = environment.place.light->rest_from_map * chosen.direction;
  return chosen;
}

}  // namespace

std::vector<Environment> environments(const Scene& scene) {
  std::vector<Environment> all;
  for (const LightPlace& place : light_places(scene)) {
    if (place.light->kind != LightKind::environment) continue;
    Environment& environment = all.emplace_back();
    environment.place = place;
    environment.is_sampled = beams_unevenly(scene, *place.light);
    environment.uniform = uniform_radiance(scene, place);
    if (place.sky_map == nullptr) continue;
    environment.distribution = std::make_unique<const SkyDistribution>(*place.sky_map);
    environment.is_sampled = !environment.distribution->empty();
  }
  return all;
}

double sky_density(const Environment& environment, const Vec3& direction) {
  if (environment.distribution == nullptr) return everywhere;
  return environment.distribution->density(direction * environment.place.light->rest_from_map);
}

// Solid angles shrink by D^2 from the sky's rest frame to the surface's, so densities grow by it.
RESTFRAME_CLONES void incident_from_sky(const Environment& environment,
                                        const EventLanes<in::World>& event, const LitLanes& lit,
                                        const Irradiating& settings, const Lanes<float>& u,
                                        const Lanes<float>& v, TemporalEvaluator& evaluator,
                                        IncidentLanes& incident, Lanes<double>& density) {
  const LightPlace& place = environment.place;
  EventLanes<in::LightRest> at;
  to_light(place, event, at);
  Vec3Lanes towards;
  for (int i = 0; i < packet_size; ++i) {
    const SkyDistribution::Chosen chosen = choose_direction(environment, u[i], v[i]);
    towards.set(i, chosen.direction);
    density[i] = chosen.density;
  }
  Arrival arrival;
  arrive(place, lit, towards, arrival, incident);
  incident.s_light.fill(std::numeric_limits<double>::infinity());
  Lanes<double> clock;
  for (int i = 0; i < packet_size; ++i) {
    density[i] *= arrival.frequency[i] * arrival.frequency[i];
    incident.active[i] = density[i] > 0.0 ? lit.active[i] : 0;
    if (incident.active[i] == 0) continue;
    const Vec3f radiance =
        sky_radiance(place, towards.at(i), at.t[i] + place.clock_at_anchor, evaluator);
    const float factor =
        emitter_factor(settings.beaming, arrival.doppler[i]) / static_cast<float>(density[i]);
    incident.irradiance.set(i, radiance * factor);
    clock[i] = at.t[i] + place.clock_at_anchor;
  }
  set_temperature(*place.light, clock, evaluator, incident);
}

}  // namespace restframe
