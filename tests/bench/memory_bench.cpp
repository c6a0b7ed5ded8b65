#include "memory_bench.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

#include "bench_scene.h"
#include "frames/frame_set.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

// Peak resident memory of a child that runs the program, in bytes.
double peak_of_program(const std::string& scene, const std::string& output) {
  const pid_t child = fork();
  if (child == 0) {
    execl(RESTFRAME_PROGRAM, RESTFRAME_PROGRAM, "render", scene.c_str(), "--samples", "1",
          "--overwrite", "--quiet", "--output", output.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || status != 0) {
    throw std::runtime_error("the program failed on " + scene);
  }
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

MemoryUse measure_memory() {
  const BenchFile file;
  MemoryUse use;
  // First: a child starts with its parent's resident memory on its account.
  use.peak_megabytes = 1e-6 * peak_of_program(file.glb(), file.folder() + "/memory.exr");
  const Scene scene = bench_scene_at_rest();
  const FrameSet frames(scene, thread_count());
  const Mesh& mesh = scene.meshes[0];
  const std::size_t vertices = mesh.positions.size() * (sizeof(Vec3f) + sizeof(Vec3f));
  const std::size_t indices = mesh.triangles.size() * sizeof(Triangle);
  use.needed_megabytes =
      1e-6 * static_cast<double>(vertices + indices + frames.peak_embree_bytes());
  return use;
}

}  // namespace restframe
