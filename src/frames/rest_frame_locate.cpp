// What rest_frame_hits.cpp tells of one hit, for all lanes of a packet that hit the same part.

#include <algorithm>
#include <cmath>

#include "frames/lane_groups.h"
#include "frames/rest_frame.h"
#include "physics/clones.h"

namespace restframe {

// Corners as FramePart::positions has them.
struct CornerLanes {
  Vec3fLanes a, b, c;
};

namespace {

constexpr double float_noise = 8.0 * 0x1p-24;
constexpr double least_cosine = 1e-3;

// Corners of an instance's triangles, in traversal coordinates.
struct PlacedCorners {
  Vec3Lanes a, b, c;
};

void transform(const Mat4& matrix, const Vec3fLanes& from, Vec3Lanes& to) {
  const Mat4 m = matrix;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    to.set(i, Vec3(m * glm::dvec4(Vec3(from.at(i)), 1.0)));
  }
}

double sum_of_absolutes(const Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// As RestFrame::refine, which says why.
template <class Corners>
void refine_group(const Corners& corners, const Lanes<std::int32_t>& group, HitPacket& hits) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 k = hits.k.at(i);
    const Vec3 a(corners.a.at(i));
    const Vec3 edge_u = Vec3(corners.b.at(i)) - a;
    const Vec3 edge_v = Vec3(corners.c.at(i)) - a;
    const double s_near = hits.s[i];
    const Vec3 origin = hits.origin.at(i) + s_near * k - a;
    const Vec3 p = glm::cross(k, edge_v);
    const double inverse_det = 1.0 / glm::dot(edge_u, p);
    const double exact_u = glm::dot(origin, p) * inverse_det;
    const double exact_v = glm::dot(k, glm::cross(origin, edge_u)) * inverse_det;
    const bool sane = std::abs(exact_u) < 2.0 && std::abs(exact_v) < 2.0;
    double u = sane ? exact_u : static_cast<double>(hits.bary_u[i]);
    double v = sane ? exact_v : static_cast<double>(hits.bary_v[i]);
    u = std::min(std::max(u, 0.0), 1.0);
    v = std::min(std::max(v, 0.0), 1.0 - u);
    const Vec3 point = u * edge_u + v * edge_v;
    const double s = s_near + glm::dot(point - origin, k) / glm::dot(k, k);
    set_in(group, i, hits.bary_u, static_cast<float>(u));
    set_in(group, i, hits.bary_v, static_cast<float>(v));
    set_in(group, i, hits.s, s);
  }
}

// An origin on a triangle is rounded by a few ulps of where it lies, and so are the corners; the
// farthest of these bounds both.
template <class Corners>
void set_float_noise(const Corners& corners, const Lanes<std::int32_t>& group,
                     Lanes<double>& noise) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 a(corners.a.at(i));
    const Vec3 b(corners.b.at(i));
    const Vec3 c(corners.c.at(i));
    const double squared = std::max(std::max(glm::dot(a, a), glm::dot(b, b)), glm::dot(c, c));
    set_in(group, i, noise, 2.0 * float_noise * std::sqrt(squared));
  }
}

// A ray that grazes the plane keeps Embree's s: there the plane may be met anywhere.
void put_on_plane(const Vec3fLanes& corner, const Lanes<std::int32_t>& group, HitPacket& hits,
                  Lanes<double>& noise) {
  constexpr double grazing = 1e-6;  // squared cosine
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 k = hits.k.at(i);
    const Vec3 a(corner.at(i));
    const Vec3 normal(hits.facet_normal.at(i));
    const Vec3 point = hits.origin.at(i) + hits.s[i] * k;
    const double facing = glm::dot(normal, k);
    const double step = glm::dot(normal, a - point) / facing;
    const bool sane = facing * facing > grazing * glm::dot(normal, normal) * glm::dot(k, k);
    set_in(group, i, hits.s, hits.s[i] + (sane ? step : 0.0));
    const double squared = std::max(glm::dot(a, a), glm::dot(point, point));
    set_in(group, i, noise, 2.0 * float_noise * std::sqrt(squared));
  }
}

// Scaled by the largest component first: the squares of tiny triangles' normals vanish.
void set_facets(const FramePart& part, const HitPacket& hits, const Lanes<std::int32_t>& group,
                Vec3fLanes& facets) {
  const glm::mat3 m = part.rest_from_facet_normal;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3f normal = m * hits.facet_normal.at(i);
    const float largest =
        std::max(std::max(std::abs(normal.x), std::abs(normal.y)), std::abs(normal.z));
    const Vec3f scaled = normal * (1.0F / largest);
    const float inverse_length = 1.0F / std::sqrt(glm::dot(scaled, scaled));
    const bool along = glm::dot(scaled, hits.sight.at(i)) > 0.0F;
    set_in(group, i, facets, scaled * (along ? -inverse_length : inverse_length));
  }
}

// Of frames at rest in the world, whose traversal coordinates are rest-frame ones but for `offset`.
void set_resting_events(const Event<in::World>& anchor, const Vec3& offset, const HitPacket& hits,
                        const Lanes<std::int32_t>& group, HitEvents& events) {
  const Event<in::World> from = anchor;
  const Vec3 shift = offset;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double s = hits.s[i];
    const double t = hits.rest_t[i] + s * hits.rest_k_t[i];
    const Vec3 x = hits.origin.at(i) + s * hits.k.at(i) + shift;
    const double reach =
        std::abs(t + from.t) + sum_of_absolutes(x + from.x) + std::abs(t) + sum_of_absolutes(x);
    set_in(group, i, events.event.t, t + from.t);
    set_in(group, i, events.event.x, x + from.x);
    set_in(group, i, events.double_noise, 0x1p-50 * reach);
  }
}

}  // namespace

