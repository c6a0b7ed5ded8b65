#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "physics/spectrum.h"
#include "scene/validate_data.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

// Degrees that a person wrote may be rounded up.
constexpr double right_angle = std::numbers::pi / 2 * (1 + 1e-12);

// False for NaN.
bool is_unit(const Vec3& v) {
  return std::abs(glm::length(v) - 1) < 1e-6;
}

void check_cone(const Light& light, const std::string& name, Faults& faults) {
  const double inner = light.inner_cone, outer = light.outer_cone;
  if (inner >= 0 && inner <= outer && outer > 0 && outer <= right_angle) return;
  faults.push_back(
      fmt::format("{}: cone is [{}, {}] degrees, must be from 0 to 90, the inner one at most the "
                  "outer one, which is above 0",
                  name, glm::degrees(inner), glm::degrees(outer)));
}

void check_sweep(const Sweep& sweep, const std::string& name, Faults& faults) {
  if (!is_unit(sweep.axis)) faults.push_back(name + ": the axis of sweep must be of length 1");
  if (sweep.period > 0 && std::isfinite(sweep.period)) return;
  faults.push_back(
      fmt::format("{}: the period of sweep is {}, must be above 0 and finite", name, sweep.period));
}

}  // namespace

void validate_spectrum(const Scene& scene, const TemporalNumber& temperature,
                       const EmissionSpectrum& spectrum, const std::string& name, Faults& faults) {
  validate_number(scene, temperature, name + ": temperature", faults,
                  {0, static_cast<float>(hottest_kelvin)});
  for (const std::string& fault : spectrum_faults(temperature, spectrum)) {
    faults.push_back(name + ": " + fault);
  }
}

void validate_light(const Scene& scene, const Light& light, const std::string& name,
                    Faults& faults) {
  if (!std::isfinite(light.clock)) faults.push_back(name + ": clock must be finite");
  if (!is_unit(light.direction)) faults.push_back(name + ": direction must be of length 1");
  check_cone(light, name, faults);
  // A plane wave that turned would show each place another retarded direction.
  if (light.sweep && light.kind != LightKind::spot)
    faults.push_back(name + ": sweep goes with spots only");
  if (light.sweep) check_sweep(*light.sweep, name, faults);
  validate_color(scene, light.color, name + ": color", faults);
  validate_number(scene, light.intensity, name + ": intensity", faults);
  validate_spectrum(scene, light.temperature, light.spectrum, name, faults);
}

}  // namespace restframe
