#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "physics/worldline.h"
#include "scene/emission_spectrum.h"
#include "scene/temporal_function.h"

namespace restframe {

enum class LightKind : std::uint8_t {
  point,
  spot,
  sun,          // a plane wave; its wavefronts carry its clock as if they left its position
  environment,  // radiance from infinity: the same from everywhere, or a map's, in its rest frame
};

// Turns a spot's direction about `axis` (unit, right-handed) once in `period` seconds of the
// light's clock; at clock 0 it is the light's direction.
struct Sweep {
  Vec3 axis{0, 1, 0};
  double period = 1;
};

// Something that shines, with a velocity and a clock of its own. Directions are in its rest frame.
struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  Worldline worldline;
  double clock = 0;          // what its clock shows at the worldline's reference ...
  bool frame_clock = false;  // ... or: the rest frame's own time, zero at the world's origin event
  Vec3 direction{0, 0, -1};  // in which its light goes; unit; spot and sun
  std::optional<Sweep> sweep;                             // spot
  double inner_cone = 0, outer_cone = 0.785398163397448;  // half-angles in radians; spot
  // Of D65 light; or what a filter before the spectrum lets through.
  TemporalColor color{Vec3f(1)};
  TemporalNumber temperature{0.0F};  // of a blackbody, K; 0: it is none
  EmissionSpectrum spectrum;
  // point, spot: W/sr; sun: W/m^2 across its direction, in its rest frame; environment: radiance.
  // Metres are scene lengths.
  TemporalNumber intensity{1.0F};
  // environment: an index into Scene::sky_maps, whose radiance multiplies colour and intensity; -1:
  // none. How the map is turned in the light's rest frame: a rotation.
  int sky_map = -1;
  Mat3 rest_from_map{1};
  std::string group;  // names a layer
};

}  // namespace restframe
