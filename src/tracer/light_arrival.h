#pragma once

// How rays from surface events to lights are changed on their way between the two rest frames.

#include "frames/lane_groups.h"
#include "tracer/light_sampling.h"

namespace restframe {

inline void to_light(const LightPlace& place, const EventLanes<in::World>& event,
                     EventLanes<in::LightRest>& at) {
  const AnchoredFrame<in::LightRest> frame = place.frame;
  if (frame.from_world.is_identity()) {
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      const Displacement<in::World> d = event.at(i) - frame.anchor;
      at.set(i, {d.t, d.x});
    }
    return;
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) at.set(i, frame(event.at(i)));
}

// A ray as the surfaces have it.
inline void to_surfaces(const LitLanes& lit, const WaveVectorLanes<in::World>& k,
                        WaveVectorLanes<in::Rest>& at_surface) {
  for_each_group(lit.rest_from_world, lit.active, [&](int first, const Lanes<std::int32_t>& group) {
    WaveVectorLanes<in::Rest> there;
    transform(*lit.rest_from_world[first], k, there);
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      set_in(group, i, at_surface.t, there.t[i]);
      set_in(group, i, at_surface.x, there.x.at(i));
    }
  });
}

struct Arrival {
  Lanes<double>
      frequency;          // in the surface's rest frame, of a ray of unit frequency in the light's
  Lanes<double> doppler;  // D of the light
};

// Light and surfaces rest in the world: one frequency everywhere.
inline void arrive_at_rest(const LitLanes& lit, const Vec3Lanes& towards_light, Arrival& arrival,
                           IncidentLanes& incident) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double omega = lit.omega[i];
    arrival.frequency[i] = 1.0;
    arrival.doppler[i] = 1.0 / omega;
    incident.omega[i] = omega;
    incident.direction.set(i, Vec3f(towards_light.at(i)));
    incident.k.t[i] = -omega;
    incident.k.x.set(i, towards_light.at(i) * omega);
  }
}

// Rays that look along `towards_light` in the light's frame, with the frequency that the paths ask
// for; D of the light follows.
inline void arrive(const LightPlace& place, const LitLanes& lit, const Vec3Lanes& towards_light,
                   Arrival& arrival, IncidentLanes& incident) {
  if (lit.all_rest && place.world_from_light.is_identity()) {
    return arrive_at_rest(lit, towards_light, arrival, incident);
  }
  WaveVectorLanes<in::LightRest> leaving;
  leaving.t.fill(-1.0);
  leaving.x = towards_light;
  transform(place.world_from_light, leaving, incident.k);
  WaveVectorLanes<in::Rest> at_surface;
  to_surfaces(lit, incident.k, at_surface);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const WaveVector<in::Rest> k = at_surface.at(i);
    const double omega_emitted = lit.omega[i] / -k.t;
    arrival.frequency[i] = -k.t;
    arrival.doppler[i] = -k.t / lit.omega[i];
    incident.omega[i] = omega_emitted;
    incident.direction.set(i, Vec3f(sight_direction(k)));
    incident.k.t[i] *= omega_emitted;
    incident.k.x.set(i, incident.k.x.at(i) * omega_emitted);
  }
}

}  // namespace restframe
