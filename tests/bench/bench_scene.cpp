#include "bench_scene.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "importers/importers.h"
#include "scene/parallel.h"
#include "tracer/film_samples.h"
#include "tracer/null_ray.h"

namespace restframe {
namespace {

constexpr int block_side = 4;

Scene bench_scene(const Vec3& camera, const Velocity& velocity) {
  Asset lattice = make_lattice(LatticeSettings{}, true);
  Scene scene;
  scene.meshes = std::move(lattice.meshes);
  scene.materials = std::move(lattice.materials);
  Object object;
  object.name = "lattice";
  object.worldline.velocity = velocity;
  object.materials = {0, 1};
  for (const Part& part : lattice.parts) object.parts.push_back({part.mesh, part.asset_from_mesh});
  scene.objects.push_back(object);
  std::get<Worldline>(scene.camera.motion).reference.x = camera;
  scene.camera.vertical_fov = 60.0 * 3.14159265358979 / 180.0;
  scene.camera_given = true;
  scene.render.samples = 1;
  scene.output.layers = {Layer::beauty};
  return scene;
}

}  // namespace

Scene bench_scene_at_rest() {
  return bench_scene({0.3, 0.4, 12.0}, Velocity());
}

Scene bench_scene_moving() {
  return bench_scene({0.3, 0.4, 1.0}, Velocity::from_beta({0, 0, 0.99}));
}

BenchFile::BenchFile() {
  std::string name = (std::filesystem::temp_directory_path() / "restframe-bench-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("can not create " + name);
  folder_ = name;
  write_lattice(LatticeSettings{}, InstanceMode::none, glb());
  write_lattice(LatticeSettings{}, InstanceMode::none, obj());
}

BenchFile::~BenchFile() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::vector<RTCRayHit16> bare_packets(const Scene& scene, const FrameSet& frames) {
  const CameraPose pose = pose_at(scene.camera, 0.0);
  const RenderSettings& render = scene.render;
  const Projection projection(pose, pose.vertical_fov, render.width, render.height);
  const RestFrame& frame = frames.frame(0);
  const Vec3 shift = frame.rest_position(Vec3(0));
  std::vector<RTCRayHit16> packets;
  for (int y = 0; y < render.height; y += block_side) {
    for (int x = 0; x < render.width; x += block_side) {
      RTCRayHit16 packet{};
      for (unsigned i = 0; i < packet_size; ++i) {
        const double film_x = x + static_cast<int>(i) % block_side + 0.5;
        const double film_y = y + static_cast<int>(i) / block_side + 0.5;
        const auto k = looking_along<in::Camera>(projection.direction(film_x, film_y));
        const WaveVector<in::Rest> rest_k = frame.coordinates()(pose.world_from_camera(k));
        const Vec3f origin(frame.coordinates()(pose.event).x - shift);
        packet.ray.org_x[i] = origin.x;
        packet.ray.org_y[i] = origin.y;
        packet.ray.org_z[i] = origin.z;
        packet.ray.dir_x[i] = static_cast<float>(rest_k.x.x);
        packet.ray.dir_y[i] = static_cast<float>(rest_k.x.y);
        packet.ray.dir_z[i] = static_cast<float>(rest_k.x.z);
        packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
        packet.ray.mask[i] = ~0U;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
      }
      packets.push_back(packet);
    }
  }
  return packets;
}

std::size_t trace_bare(const FrameSet& frames, const std::vector<RTCRayHit16>& packets) {
  constexpr std::size_t packets_a_task = 64;  // as many rays as a tile has
  alignas(64) static const int all_active[packet_size] = {-1, -1, -1, -1, -1, -1, -1, -1,
                                                          -1, -1, -1, -1, -1, -1, -1, -1};
  std::atomic<std::size_t> hits{0};
  parallel_for((packets.size() + packets_a_task - 1) / packets_a_task, [&](std::size_t task) {
    std::size_t found = 0;
    const std::size_t end = std::min(packets.size(), (task + 1) * packets_a_task);
    for (std::size_t i = task * packets_a_task; i < end; ++i) {
      RTCRayHit16 query = packets[i];
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      rtcIntersect16(all_active, frames.frame(0).traversed(), &context, &query);
      for (const unsigned id : query.hit.geomID) found += id != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    }
    hits += found;
  });
  return hits;
}

}  // namespace restframe
