// Light by wavelength. Three lanes of a path are then three wavelengths of the camera in place of
// red, green and blue. What scatters weighs by a colour, once a surface; each wavelength takes of it
// what a surface of that colour reflects of the wavelength that the light has there.

#include <cmath>

#include "physics/clones.h"
#include "tracer/path_walk.h"

namespace restframe {
namespace {

// The digits of a whole number, in base 2, behind the point: a power of two of them from 0 on are
// evenly spaced.
float radical_inverse(std::uint32_t n) {
  float sum = 0, digit = 0.5F;
  for (; n != 0; n >>= 1, digit *= 0.5F) sum += (n & 1U) != 0 ? digit : 0.0F;
  return sum;
}

// In [0, 1), of numbers that are not negative.
float fraction(float x) {
  return x - std::floor(x);
}

// The hero and two more, evenly spaced over what is seen.
float chooser(float hero, int which) {
  return (hero + static_cast<float>(which)) * (1.0F / 3.0F);
}

}  // namespace

// Evenly spaced over the samples of a pixel, too, and turned by chance from pixel to pixel: every
// sample of it is without bias, and together they miss little of any smooth spectrum (of 16 samples of
// white a tenth of a per cent; a random number for each would leave about one).
void PathWalk::choose_wavelengths(const PacketId& id) {
  PacketId pixel = id;
  pixel.sample = 0;
  PacketRandom of_pixel(pixel);
  const Lanes<float>& turn = of_pixel.lanes(Dimension::wavelength, 0);
  const float of_sample = radical_inverse(id.sample);
  for (int lane = 0; lane < packet_size; ++lane) {
    const float hero = fraction(of_sample + turn[lane]);
    Vec3f wavelength;
    for (int i = 0; i < 3; ++i) {
      wavelength[i] = stage_.spectra.observer.sample(chooser(hero, i)).wavelength;
    }
    by_wavelength_.hero[lane] = hero;
    by_wavelength_.wavelength.set(lane, wavelength);
    if (parts_.are_wanted()) parts_.set_wavelengths(lane, color_from_lanes(hero));
  }
  by_wavelength_.omega.fill(0.0);
  by_wavelength_.color = {};
  by_wavelength_.direct.fill(-1);
  if (follows_lines()) history_.clear();
}

// What the three lanes of a path's light are shown as.
glm::mat3 PathWalk::color_from_lanes(float hero) const {
  glm::mat3 colors;
  for (int i = 0; i < 3; ++i) {
    colors[i] = stage_.spectra.observer.sample(chooser(hero, i)).rgb * (1.0F / 3.0F);
  }
  return colors;
}

RESTFRAME_CLONES void PathWalk::take_radiance(RadianceLanes& radiance) const {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    radiance[i] = Vec4f(paths_.radiance.at(i), paths_.coverage[i]);
  }
  for (int lane = 0; stage_.spectra.shifts && lane < packet_size; ++lane) {
    const Vec3f light = paths_.radiance.at(lane);
    Vec3f color = by_wavelength_.color.at(lane);
    for (int i = 0; i < 3; ++i) {
      const float choice = chooser(by_wavelength_.hero[lane], i);
      color += stage_.spectra.observer.sample(choice).rgb * (light[i] * (1.0F / 3.0F));
    }
    radiance[lane] = Vec4f(color, paths_.coverage[lane]);
  }
}

// What surfaces reflect changes with their velocities only.
void PathWalk::find_local_spectra() {
  for (int lane = 0; lane < packet_size; ++lane) {
    const double omega = paths_.omega[lane];
    if (met_[lane] == 0 || by_wavelength_.omega[lane] == omega) continue;
    by_wavelength_.omega[lane] = omega;
    const Vec3f wavelength = by_wavelength_.wavelength.at(lane) * static_cast<float>(1.0 / omega);
    for (int i = 0; i < 3; ++i) {
      by_wavelength_.local[lane][static_cast<std::size_t>(i)] = stage_.spectra.table(wavelength[i]);
    }
  }
}

Vec3f PathWalk::light_by_wavelength(int lane, const EmitterSpectrum& spectrum, const Vec3f& color,
                                    float kelvin, double omega) const {
  if (!stage_.spectra.shifts) return spectrum.color(color, kelvin);
  const bool local = omega == by_wavelength_.omega[lane];
  const auto doppler = static_cast<float>(1.0 / omega);
  const Vec3f wavelength = by_wavelength_.wavelength.at(lane) * doppler;
  Vec3f light;
  for (int i = 0; i < 3; ++i) {
    const Vec4f values = local ? by_wavelength_.local[lane][static_cast<std::size_t>(i)]
                               : stage_.spectra.table(wavelength[i]);
    light[i] = doppler * spectrum(wavelength[i], values, kelvin) * glm::dot(Vec3f(values), color);
  }
  return light;
}

