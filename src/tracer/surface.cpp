// Lanes that hit the same part are done together: what differs between them is gathered, and the rest is
// arithmetic over all 16 lanes. Coherent packets meet one to three parts.

#include "tracer/surface.h"

#include <cmath>

namespace restframe {
namespace {

struct Placed {
  const FramePart& part;
  const Mesh& mesh;
  const Object& object;
};

Placed placed(const Scene& scene, const FrameSet& frames, const HitPacket& hits, int lane) {
  const FramePart& part = frames.frame(hits.frame[lane]).part(hits.part[lane]);
  return {part, scene.meshes[static_cast<std::size_t>(part.mesh)],
          scene.objects[static_cast<std::size_t>(part.object)]};
}

// Which of the waiting lanes hit the same part as lane `first`; they no longer wait.
Lanes<std::int32_t> take_group(const HitPacket& hits, int first, Lanes<std::int32_t>& waiting) {
  const std::int32_t frame = hits.frame[first];
  const std::uint32_t part = hits.part[first];
  Lanes<std::int32_t> group;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const bool same = hits.frame[i] == frame && hits.part[i] == part;
    group[i] = same ? waiting[i] : 0;
    waiting[i] = same ? 0 : waiting[i];
  }
  return group;
}

// The triangle of each lane of the group; lanes outside repeat the first one's, which is safe to read.
Lanes<const Triangle*> triangles_of(const Mesh& mesh, const HitPacket& hits, int first,
                                    const Lanes<std::int32_t>& group) {
  Lanes<const Triangle*> triangles;
  for (int i = 0; i < packet_size; ++i) {
    triangles[i] = &mesh.triangles[hits.triangle[group[i] != 0 ? i : first]];
    __builtin_prefetch(triangles[i]);
  }
  return triangles;
}

// Normals of the triangles' corners.
struct CornerNormals {
  Vec3fLanes a, b, c;
};

void gather_normals(const Mesh& mesh, const Lanes<const Triangle*>& triangles,
                    CornerNormals& corners) {
  // All misses under way before the first is waited for.
  for (const Triangle* t : triangles.lane) {
    for (const std::uint32_t vertex : *t) __builtin_prefetch(&mesh.normals[vertex]);
  }
  for (int i = 0; i < packet_size; ++i) {
    const Triangle& t = *triangles[i];
    corners.a.set(i, mesh.normals[t[0]]);
    corners.b.set(i, mesh.normals[t[1]]);
    corners.c.set(i, mesh.normals[t[2]]);
  }
}

// Normals in mesh coordinates, of any length.
void interpolate(const CornerNormals& corners, const HitPacket& hits, Vec3fLanes& normal) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const float u = hits.bary_u[i];
    const float v = hits.bary_v[i];
    normal.set(i, (1.0F - u - v) * corners.a.at(i) + u * corners.b.at(i) + v * corners.c.at(i));
  }
}

// Of any length, in rest-frame axes.
void to_rest(const glm::mat3& rest_from_local, const Vec3fLanes& local, Vec3fLanes& rest) {
  const glm::mat3 m = rest_from_local;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) rest.set(i, m * local.at(i));
}

// The least squared length that is not a degenerate normal's.
constexpr float tiny = 1e-30F;

// Facet and normal: of any length, in rest-frame axes, to the front.
void orient(const Vec3fLanes& facet, const Vec3fLanes& normal, const Vec3fLanes& sight,
            const Lanes<std::int32_t>& group, SurfaceLanes& surfaces) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const bool in_group = group[i] != 0;
    const float facing = glm::dot(facet.at(i), sight.at(i));
    const float along = glm::dot(normal.at(i), sight.at(i));
    const float squared = glm::dot(normal.at(i), normal.at(i));
    const float inverse_length = 1.0F / std::sqrt(squared > tiny ? squared : tiny);
    const float towards_ray = along > 0.0F ? -inverse_length : inverse_length;
    surfaces.back[i] = in_group ? (facing > 0.0F ? 1 : 0) : surfaces.back[i];
    surfaces.cosine[i] = in_group ? -along * towards_ray : surfaces.cosine[i];
    surfaces.normal.x[i] = in_group ? normal.x[i] * towards_ray : surfaces.normal.x[i];
    surfaces.normal.y[i] = in_group ? normal.y[i] * towards_ray : surfaces.normal.y[i];
    surfaces.normal.z[i] = in_group ? normal.z[i] * towards_ray : surfaces.normal.z[i];
  }
}

void assign_group(const Placed& placed, const Lanes<const Triangle*>& triangles,
                  const HitPacket& hits, const Lanes<std::int32_t>& group, SurfaceLanes& surfaces) {
  for (int i = 0; i < packet_size; ++i) {
    if (group[i] == 0) continue;
    const int slot = material_slot(placed.mesh, hits.triangle[i]);
    surfaces.object[i] = placed.part.object;
    surfaces.material[i] = placed.object.materials[static_cast<std::size_t>(slot)];
    surfaces.color[i] = Vec4f(1);
    if (!placed.mesh.colors.empty()) {
      const Triangle& t = *triangles[i];
      const float u = hits.bary_u[i];
      const float v = hits.bary_v[i];
      surfaces.color[i] = (1.0F - u - v) * placed.mesh.colors[t[0]] + u * placed.mesh.colors[t[1]] +
                          v * placed.mesh.colors[t[2]];
    }
  }
}

void shade_group(const Placed& placed, const HitPacket& hits, int first,
                 const Lanes<std::int32_t>& group, SurfaceLanes& surfaces) {
  const Lanes<const Triangle*> triangles = triangles_of(placed.mesh, hits, first, group);
  Vec3fLanes facet;
  to_rest(placed.part.rest_from_facet_normal, hits.facet_normal, facet);
  if (placed.mesh.normals.empty()) {
    orient(facet, facet, hits.sight, group, surfaces);
  } else {
    CornerNormals corners;
    gather_normals(placed.mesh, triangles, corners);
    Vec3fLanes local, normal;
    interpolate(corners, hits, local);
    to_rest(placed.part.rest_from_mesh_normal, local, normal);
    orient(facet, normal, hits.sight, group, surfaces);
  }
  assign_group(placed, triangles, hits, group, surfaces);
}

}  // namespace

void surfaces_at(const Scene& scene, const FrameSet& frames, const HitPacket& hits,
                 const Lanes<std::int32_t>& active, SurfaceLanes& surfaces) {
  Lanes<std::int32_t> waiting;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) waiting[i] = hits.frame[i] >= 0 ? active[i] : 0;
  for (int first = 0; first < packet_size; ++first) {
    if (waiting[first] == 0) continue;
    const Lanes<std::int32_t> group = take_group(hits, first, waiting);
    shade_group(placed(scene, frames, hits, first), hits, first, group, surfaces);
  }
}

Vec2f uv_at(const Scene& scene, const FrameSet& frames, const HitPacket& hits, int lane, int set) {
  const Mesh& mesh = placed(scene, frames, hits, lane).mesh;
  if (static_cast<std::size_t>(set) >= mesh.uvs.size()) return Vec2f(0);
  const std::vector<Vec2f>& uvs = mesh.uvs[static_cast<std::size_t>(set)];
  if (uvs.empty()) return Vec2f(0);
  const Triangle& t = mesh.triangles[hits.triangle[lane]];
  const float u = hits.bary_u[lane];
  const float v = hits.bary_v[lane];
  return (1.0F - u - v) * uvs[t[0]] + u * uvs[t[1]] + v * uvs[t[2]];
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
