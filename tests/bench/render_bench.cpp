// Whole preview pictures against bare rtcIntersect16 on the same rays.

#include <benchmark/benchmark.h>

#include "app/render_picture.h"
#include "bench_scene.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

struct Bench {
  Scene scene;
  FrameSet frames;
  Integrator integrator;
  EvaluatorPool evaluators;
  std::vector<RTCRayHit16> packets;

  explicit Bench(Scene s)
      : scene(std::move(s)),
        frames(scene, thread_count()),
        integrator(make_integrator(scene, frames)),
        evaluators(scene.functions),
        packets(bare_packets(scene, frames)) {}
};

Bench& at_rest() {
  static Bench bench(bench_scene_at_rest());
  return bench;
}

Bench& moving() {
  static Bench bench(bench_scene_moving());
  return bench;
}

void count_rays(benchmark::State& state, const Bench& bench) {
  const double rays = bench.scene.render.width * bench.scene.render.height;
  state.counters["rays/s"] = benchmark::Counter(rays * static_cast<double>(state.iterations()),
                                                benchmark::Counter::kIsRate);
}

void bare(benchmark::State& state, Bench& bench) {
  for (auto _ : state) benchmark::DoNotOptimize(trace_bare(bench.frames, bench.packets));
  count_rays(state, bench);
}

void pictures(benchmark::State& state, Bench& bench) {
  const RenderContext context{bench.scene, bench.integrator, bench.evaluators, {}};
  Picture picture = blank_picture(bench.scene);
  for (auto _ : state) render_picture(context, 0, picture);
  count_rays(state, bench);
}

void bare_at_rest(benchmark::State& state) {
  bare(state, at_rest());
}
void preview_at_rest(benchmark::State& state) {
  pictures(state, at_rest());
}
void bare_moving(benchmark::State& state) {
  bare(state, moving());
}
void preview_moving(benchmark::State& state) {
  pictures(state, moving());
}

// 16 samples of the moving lattice. The shutter is open for half the time between pictures; in the
// lattice's frame the camera flies a third of the pitch meanwhile.
void sampled(benchmark::State& state, double shutter) {
  Bench& bench = moving();
  Scene scene = bench.scene;
  scene.render.samples = 16;
  scene.exposure.shutter = shutter;
  const RenderContext context{scene, bench.integrator, bench.evaluators, {}};
  Picture picture = blank_picture(scene);
  for (auto _ : state) render_picture(context, 0, picture);
}
void preview_blurred(benchmark::State& state) {
  sampled(state, 0.5 / moving().scene.animation.rate);
}
void preview_sampled(benchmark::State& state) {
  sampled(state, 0.0);
}

// 4 samples of the resting lattice, with one shadowed point light beside the camera, and what preview takes
// for as many. Both on the same Embree scene: where in memory another one would lie changes the ratio.
void four_samples(benchmark::State& state, const Scene& scene, const Integrator& integrator) {
  const RenderContext context{scene, integrator, at_rest().evaluators, {}};
  Picture picture = blank_picture(scene);
  for (auto _ : state) render_picture(context, 0, picture);
}
Scene lit_scene() {
  Scene scene = at_rest().scene;
  scene.render.samples = 4;
  scene.render.integrator = IntegratorKind::path;
  scene.render.depth = 1;
  Light light;
  light.worldline.reference.x = {3, 4, 14};
  light.intensity.value = 100;
  scene.lights.push_back(light);
  return scene;
}
void light_shadowed(benchmark::State& state) {
  static const Scene scene = lit_scene();
  static const Integrator integrator = make_integrator(scene, at_rest().frames);
  four_samples(state, scene, integrator);
}
void light_none(benchmark::State& state) {
  Scene scene = at_rest().scene;
  scene.render.samples = 4;
  four_samples(state, scene, at_rest().integrator);
}

BENCHMARK(bare_at_rest)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_at_rest)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(bare_moving)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_moving)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_blurred)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_sampled)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(light_shadowed)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(light_none)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace restframe
