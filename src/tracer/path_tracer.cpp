#include "tracer/path_tracer.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/error.h"
#include "tracer/emitter_power.h"
#include "tracer/path_walk.h"

namespace restframe {
namespace {

constexpr std::uint64_t no_crossing = ~std::uint64_t{0};

}  // namespace

PathTracer::PathTracer(const Scene& scene, const FrameSet& frames, LightSearch search)
    : stage_{scene,
             frames,
             SurfaceTables(scene),
             object_places(scene, frames),
             {},
             {},
             environments(scene),
             search == LightSearch::by_chance ? Emitters() : Emitters(scene, frames),
             search,
             false,
             false,
             false,
             false,
             false,
             SceneSpectra(scene),
             LightGroups(scene)},
      crossed_media_(no_crossing) {
  for (Environment& sky : stage_.environments) {
    if (search == LightSearch::by_chance) sky.is_sampled = false;
  }
  for (const LightPlace& place : light_places(scene)) {
    if (place.light->kind != LightKind::environment) stage_.lights.push_back(place);
  }
  stage_.has_lights = !stage_.lights.empty() || !stage_.emitters.empty() ||
                      std::any_of(stage_.environments.begin(), stage_.environments.end(),
                                  [](const Environment& sky) { return sky.is_sampled; });
  stage_.has_clocks =
      !scene.functions.empty() || std::any_of(scene.lights.begin(), scene.lights.end(),
                                              [](const Light& l) { return l.sweep.has_value(); });
  stage_.has_emitters = !stage_.environments.empty();
  for (const Material& material : scene.materials) {
    stage_.has_emitters = stage_.has_emitters || emits(material);
    stage_.has_media = stage_.has_media || refracts(material);
    stage_.plain.push_back(plain_material(material));
    stage_.has_see_through = stage_.has_see_through || material.alpha_mode != AlphaMode::opaque;
  }
}

void PathTracer::trace(RayPacket& rays, const PacketId& id, TemporalEvaluator& evaluator,
                       RadianceLanes& radiance, const SampleLayers& layers) const {
  PathWalk walk(stage_, id, evaluator, rays, layers);
  walk.run();
  walk.take_radiance(radiance);
  note_crossing(walk.crossing());
}

void PathTracer::note_crossing(const MediumCrossing& crossing) const {
  if (crossing.medium < 0) return;
  const std::uint64_t pair = (static_cast<std::uint64_t>(crossing.medium) << 32) |
                             static_cast<std::uint64_t>(crossing.inside);
  std::uint64_t known = crossed_media_.load();
  while (pair < known && !crossed_media_.compare_exchange_weak(known, pair)) continue;
}

void PathTracer::check_media() const {
  const std::uint64_t pair = crossed_media_.load();
  if (pair == no_crossing) return;
  const auto name = [&](std::uint64_t object) {
    return stage_.scene.objects[static_cast<std::size_t>(object)].name;
  };
  throw InputError(
      fmt::format("object \"{}\": light inside of it meets object \"{}\", which moves at another "
                  "velocity; media nest only where nothing moves",
                  name(pair >> 32), name(pair & 0xffffffffU)));
}

}  // namespace restframe