void PathWalk::by_wavelength(const IncidentLanes& from_light, const Vec3fLanes& fraction,
                             ArrivingLanes& arriving) const {
  for (int lane = 0; lane < packet_size; ++lane) {
    if (from_light.active[lane] == 0) continue;
    const EmitterSpectrum& spectrum = stage_.spectra[from_light.spectrum[lane]];
    const Vec3f color = from_light.irradiance.at(lane);
    arriving.irradiance.set(lane,
                            light_by_wavelength(lane, spectrum, color, from_light.kelvin[lane],
                                                from_light.omega[lane]));
    arriving.fraction.set(lane, by_wavelength(lane, fraction.at(lane)));
  }
}

bool PathWalk::receive_direct(int lane, const Vec3f& color, double omega, std::int32_t group) {
  if (!stage_.spectra.shifted || by_wavelength_.direct[lane] == 0) return false;
  const Vec3f seen = (*stage_.spectra.shifted)(color, 1.0 / omega);
  by_wavelength_.color.set(lane, by_wavelength_.color.at(lane) + seen);
  if (parts_.are_wanted()) parts_.receive_straight(lane, group, seen);
  return true;
}

void PathWalk::receive_from_sky(const Environment& sky, int lane, const Vec3f& color) {
  const LightPlace& place = sky.place;
  const std::int32_t group = parts_.are_wanted() ? stage_.group_of(place) : 0;
  if (!stage_.spectra.matters) return receive(lane, color, group);
  const EmitterSpectrum& spectrum = stage_.spectra[stage_.spectrum_of(place)];
  const double omega = -place.frame.from_world(rays_.k.at(lane)).t;
  if (spectrum.is_daylight() && receive_direct(lane, color, omega, group)) return;
  const TemporalNumber& temperature = place.light->temperature;
  float kelvin = temperature.value;
  if (temperature.function != no_function) {
    const double clock = place.frame(rays_.origin.at(lane)).t + place.clock_at_anchor;
    kelvin = evaluator_(temperature, clock);
  }
  receive(lane, light_by_wavelength(lane, spectrum, color, kelvin, omega), group);
  if (follows_lines()) receive_lines(lane, spectrum, color, omega, group);
}

// What is left of it on its way to the vertices that are reached.
void PathWalk::receive_lines(const IncidentLanes& from_light, const Vec3fLanes& fraction,
                             const Lanes<std::int32_t>& reached, const Lanes<float>& left) {
  for (int lane = 0; lane < packet_size; ++lane) {
    if (reached[lane] == 0 || left[lane] <= 0.0F) continue;
    LobeSplit scattered{};
    scattered.all = fraction.at(lane);
    if (parts_.are_wanted()) {
      scattered = lobe_split(lane, from_light.direction.at(lane), fraction.at(lane), false);
    }
    receive_lines(lane, stage_.spectra[from_light.spectrum[lane]],
                  from_light.irradiance.at(lane) * left[lane], from_light.omega[lane],
                  parts_.are_wanted() ? from_light.group[lane] : 0, &scattered);
  }
}

void PathWalk::receive_lines(int lane, const EmitterSpectrum& spectrum, const Vec3f& color,
                             double omega, std::int32_t group, const LobeSplit* scattered) {
  const SpectrumTable& table = stage_.spectra.table;
  Vec3f sum = by_wavelength_.color.at(lane);
  for (const EmitterSpectrum::Line& line : spectrum.lines()) {
    const double seen = static_cast<double>(line.wavelength) * omega;
    const Vec3f response(stage_.spectra.observer.response(seen));
    if (response == Vec3f(0)) continue;
    const auto wavelength = static_cast<float>(seen);
    float left = line.power * glm::dot(Vec3f(table(line.wavelength)), color) *
                 history_.left(lane, wavelength, table);
    if (scattered != nullptr) {
      const auto local = static_cast<float>(seen / paths_.omega[lane]);
      left *= glm::dot(Vec3f(table(local)), scattered->all);
    }
    sum += left * response;
    if (!parts_.are_wanted()) continue;
    parts_.receive_line(lane, group, left * response, wavelength, table, scattered);
  }
  by_wavelength_.color.set(lane, sum);
}

}  // namespace restframe
