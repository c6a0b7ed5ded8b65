// Light that comes straight from lights to the vertices of 16 paths.

#include "tracer/path_walk.h"

namespace restframe {
namespace {

constexpr std::uint32_t most_layers = 1000;
constexpr float least_light = 1e-4F;  // what is dimmed below this fraction is dark

}  // namespace

void PathWalk::add_lights() {
  for (const LightPlace& light : stage_.lights) add_light(light);
}

void PathWalk::add_light(const LightPlace& light) {
  const RenderSettings& settings = stage_.scene.render;
  RayPacket shadows;
  shadows.coherent = false;  // they begin wherever the paths are
  Lanes<double> s_max;
  Lanes<Vec3f> arriving;
  bool any = false;
  for (int lane = 0; lane < packet_size; ++lane) {
    shadows.active[lane] = 0;
    if (lit_[lane] == 0) continue;
    const Vertex& vertex = vertices_[lane];
    const auto from_light =
        incident(light, vertex.lit, stage_.scene.light_speed, settings.beaming, evaluator_);
    if (!from_light) continue;
    arriving[lane] = scattered_fraction(vertex.bsdf, from_light->direction) *
                     from_light->irradiance * vertex.throughput;
    if (!(arriving[lane] != Vec3f(0))) continue;
    const RestFrame& frame = stage_.frames.frame(hits_.frame[lane]);
    const Vec3 x = vertex.lit.omega * Vec3(from_light->direction);
    shadows.origin.set(lane, vertex.lit.event);
    shadows.k.set(lane, from_light->k);
    shadows.s_min[lane] = frame.s_clear(hits_, lane, vertex.lit.event, x);
    shadows.active[lane] = -1;
    s_max[lane] = from_light->s_light;
    any = true;
  }
  if (!any) return;
  const Lanes<std::int32_t> reached = shadows.active;
  let_through(shadows, s_max, arriving);
  for (int lane = 0; lane < packet_size; ++lane) {
    if (reached[lane] != 0) states_[lane].radiance += arriving[lane];
  }
}

// Dims what arrives by all that is in its way.
void PathWalk::let_through(RayPacket& shadows, const Lanes<double>& s_max, Lanes<Vec3f>& arriving) {
  if (!stage_.has_see_through) {
    Lanes<std::int32_t> blocked;
    stage_.frames.find_blocked(shadows, s_max, blocked);
    for (int lane = 0; lane < packet_size; ++lane) {
      if (blocked[lane] != 0) arriving[lane] = Vec3f(0);
    }
    return;
  }
  Lanes<float> left;
  left.fill(1.0F);
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
  for (int lane = 0; lane < packet_size; ++lane) arriving[lane] *= left[lane];
}

}  // namespace restframe
