// Reading the lattice's files against Embree's own build, and an animation against its renderings.

#include <benchmark/benchmark.h>

#include "app/picture_files.h"
#include "app/picture_writer.h"
#include "app/render_picture.h"
#include "bench_scene.h"
#include "frames/traversable_mesh.h"
#include "importers/importers.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

constexpr int pictures = 4;

const BenchFile& bench_file() {
  static const BenchFile file;
  return file;
}

void load_and_build(benchmark::State& state, const std::string& path) {
  for (auto _ : state) {
    Warnings warnings;
    const Scene scene = load_scene(path, {}, warnings);
    const FrameSet frames(scene, thread_count());
    benchmark::DoNotOptimize(frames.embree_bytes());
  }
}

void read_and_build(benchmark::State& state) {
  load_and_build(state, bench_file().glb());
}
void read_obj_and_build(benchmark::State& state) {
  load_and_build(state, bench_file().obj());
}

// Only rtcCommitScene and what it needs, on vertices and indices that are there already.
void bare_build(benchmark::State& state) {
  const Scene scene = bench_scene_at_rest();
  const EmbreeDevice device(thread_count());
  for (auto _ : state) {
    const EmbreeScene embree_scene = new_scene(device);
    const Mesh& mesh = scene.meshes[0];
    const EmbreeGeometry geometry = triangle_geometry(device, mesh.positions, mesh);
    rtcAttachGeometryByID(embree_scene.get(), geometry.get(), 0);
    rtcCommitScene(embree_scene.get());
    benchmark::DoNotOptimize(embree_scene.get());
  }
}

// Enough samples that rendering is clearly the longer part (README.md).
Scene animation_scene() {
  Scene scene = bench_scene_at_rest();
  scene.render.samples = 64;
  scene.output.layers = {Layer::beauty, Layer::z};
  scene.output.path = bench_file().folder() + "/animation.####.exr";
  return scene;
}

template <class EachPicture>
void render_all(benchmark::State& state, const EachPicture& each_picture) {
  const Scene scene = animation_scene();
  const FrameSet frames(scene, thread_count());
  const Integrator integrator = make_integrator(scene, frames);
  EvaluatorPool evaluators(scene.functions);
  const RenderContext context{scene, integrator, evaluators, {}};
  Picture buffers[2] = {blank_picture(scene), blank_picture(scene)};
  for (auto _ : state) {
    PictureWriter writer(scene.output);
    for (int number = 0; number < pictures; ++number) {
      Picture& picture = buffers[number % 2];
      render_picture(context, number, picture);
      each_picture(scene, number, picture, writer);
    }
    writer.finish();
  }
}

void renderings(benchmark::State& state) {
  render_all(state, [](const Scene&, int, const Picture&, PictureWriter&) {});
}

void animation(benchmark::State& state) {
  const PictureInfo common = common_info(animation_scene());
  render_all(state,
             [&](const Scene& scene, int number, const Picture& picture, PictureWriter& writer) {
               writer.write(picture_files(scene, number, false), {&picture, 1},
                            picture_info(common, scene, number));
             });
}

BENCHMARK(bare_build)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(read_and_build)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(read_obj_and_build)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(renderings)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(animation)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace restframe
