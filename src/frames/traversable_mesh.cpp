#include "frames/traversable_mesh.h"

namespace restframe {
namespace {

// Embree misses a unit triangle at 1e8; up to this many times its own size off the origin a mesh is
// fine.
constexpr double tolerated_offset = 8.0;

bool is_far_from_origin(const Bounds& b) {
  return glm::length(b.center()) > tolerated_offset * glm::length(b.extent());
}

// Embree reads 16 bytes a vertex, the last one included.
bool is_padded(const Mesh& mesh) {
  return mesh.positions.capacity() > mesh.positions.size();
}

}  // namespace

TraversableMesh traversable(const Mesh& mesh) {
  TraversableMesh result;
  result.mesh = &mesh;
  result.bounds = bounds_of(mesh);
  if (is_padded(mesh) && !is_far_from_origin(result.bounds)) {
    result.met_triangles = met_triangles(mesh, mesh.positions);
    return result;
  }
  result.offset = result.bounds.center();
  result.moved.reserve(mesh.positions.size() + 1);
  for (const Vec3f& p : mesh.positions) result.moved.emplace_back(Vec3(p) - result.offset);
  result.bounds.lower -= result.offset;
  result.bounds.upper -= result.offset;
  result.met_triangles = met_triangles(mesh, result.moved);
  return result;
}

void build_scene(const EmbreeDevice& device, TraversableMesh& mesh) {
  mesh.scene = new_scene(device);
  const EmbreeGeometry geometry = triangle_geometry(device, mesh.positions(), *mesh.mesh);
  rtcAttachGeometryByID(mesh.scene.get(), geometry.get(), 0);
  rtcCommitScene(mesh.scene.get());
  device.check();
}

EmbreeGeometry triangle_geometry(const EmbreeDevice& device, std::span<const Vec3f> positions,
                                 const Mesh& mesh) {
  EmbreeGeometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             positions.data(), 0, sizeof(Vec3f), positions.size());
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(Triangle), mesh.triangles.size());
  rtcCommitGeometry(geometry.get());
  return geometry;
}

}  // namespace restframe
