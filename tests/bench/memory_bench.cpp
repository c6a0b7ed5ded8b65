#include "memory_bench.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "bench_scene.h"
#include "frames/frame_set.h"
#include "importers/importers.h"
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

// In bytes: "VmRSS", what the process holds, or "VmHWM", the most that it has held.
double of_process(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(key + ":", 0) == 0) return 1024.0 * std::stod(line.substr(key.size() + 1));
  }
  throw std::runtime_error("/proc/self/status has no " + key);
}

std::size_t bytes_of(const Asset& asset) {
  std::size_t sum = 0;
  for (const Mesh& m : asset.meshes) {
    sum += sizeof(Vec3f) * (m.positions.size() + m.normals.size()) +
           sizeof(Triangle) * m.triangles.size() + sizeof(Vec4f) * m.colors.size();
    for (const auto& uvs : m.uvs) sum += sizeof(Vec2f) * uvs.size();
  }
  return sum;
}

ImportMemory import(const std::string& path) {
  malloc_trim(0);  // what the parent freed would be used again, unseen
  const double before = of_process("VmRSS");
  Warnings warnings;
  const Asset asset = load_asset(path, {}, warnings);
  return {1e-6 * (of_process("VmHWM") - before), 1e-6 * static_cast<double>(bytes_of(asset))};
}

}  // namespace

ImportMemory measure_import(const std::string& path) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  ImportMemory use;
  const pid_t child = fork();
  if (child == 0) {
    use = import(path);
    _exit(write(ends[1], &use, sizeof use) == sizeof use ? 0 : 1);
  }
  int status = 0;
  const bool got = waitpid(child, &status, 0) == child && status == 0 &&
                   read(ends[0], &use, sizeof use) == sizeof use;
  close(ends[0]);
  close(ends[1]);
  if (!got) throw std::runtime_error("importing failed on " + path);
  return use;
}

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
