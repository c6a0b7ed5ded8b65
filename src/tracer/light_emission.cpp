#include "tracer/light_emission.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

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

bool is_constant(const Light& light) {
  return light.color.function == no_function && light.intensity.function == no_function;
}

}  // namespace

Vec3f emitted(const Light& light, double clock, TemporalEvaluator& evaluator) {
  // Formulas may ask for less than nothing.
  return glm::max(evaluator(light.color, clock) * evaluator(light.intensity, clock), Vec3f(0));
}

void set_temperature(const Light& light, const Lanes<double>& clock, TemporalEvaluator& evaluator,
                     IncidentLanes& incident) {
  const TemporalNumber& temperature = light.temperature;
  if (temperature.function == no_function) return incident.kelvin.fill(temperature.value);
  for (int i = 0; i < packet_size; ++i) {
    if (incident.active[i] != 0) incident.kelvin[i] = evaluator(temperature, clock[i]);
  }
}

void set_emitted(const Light& light, const Lanes<double>& clock, TemporalEvaluator& evaluator,
                 IncidentLanes& incident) {
  set_temperature(light, clock, evaluator, incident);
  if (is_constant(light)) {
    const Vec3f always = emitted(light, 0.0, evaluator);
    incident.irradiance.x.fill(always.x);
    incident.irradiance.y.fill(always.y);
    incident.irradiance.z.fill(always.z);
    if (always == Vec3f(0)) incident.active.fill(0);
    return;
  }
  for (int i = 0; i < packet_size; ++i) {
    if (incident.active[i] == 0) continue;
    const Vec3f now = emitted(light, clock[i], evaluator);
    incident.irradiance.set(i, now);
    if (now == Vec3f(0)) incident.active[i] = 0;
  }
}

void narrow_to_spot(const Light& light, const Lanes<double>& clock, const Vec3Lanes& towards_light,
                    IncidentLanes& incident) {
  for (int i = 0; i < packet_size; ++i) {
    if (incident.active[i] == 0) continue;
    const float factor = spot_factor(light, clock[i], -towards_light.at(i));
    incident.irradiance.set(i, incident.irradiance.at(i) * factor);
    if (incident.irradiance.at(i) == Vec3f(0)) incident.active[i] = 0;
  }
}

}  // namespace restframe
