#include "tracer/surface.h"

#include <cmath>

#include "physics/doppler.h"

namespace restframe {
namespace {

struct Weights {
  float a, b, c;
};

template <class T>
T interpolated(const std::vector<T>& values, const Triangle& t, const Weights& w) {
  return w.a * values[t[0]] + w.b * values[t[1]] + w.c * values[t[2]];
}

Vec3 triangle_normal(const Mesh& mesh, const Triangle& t) {
  const Vec3 a(mesh.positions[t[0]]);
  return glm::cross(Vec3(mesh.positions[t[1]]) - a, Vec3(mesh.positions[t[2]]) - a);
}

// The ray's direction in rest-frame axes, un-normalised traversal coordinates turned back.
Vec3 unit(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3(0, 0, 1);
}

}  // namespace

std::vector<ObjectPlace> object_places(const Scene& scene, const FrameSet& frames) {
  std::vector<ObjectPlace> places(scene.objects.size());
  for (const RestFrame& frame : frames.frames()) {
    for (const FramePart& part : frame.parts()) {
      const std::size_t index = static_cast<std::size_t>(part.object);
      const Object& object = scene.objects[index];
      places[index] = {frame.clock_at_anchor(object), frame.origin_of(object)};
    }
  }
  return places;
}

Surface surface_at(const Scene& scene, const FrameSet& frames,
                   const std::vector<ObjectPlace>& places, const HitPacket& hits, int lane) {
  const RestFrame& frame = frames.frame(hits.frame[lane]);
  const FramePart& part = frame.part(hits.part[lane]);
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(part.mesh)];
  const Object& object = scene.objects[static_cast<std::size_t>(part.object)];
  const std::uint32_t index = hits.triangle[lane];
  const Triangle& triangle = mesh.triangles[index];
  const auto u = static_cast<float>(hits.bary_u[lane]);
  const auto v = static_cast<float>(hits.bary_v[lane]);
  const Weights weights{1.0F - u - v, u, v};

  Surface surface;
  surface.object = part.object;
  surface.material = object.materials[static_cast<std::size_t>(material_slot(mesh, index))];
  surface.clock = hits.rest_t[lane] + hits.s[lane] * hits.rest_k_t[lane] +
                  places[static_cast<std::size_t>(part.object)].clock_at_anchor;
  surface.doppler = -1.0 / hits.rest_k_t[lane];

  const Vec3 ray = frame.rest_direction(hits.k.at(lane)) / -hits.rest_k_t[lane];
  const Vec3 geometric = unit(part.rest_from_mesh_normal * triangle_normal(mesh, triangle));
  const double facing = glm::dot(geometric, ray);
  surface.back = (facing > 0.0) != part.mirrored;
  const Vec3 outward = facing > 0.0 ? -geometric : geometric;
  surface.normal = outward;
  if (!mesh.normals.empty()) {
    const Vec3 smooth =
        unit(part.rest_from_mesh_normal * Vec3(interpolated(mesh.normals, triangle, weights)));
    surface.normal = glm::dot(smooth, ray) > 0.0 ? -smooth : smooth;
  }
  surface.cosine = static_cast<float>(std::abs(glm::dot(surface.normal, ray)));

  for (std::size_t set = 0; set < 2; ++set) {
    if (!mesh.uvs[set].empty()) surface.uv[set] = interpolated(mesh.uvs[set], triangle, weights);
  }
  if (!mesh.colors.empty()) surface.color = interpolated(mesh.colors, triangle, weights);
  return surface;
}

Vec3 position_on_object(const FrameSet& frames, const std::vector<ObjectPlace>& places,
                        const HitPacket& hits, int lane) {
  const RestFrame& frame = frames.frame(hits.frame[lane]);
  const FramePart& part = frame.part(hits.part[lane]);
  const Vec3 traversal = hits.origin.at(lane) + hits.s[lane] * hits.k.at(lane);
  return frame.rest_position(traversal) - places[static_cast<std::size_t>(part.object)].origin;
}

}  // namespace restframe
