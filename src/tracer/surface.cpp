#include "tracer/surface.h"

#include <cmath>

namespace restframe {
namespace {

struct Weights {
  float a, b, c;
};

template <class T>
T interpolated(const std::vector<T>& values, const Triangle& t, const Weights& w) {
  return w.a * values[t[0]] + w.b * values[t[1]] + w.c * values[t[2]];
}

// A length of 0 comes from a degenerate triangle or normal: any direction does.
Vec3f unit(const Vec3f& v) {
  const float squared = glm::dot(v, v);
  return squared > 0.0F ? v * (1.0F / std::sqrt(squared)) : Vec3f(0, 0, 1);
}

}  // namespace

Surface surface_at(const Scene& scene, const FrameSet& frames, const HitPacket& hits, int lane) {
  const RestFrame& frame = frames.frame(hits.frame[lane]);
  const FramePart& part = frame.part(hits.part[lane]);
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(part.mesh)];
  const Object& object = scene.objects[static_cast<std::size_t>(part.object)];
  const std::uint32_t index = hits.triangle[lane];
  const Triangle& triangle = mesh.triangles[index];
  const float u = hits.bary_u[lane];
  const float v = hits.bary_v[lane];
  const Weights weights{1.0F - u - v, u, v};

  Surface surface;
  surface.object = part.object;
  surface.material = object.materials[static_cast<std::size_t>(material_slot(mesh, index))];
  const Vec3f ray = unit(Vec3f(frame.rest_direction(hits.k.at(lane))));
  const Vec3f facet = part.rest_from_facet_normal * hits.facet_normal.at(lane);
  surface.back = glm::dot(facet, ray) > 0.0F;
  const Vec3f normal =
      mesh.normals.empty()
          ? unit(facet)
          : unit(part.rest_from_mesh_normal * interpolated(mesh.normals, triangle, weights));
  const float along = glm::dot(normal, ray);
  surface.normal = along > 0.0F ? -normal : normal;
  surface.cosine = std::abs(along);
  for (std::size_t set = 0; set < 2; ++set) {
    if (!mesh.uvs[set].empty()) surface.uv[set] = interpolated(mesh.uvs[set], triangle, weights);
  }
  if (!mesh.colors.empty()) surface.color = interpolated(mesh.colors, triangle, weights);
  return surface;
}

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

Vec3 position_on_object(const FrameSet& frames, const ObjectPlace& place, const HitPacket& hits,
                        int lane) {
  const Vec3 traversal = hits.origin.at(lane) + hits.s[lane] * hits.k.at(lane);
  return frames.frame(hits.frame[lane]).rest_position(traversal) - place.origin;
}

}  // namespace restframe
