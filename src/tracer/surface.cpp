// Lanes that hit the same part are done together: what differs between them is gathered, and the rest is
// arithmetic over all 16 lanes. Coherent packets meet one to three parts.

#include "tracer/surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "frames/lane_groups.h"
#include "physics/clones.h"

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
Lanes<std::int32_t> take_part(const HitPacket& hits, bool one_frame, int first,
                              Lanes<std::int32_t>& waiting) {
  if (one_frame) return take_group(hits.part, first, waiting);
  Lanes<std::int32_t> of_frame = take_group(hits.frame, first, waiting);
  const Lanes<std::int32_t> group = take_group(hits.part, first, of_frame);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) waiting[i] |= of_frame[i];
  return group;
}

// Lanes outside the group repeat its first one's, which is safe to read.
void gather_normals(std::span<const MetTriangle> met, const HitPacket& hits, int first,
                    const Lanes<std::int32_t>& group, CornerNormalLanes& corners) {
  Lanes<std::uint32_t> triangle;
  const std::uint32_t first_triangle = hits.triangle[first];
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::uint32_t own = hits.triangle[i];
    triangle[i] = group[i] != 0 ? own : first_triangle;
  }
  for (int i = 0; i < packet_size; ++i) {
    const CornerNormals& n = met[triangle[i]].normals;
    for (std::size_t word = 0; word < n.size(); ++word) corners[word][i] = n[word];
  }
}

// Normals in mesh coordinates, of any length.
void interpolate(const CornerNormalLanes& corners, const HitPacket& hits, Vec3fLanes& normal) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    normal.set(i, interpolated(corners, i, hits.bary_u[i], hits.bary_v[i]));
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
    blend(in_group, surfaces.back[i], facing > 0.0F ? 1 : 0);
    blend(in_group, surfaces.cosine[i], -along * towards_ray);
    blend(in_group, surfaces.normal.x[i], normal.x[i] * towards_ray);
    blend(in_group, surfaces.normal.y[i], normal.y[i] * towards_ray);
    blend(in_group, surfaces.normal.z[i], normal.z[i] * towards_ray);
  }
}

// Of many ranges by bisection, lane by lane; the usual few are compared with all lanes at once.
void assign_materials(const Placed& placed, const HitPacket& hits, const Lanes<std::int32_t>& group,
                      SurfaceLanes& surfaces) {
  constexpr std::size_t few = 4;
  const std::vector<MaterialRange>& ranges = placed.mesh.materials;
  const std::vector<int>& materials = placed.object.materials;
  const std::size_t compared = std::min(ranges.size(), few);
  for (std::size_t range = 0; range < compared; ++range) {
    const std::uint32_t from = ranges[range].first_triangle;
    const std::int32_t material = materials[static_cast<std::size_t>(ranges[range].slot)];
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      const std::uint32_t triangle = hits.triangle[i];
      blend((group[i] != 0) & (triangle >= from), surfaces.material[i], material);
    }
  }
  if (ranges.size() <= few) return;
  for (int i = 0; i < packet_size; ++i) {
    if (group[i] == 0) continue;
    const int slot = material_slot(placed.mesh, hits.triangle[i]);
    surfaces.material[i] = materials[static_cast<std::size_t>(slot)];
  }
}

void assign_object(int object, const Lanes<std::int32_t>& group, SurfaceLanes& surfaces) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    blend(group[i] != 0, surfaces.object[i], object);
  }
}

void assign_colors(const Mesh& mesh, const HitPacket& hits, const Lanes<std::int32_t>& group,
                   SurfaceLanes& surfaces) {
  if (!surfaces.colored) surfaces.color.fill(Vec4f(1));
  surfaces.colored = true;
  for (int i = 0; i < packet_size; ++i) {
    if (group[i] == 0) continue;
    const Triangle& t = mesh.triangles[hits.triangle[i]];
    const float u = hits.bary_u[i];
    const float v = hits.bary_v[i];
    surfaces.color[i] =
        (1.0F - u - v) * mesh.colors[t[0]] + u * mesh.colors[t[1]] + v * mesh.colors[t[2]];
  }
}

void shade_group(const Placed& placed, const HitPacket& hits, int first,
                 const Lanes<std::int32_t>& group, SurfaceLanes& surfaces) {
  Vec3fLanes facet;
  to_rest(placed.part.rest_from_facet_normal, hits.facet_normal, facet);
  if (placed.part.met_triangles.empty()) {
    orient(facet, facet, hits.sight, group, surfaces);
  } else {
    CornerNormalLanes corners;
    gather_normals(placed.part.met_triangles, hits, first, group, corners);
    Vec3fLanes local, normal;
    interpolate(corners, hits, local);
    to_rest(placed.part.rest_from_mesh_normal, local, normal);
    orient(facet, normal, hits.sight, group, surfaces);
  }
  assign_object(placed.part.object, group, surfaces);
  assign_materials(placed, hits, group, surfaces);
  if (!placed.mesh.colors.empty()) assign_colors(placed.mesh, hits, group, surfaces);
}

}  // namespace

RESTFRAME_CLONES void surfaces_at(const Scene& scene, const FrameSet& frames, const HitPacket& hits,
                                  const Lanes<std::int32_t>& active, SurfaceLanes& surfaces) {
  surfaces.colored = false;
  const bool one_frame = frames.frames().size() == 1;
  Lanes<std::int32_t> waiting;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) waiting[i] = hits.frame[i] >= 0 ? active[i] : 0;
  while (const unsigned bits = active_bits(waiting)) {
    const int first = std::countr_zero(bits);
    const Lanes<std::int32_t> group = take_part(hits, one_frame, first, waiting);
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