void RestFrame::gather_corners(const HitPacket& hits, int first, const Lanes<std::int32_t>& group,
                               CornerLanes& corners) const {
  const FramePart& part = parts_[hits.part[first]];
  const Vec3f* positions = part.positions.data();
  Lanes<const Triangle*> triangles;
  for (int i = 0; i < packet_size; ++i) {
    triangles[i] = &part.triangles[hits.triangle[group[i] != 0 ? i : first]];
  }
  // All misses under way before the first is waited for.
  for (const Triangle* t : triangles.lane) {
    for (const std::uint32_t vertex : *t) __builtin_prefetch(&positions[vertex]);
  }
  for (int i = 0; i < packet_size; ++i) {
    const Triangle& t = *triangles[i];
    corners.a.set(i, positions[t[0]]);
    corners.b.set(i, positions[t[1]]);
    corners.c.set(i, positions[t[2]]);
  }
}

void RestFrame::set_events(const HitPacket& hits, const Lanes<std::int32_t>& group,
                           HitEvents& events) const {
  const Event<in::World> anchor = coordinates_.anchor;
  const Vec3 offset = rest_from_traversal_offset_;
  if (coordinates_.from_world.is_identity() && !traversal_is_turned_) {
    return set_resting_events(anchor, offset, hits, group, events);
  }
  const Boost<in::World, in::Rest> world_from_rest = coordinates_.from_world.inverse();
  const double gamma = coordinates_.from_world.velocity().gamma();
  const Mat3 linear = rest_from_traversal_linear_;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 point = hits.origin.at(i) + hits.s[i] * hits.k.at(i);
    const Displacement<in::World> from_anchor = world_from_rest(Displacement<in::Rest>{
        hits.rest_t[i] + hits.s[i] * hits.rest_k_t[i], linear * point + offset});
    const Event<in::World> event = anchor + from_anchor;
    const double reach = std::abs(event.t) + sum_of_absolutes(event.x) +
                         gamma * (std::abs(from_anchor.t) + sum_of_absolutes(from_anchor.x));
    set_in(group, i, events.event.t, event.t);
    set_in(group, i, events.event.x, event.x);
    set_in(group, i, events.double_noise, 0x1p-50 * reach);
  }
}

// Embree tells where a ray meets a triangle from its first corner and its normal, both in float: along
// that plane no corner but the first matters, and it is never nearer than the plane itself.
RESTFRAME_CLONES void RestFrame::locate_on_plane(HitPacket& hits, int first,
                                                 const Lanes<std::int32_t>& group,
                                                 HitEvents& events) const {
  const FramePart& part = parts_[hits.part[first]];
  const bool at_hand = part.has_corners();
  Vec3fLanes corner;
  for (int i = 0; i < packet_size; ++i) {
    const std::uint32_t triangle = hits.triangle[group[i] != 0 ? i : first];
    corner.set(i, at_hand ? part.met_triangles[triangle].corner
                          : part.positions[part.triangles[triangle][0]]);
  }
  put_on_plane(corner, group, hits, events.float_noise);
  set_events(hits, group, events);
  set_facets(part, hits, group, events.facet);
}

RESTFRAME_CLONES void RestFrame::locate(HitPacket& hits, int first,
                                        const Lanes<std::int32_t>& group, bool by_clock,
                                        HitEvents& events) const {
  const FramePart& part = parts_[hits.part[first]];
  if (!by_clock && !part.instanced) return locate_on_plane(hits, first, group, events);
  CornerLanes corners;
  gather_corners(hits, first, group, corners);
  if (part.instanced) {
    PlacedCorners placed;
    transform(part.traversal_from_local, corners.a, placed.a);
    transform(part.traversal_from_local, corners.b, placed.b);
    transform(part.traversal_from_local, corners.c, placed.c);
    refine_group(placed, group, hits);
    set_float_noise(placed, group, events.float_noise);
  } else {
    refine_group(corners, group, hits);
    set_float_noise(corners, group, events.float_noise);
  }
  set_events(hits, group, events);
  set_facets(part, hits, group, events.facet);
}

RESTFRAME_CLONES void RestFrame::find_clear(const HitEvents& from, const Vec3fLanes& direction,
                                            const Lanes<double>& omega,
                                            const Lanes<std::int32_t>& group,
                                            Lanes<double>& s_clear) const {
  const Mat3 linear = traversal_from_rest_linear_;
  Lanes<double> stretch;  // of the direction, in traversal coordinates
  stretch.fill(1.0);
  if (traversal_is_turned_) {
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      const Vec3 turned = linear * Vec3(direction.at(i));
      stretch[i] = std::sqrt(glm::dot(turned, turned));
    }
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double cosine =
        static_cast<double>(std::abs(glm::dot(direction.at(i), from.facet.at(i))));
    const double off = from.float_noise[i] / (stretch[i] * std::max(least_cosine, cosine));
    set_in(group, i, s_clear, (off + from.double_noise[i]) / omega[i]);
  }
}

}  // namespace restframe
