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

void preview(benchmark::State& state, Bench& bench) {
  const RenderContext context{bench.scene, bench.integrator, bench.evaluators, {}};
  Picture picture = blank_picture(bench.scene);
  for (auto _ : state) render_picture(context, 0, picture);
  count_rays(state, bench);
}

void bare_at_rest(benchmark::State& state) {
  bare(state, at_rest());
}
void preview_at_rest(benchmark::State& state) {
  preview(state, at_rest());
}
void bare_moving(benchmark::State& state) {
  bare(state, moving());
}
void preview_moving(benchmark::State& state) {
  preview(state, moving());
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

BENCHMARK(bare_at_rest)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_at_rest)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(bare_moving)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_moving)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_blurred)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(preview_sampled)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace restframe
