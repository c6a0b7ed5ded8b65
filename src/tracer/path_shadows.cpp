// What is left of light on its way from lights to the vertices of 16 paths.

#include "physics/clones.h"
#include "tracer/path_walk.h"

namespace restframe {
namespace {

constexpr std::uint32_t most_layers = 1000;
constexpr float least_light = 1e-4F;  // what a lamp is dimmed to below this fraction is dark

}  // namespace

// The fraction that is left of light by all that is in its way.
void PathWalk::let_through(RayPacket& shadows, const Lanes<double>& s_max, ShadowKind kind,
                           Lanes<float>& left) {
  left.fill(1.0F);
  if (stage_.has_see_through || kind == ShadowKind::as_paths_see) {
    return dim(shadows, s_max, kind, left);
  }
  Lanes<std::int32_t> blocked;
  stage_.frames.find_blocked(shadows, s_max, blocked);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) left[i] = blocked[i] != 0 ? 0.0F : 1.0F;
}

// By layer after layer of what may be seen through.
void PathWalk::dim(RayPacket& shadows, const Lanes<double>& s_max, ShadowKind kind,
                   Lanes<float>& left) {
  HitPacket hits;
  SurfaceLanes surfaces;
  bool passing = true;
  for (std::uint32_t layer = 0; passing && layer < most_layers; ++layer) {
    stage_.frames.nearest(shadows, s_max, hits);
    surfaces_at(stage_.scene, stage_.frames, hits, shadows.active, surfaces);
    passing = false;
    for (int lane = 0; lane < packet_size; ++lane) {
      if (shadows.active[lane] == 0) continue;
      shadows.active[lane] = 0;
      if (hits.frame[lane] < 0) continue;
      if (kind == ShadowKind::as_paths_see && stops_all(surfaces, lane)) {
        left[lane] = 0.0F;
        continue;
      }
      stage_.frames.refine(hits, lane);
      const double s_behind = stage_.frames.frame(hits.frame[lane]).s_behind(hits, lane);
      if (s_behind >= s_max[lane]) continue;
      left[lane] *= 1.0F - stopped({stage_.scene, stage_.frames, surfaces, hits, lane,
                                    &stage_.tables, cone_width(lane)},
                                   kind);
      if (kind == ShadowKind::of_lamps && left[lane] < least_light) left[lane] = 0.0F;
      if (left[lane] == 0.0F) continue;
      shadows.s_min[lane] = s_behind;
      shadows.active[lane] = -1;
      passing = true;
    }
  }
}

// What paths can not pass, whatever else it is.
bool PathWalk::stops_all(const SurfaceLanes& surfaces, int lane) const {
  const PlainMaterial& plain = stage_.plain[static_cast<std::size_t>(surfaces.material[lane])];
  return plain.always && (surfaces.back[lane] == 0 || plain.double_sided);
}

// The part of light that a surface stops.
float PathWalk::stopped(const MetSurface& met, ShadowKind kind) {
  const auto object = static_cast<std::size_t>(met.surfaces.object[met.lane]);
  const double clock = clock_at(stage_.places[object], met.hits, met.lane);
  const float alpha = texel(met, met.material().base_color_texture).w;
  return kind == ShadowKind::of_lamps ? opacity(met, alpha, clock, evaluator_)
                                      : coverage(met, alpha, clock, evaluator_);
}

}  // namespace restframe
