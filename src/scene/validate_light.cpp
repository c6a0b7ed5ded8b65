#include <fmt/format.h>

#include <algorithm>
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
bool is_radiance(const Vec3f& v) {
  return is_finite(v) && v.x >= 0.0F && v.y >= 0.0F && v.z >= 0.0F;
}

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

void check_sky_map(const Scene& scene, const Light& light, const std::string& name,
                   Faults& faults) {
  if (light.sky_map == -1) return;
  if (light.kind != LightKind::environment) {
    faults.push_back(name + ": a sky map goes with environments only");
  }
  if (light.sky_map < -1 || light.sky_map >= static_cast<int>(scene.sky_maps.size())) {
    faults.push_back(
        fmt::format("{} refers to sky map {} of {}", name, light.sky_map, scene.sky_maps.size()));
  }
  const Mat3 product = light.rest_from_map * glm::transpose(light.rest_from_map);
  bool is_rotation = glm::determinant(light.rest_from_map) > 0;
  for (int i = 0; i < 3; ++i) {
    is_rotation = is_rotation && glm::length(product[i] - Mat3(1)[i]) < 1e-6;
  }
  if (!is_rotation) faults.push_back(name + ": its sky map must be turned by a rotation");
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

void validate_sky_map(const SkyMap& map, Faults& faults) {
  const std::string name = fmt::format("sky map \"{}\"", map.name);
  const bool positive = map.width > 0 && map.height > 0;
  const std::size_t count = positive ? std::size_t{1} * map.width * map.height : 0;
  if (!positive || map.pixels.size() != count) {
    faults.push_back(fmt::format("{} has {} pixels for {} x {}", name, map.pixels.size(), map.width,
                                 map.height));
  }
  const auto bad = std::find_if_not(map.pixels.begin(), map.pixels.end(), is_radiance);
  if (bad == map.pixels.end()) return;
  faults.push_back(fmt::format("{} has the pixel [{}, {}, {}], must be at least 0 and finite", name,
                               bad->x, bad->y, bad->z));
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
  check_sky_map(scene, light, name, faults);
}

}  // namespace restframe
