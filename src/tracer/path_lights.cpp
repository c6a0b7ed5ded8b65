// Light that comes straight from lights to the vertices of 16 paths.

#include "frames/lane_groups.h"
#include "physics/clones.h"
#include "tracer/path_walk.h"

namespace restframe {

// Where all surfaces rest in the world, nobody asks for their boosts.
void PathWalk::find_rest_frames(LitLanes& lit) const {
  if (stage_.frames.frames().size() == 1) {
    const Boost<in::Rest, in::World>& boost = stage_.frames.frame(0).coordinates().from_world;
    lit.all_rest = boost.is_identity();
    return lit.rest_from_world.fill(&boost);
  }
  lit.all_rest = true;
  for_each_group(hits_.frame, lit.active, [&](int first, const Lanes<std::int32_t>& group) {
    const Boost<in::Rest, in::World>* boost =
        &stage_.frames.frame(hits_.frame[first]).coordinates().from_world;
    lit.all_rest = lit.all_rest && boost->is_identity();
    for (int i = 0; i < packet_size; ++i) set_in(group, i, lit.rest_from_world, boost);
  });
}

void PathWalk::add_lights() {
  LitLanes lit;
  lit.omega = paths_.omega;
  lit.active = vertices_.active;
  for (int i = 0; inside_ && i < packet_size; ++i) {
    if (in_medium(i)) lit.active[i] = 0;
  }
  if (!any_active(lit.active)) return;
  find_rest_frames(lit);
  const ViewLobeLanes& lobes = vertices_.lobes;
  for (const LightPlace& light : stage_.lights) add_light(light, lit, lobes);
  if (!stage_.emitters.empty()) add_emitters(lit, lobes);
  for (const Environment& sky : stage_.environments) {
    if (sky.is_sampled) add_sky(sky, lit, lobes);
  }
}

RESTFRAME_CLONES void PathWalk::add_light(const LightPlace& light, const LitLanes& lit,
                                          const ViewLobeLanes& lobes) {
  IncidentLanes from_light;
  incident(light, vertices_.at.event, lit, {stage_.scene.light_speed, stage_.scene.render.beaming},
           evaluator_, from_light);
  if (stage_.spectra.matters) from_light.spectrum.fill(stage_.spectrum_of(light));
  if (parts_.are_wanted()) from_light.group.fill(stage_.group_of(light));
  Vec3fLanes fraction;
  Lanes<float> by_chance;
  scattered_fraction(vertices_.bsdf, lobes, from_light.direction, fraction, by_chance);
  darken_insides(from_light);
  add_arriving(from_light, lit, fraction, ShadowKind::of_lamps);
}

// What comes from below a surface has come through a body, whose surface refracts it: paths find such
// light by chance alone.
void PathWalk::darken_insides(IncidentLanes& from) const {
  const BsdfLanes& bsdf = vertices_.bsdf;
  if (!bsdf.layered) return;
  for (int lane = 0; lane < packet_size; ++lane) {
    const bool below = glm::dot(bsdf.facet.at(lane), from.direction.at(lane)) <= 0.0F;
    if (below && bsdf.layers.thin[lane] == 0) from.active[lane] = 0;
  }
}

// fraction: that the vertices scatter towards the paths, of light from there.
RESTFRAME_CLONES void PathWalk::add_arriving(const IncidentLanes& from_light, const LitLanes& lit,
                                             const Vec3fLanes& fraction, ShadowKind kind) {
  const HitEvents& at = vertices_.at;
  const Vec3fLanes *irradiance = &from_light.irradiance, *scattered = &fraction;
  ArrivingLanes by_lane;
  if (stage_.spectra.matters) {
    by_wavelength(from_light, fraction, by_lane);
    irradiance = &by_lane.irradiance;
    scattered = &by_lane.fraction;
  }
  const bool has_lines = follows_lines();
  Vec3fLanes arriving;
  RayPacket shadows;
  shadows.coherent = rays_.coherent;  // those of what the camera sees begin close together
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3f light_of_lane = scattered->at(i) * irradiance->at(i) * paths_.throughput.at(i);
    arriving.set(i, light_of_lane);
    const bool dark =
        (light_of_lane.x == 0.0F) & (light_of_lane.y == 0.0F) & (light_of_lane.z == 0.0F);
    shadows.active[i] = (dark & !has_lines) ? 0 : from_light.active[i];
  }
  if (!any_active(shadows.active)) return;
  shadows.origin = at.event;
  shadows.k = from_light.k;
  stage_.frames.find_clear(hits_, at, from_light.direction, lit.omega, shadows.active,
                           shadows.s_min);
  const Lanes<std::int32_t> reached = shadows.active;
  Lanes<float> left;
  let_through(shadows, from_light.s_light, kind, left);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const float left_of_lane = left[i];
    const bool lights = (reached[i] != 0) & (left_of_lane > 0.0F);
    paths_.radiance.x[i] += lights ? arriving.x[i] * left[i] : 0.0F;
    paths_.radiance.y[i] += lights ? arriving.y[i] * left[i] : 0.0F;
    paths_.radiance.z[i] += lights ? arriving.z[i] * left[i] : 0.0F;
  }
  if (parts_.are_wanted()) note_arriving(from_light, fraction, arriving, reached, left);
  if (has_lines) receive_lines(from_light, fraction, reached, left);
}

}  // namespace restframe
