// What rest_frame_hits.cpp tells of one hit, for all lanes of a packet that hit the same part.

#include <algorithm>
#include <cmath>

#include "frames/rest_frame.h"

namespace restframe {

// In traversal coordinates.
struct CornerLanes {
  Vec3Lanes a, b, c;
};

namespace {

constexpr double float_noise = 8.0 * 0x1p-24;
constexpr double least_cosine = 1e-3;

void replace(std::int32_t condition, double& value, double by) {
  value = condition != 0 ? by : value;
}

void replace(std::int32_t condition, float& value, float by) {
  value = condition != 0 ? by : value;
}

void replace(const Lanes<std::int32_t>& condition, int i, Vec3fLanes& value, const Vec3f& by) {
  replace(condition[i], value.x[i], by.x);
  replace(condition[i], value.y[i], by.y);
  replace(condition[i], value.z[i], by.z);
}

void replace(const Lanes<std::int32_t>& condition, int i, EventLanes<in::World>& value,
             const Event<in::World>& by) {
  replace(condition[i], value.t[i], by.t);
  replace(condition[i], value.x.x[i], by.x.x);
  replace(condition[i], value.x.y[i], by.x.y);
  replace(condition[i], value.x.z[i], by.x.z);
}

void transform(const Mat4& matrix, Vec3Lanes& points) {
  const Mat4 m = matrix;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) points.set(i, Vec3(m * glm::dvec4(points.at(i), 1.0)));
}

double sum_of_absolutes(const Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// As RestFrame::refine, which says why.
void refine_group(const CornerLanes& corners, const Lanes<std::int32_t>& group, HitPacket& hits) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 k = hits.k.at(i);
    const Vec3 edge_u = corners.b.at(i) - corners.a.at(i);
    const Vec3 edge_v = corners.c.at(i) - corners.a.at(i);
    const double s_near = hits.s[i];
    const Vec3 origin = hits.origin.at(i) + s_near * k - corners.a.at(i);
    const Vec3 p = glm::cross(k, edge_v);
    const double inverse_det = 1.0 / glm::dot(edge_u, p);
    const double exact_u = glm::dot(origin, p) * inverse_det;
    const double exact_v = glm::dot(k, glm::cross(origin, edge_u)) * inverse_det;
    const bool sane = (std::abs(exact_u) < 2.0) & (std::abs(exact_v) < 2.0);
    double u = sane ? exact_u : static_cast<double>(hits.bary_u[i]);
    double v = sane ? exact_v : static_cast<double>(hits.bary_v[i]);
    u = std::min(std::max(u, 0.0), 1.0);
    v = std::min(std::max(v, 0.0), 1.0 - u);
    const Vec3 point = u * edge_u + v * edge_v;
    const double s = s_near + glm::dot(point - origin, k) / glm::dot(k, k);
    replace(group[i], hits.bary_u[i], static_cast<float>(u));
    replace(group[i], hits.bary_v[i], static_cast<float>(v));
    replace(group[i], hits.s[i], s);
  }
}

void set_facets(const FramePart& part, const HitPacket& hits, const Lanes<std::int32_t>& group,
                Vec3fLanes& facets) {
  const glm::mat3 m = part.rest_from_facet_normal;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3f facet = m * hits.facet_normal.at(i);
    const Vec3 wide(facet);
    const double length = std::sqrt(glm::dot(wide, wide));
    const double scale = (glm::dot(facet, hits.sight.at(i)) > 0.0F ? -1.0 : 1.0) / length;
    replace(group, i, facets, Vec3f(wide * scale));
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
    corners.a.set(i, Vec3(positions[t[0]]));
    corners.b.set(i, Vec3(positions[t[1]]));
    corners.c.set(i, Vec3(positions[t[2]]));
  }
  if (!part.instanced) return;
  transform(part.traversal_from_local, corners.a);
  transform(part.traversal_from_local, corners.b);
  transform(part.traversal_from_local, corners.c);
}

void RestFrame::set_events(const HitPacket& hits, const CornerLanes& corners,
                           const Lanes<std::int32_t>& group, HitEvents& events) const {
  const Boost<in::World, in::Rest> world_from_rest = coordinates_.from_world.inverse();
  const Event<in::World> anchor = coordinates_.anchor;
  const double gamma = coordinates_.from_world.velocity().gamma();
  const Mat3 linear = rest_from_traversal_linear_;
  const Vec3 offset = rest_from_traversal_offset_;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 point = hits.origin.at(i) + hits.s[i] * hits.k.at(i);
    const Displacement<in::World> from_anchor = world_from_rest(Displacement<in::Rest>{
        hits.rest_t[i] + hits.s[i] * hits.rest_k_t[i], linear * point + offset});
    const Event<in::World> event = anchor + from_anchor;
    const Vec3 a = corners.a.at(i);
    const Vec3 b = corners.b.at(i);
    const Vec3 c = corners.c.at(i);
    const double squared = std::max(std::max(glm::dot(a, a), glm::dot(b, b)), glm::dot(c, c));
    const double size = std::sqrt(glm::dot(point, point)) + std::sqrt(squared);
    const double reach = std::abs(event.t) + sum_of_absolutes(event.x) +
                         gamma * (std::abs(from_anchor.t) + sum_of_absolutes(from_anchor.x));
    replace(group, i, events.event, event);
    replace(group[i], events.float_noise[i], float_noise * size);
    replace(group[i], events.double_noise[i], 0x1p-50 * reach);
  }
}

void RestFrame::locate(HitPacket& hits, int first, const Lanes<std::int32_t>& group,
                       HitEvents& events) const {
  CornerLanes corners;
  gather_corners(hits, first, group, corners);
  refine_group(corners, group, hits);
  set_events(hits, corners, group, events);
  set_facets(parts_[hits.part[first]], hits, group, events.facet);
}

void RestFrame::find_clear(const HitEvents& from, const Vec3fLanes& direction,
                           const Lanes<double>& omega, const Lanes<std::int32_t>& group,
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
    replace(group[i], s_clear[i], (off + from.double_noise[i]) / omega[i]);
  }
}

}  // namespace restframe
