#pragma once

// Point lights as surface events see them, by closed form 1, in long double without src/physics.

#include "support/long_vectors.h"

namespace restframe::reference {

// A light that is at `position` at world time `time`; there its clock shows `clock`.
struct MovingLight {
  Long3 gamma_beta;
  Long3 position;
  long double time = 0, clock = 0;
};

// The light's event on the past light cone of a surface event.
struct SeenLight {
  long double delay = 0;  // in the world
  Long3 sight;            // unit, towards the light, in the world
  Long4 event;
  long double clock = 0;
  // Frequencies in the frames of light and surface of what the world finds at frequency 1; also
  // their distances over the delay.
  long double at_light = 1, at_surface = 1;
  Long3 sight_at_light, sight_at_surface;
};

// surface: gamma beta of the surface.
inline SeenLight seen(const MovingLight& light, const Long4& e, const Long3& surface) {
  const Long3& u = light.gamma_beta;
  const long double gamma = gamma_of(u);
  const long double since = e.t - light.time;
  const Long3 now = light.position + (since / gamma) * u - e.x;
  const long double along = dot(now, u);
  SeenLight s;
  s.delay = gamma * (-along + std::sqrt(along * along + dot(now, now)));
  const Long3 place = now - (s.delay / gamma) * u;
  s.sight = normalized(place);
  s.event = {e.t - s.delay, place + e.x};
  s.clock = light.clock + (since - s.delay) / gamma;
  s.at_light = frequency_seen_from(u, s.sight);
  s.at_surface = frequency_seen_from(surface, s.sight);
  s.sight_at_light = normalized(boosted(u, {-1, s.sight}).x);
  s.sight_at_surface = normalized(boosted(surface, {-1, s.sight}).x);
  return s;
}

}  // namespace restframe::reference
