// Light that comes straight from lights to the vertices of 16 paths.

#include "frames/lane_groups.h"
#include "physics/clones.h"
#include "tracer/path_walk.h"

namespace restframe {
namespace {

constexpr std::uint32_t most_layers = 1000;
constexpr float least_light = 1e-4F;  // what is dimmed below this fraction is dark

// Of a light with emission lines: colours before they became those of the paths' wavelengths.
struct LineLight {
  Vec3fLanes color, scattered;
};

}  // namespace

// Where all surfaces rest in the world, nobody asks for their boosts.
void PathWalk::find_rest_frames(LitLanes& lit) const {
  lit.all_rest = true;
  for (int i = 0; i < packet_size; ++i) {
    if (lit.active[i] == 0) continue;
    lit.rest_from_world[i] = &stage_.frames.frame(hits_.frame[i]).coordinates().from_world;
    lit.all_rest = lit.all_rest && lit.rest_from_world[i]->is_identity();
  }
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
  ViewLobeLanes lobes;
  view_lobes(vertices_.bsdf, lobes);
  for (const LightPlace& light : stage_.lights) add_light(light, lit, lobes);
}

RESTFRAME_CLONES void PathWalk::add_light(const LightPlace& light, const LitLanes& lit,
                                          const ViewLobeLanes& lobes) {
  const HitEvents& at = vertices_.at;
  IncidentLanes from_light;
  incident(light, at.event, lit, {stage_.scene.light_speed, stage_.scene.render.beaming},
           evaluator_, from_light);
  Vec3fLanes arriving;
  scattered_fraction(vertices_.bsdf, lobes, from_light.direction, arriving);
  const bool has_lines = follows_lines() && stage_.spectrum_of(light).has_lines();
  LineLight line_light;
  if (has_lines) line_light = {from_light.irradiance, arriving};
  light_by_wavelength(light, from_light);
  if (stage_.spectra.shifts) to_wavelengths(from_light.active, arriving);
  RayPacket shadows;
  shadows.coherent = false;  // they begin wherever the paths are
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3f light_of_lane =
        arriving.at(i) * from_light.irradiance.at(i) * paths_.throughput.at(i);
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
  let_through(shadows, from_light.s_light, left);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const float left_of_lane = left[i];
    const bool lights = (reached[i] != 0) & (left_of_lane > 0.0F);
    paths_.radiance.x[i] += lights ? arriving.x[i] * left[i] : 0.0F;
    paths_.radiance.y[i] += lights ? arriving.y[i] * left[i] : 0.0F;
    paths_.radiance.z[i] += lights ? arriving.z[i] * left[i] : 0.0F;
  }
  for (int i = 0; has_lines && i < packet_size; ++i) {
    if (reached[i] == 0 || left[i] <= 0.0F) continue;
    const Vec3f scattered = line_light.scattered.at(i);
    receive_lines(i, stage_.spectrum_of(light), line_light.color.at(i) * left[i],
                  from_light.omega[i], &scattered);
  }
}

// The fraction that is left of light by all that is in its way.
void PathWalk::let_through(RayPacket& shadows, const Lanes<double>& s_max, Lanes<float>& left) {
  left.fill(1.0F);
  if (stage_.has_see_through) return dim(shadows, s_max, left);
  Lanes<std::int32_t> blocked;
  stage_.frames.find_blocked(shadows, s_max, blocked);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) left[i] = blocked[i] != 0 ? 0.0F : 1.0F;
}

// By layer after layer of what may be seen through.
void PathWalk::dim(RayPacket& shadows, const Lanes<double>& s_max, Lanes<float>& left) {
  HitPacket hits;
  SurfaceLanes surfaces;
  bool passing = true;
  for (std::uint32_t layer = 0; passing && layer < most_layers; ++layer) {
    stage_.frames.nearest(shadows, hits);
    surfaces_at(stage_.scene, stage_.frames, hits, shadows.active, surfaces);
    passing = false;
    for (int lane = 0; lane < packet_size; ++lane) {
      if (shadows.active[lane] == 0) continue;
      shadows.active[lane] = 0;
      if (hits.frame[lane] < 0) continue;
      stage_.frames.refine(hits, lane);
      const double s_behind = stage_.frames.frame(hits.frame[lane]).s_behind(hits, lane);
      if (s_behind >= s_max[lane]) continue;
      const MetSurface met{stage_.scene, stage_.frames, surfaces, hits, lane};
      const ObjectPlace& place = stage_.places[static_cast<std::size_t>(surfaces.object[lane])];
      const Vec4f texture = texel(met, met.material().base_color_texture);
      left[lane] *= 1.0F - opacity(met, texture.w, clock_at(place, hits, lane), evaluator_);
      if (left[lane] < least_light) left[lane] = 0.0F;
      if (left[lane] == 0.0F) continue;
      shadows.s_min[lane] = s_behind;
      shadows.active[lane] = -1;
      passing = true;
    }
  }
}

}  // namespace restframe
