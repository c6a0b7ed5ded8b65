// What is asked of a hit once Embree has found it: where and when exactly it is, in double, and how
// far a ray that leaves has to go to be clear of it.

#include <algorithm>
#include <array>
#include <cmath>

#include "frames/rest_frame.h"

namespace restframe {

std::array<Vec3, 3> RestFrame::corners(const HitPacket& hits, int lane) const {
  const FramePart& part = parts_[hits.part[lane]];
  const Triangle& triangle = part.triangles[hits.triangle[lane]];
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = Vec3(part.positions[triangle[i]]);
    if (part.instanced) corners[i] = Vec3(part.traversal_from_local * glm::dvec4(corners[i], 1.0));
  }
  return corners;
}

void RestFrame::refine(HitPacket& hits, int lane) const {
  const std::array<Vec3, 3> corners = this->corners(hits, lane);
  const Vec3 k = hits.k.at(lane);
  const Vec3 edge_u = corners[1] - corners[0];
  const Vec3 edge_v = corners[2] - corners[0];
  // From near the triangle, since far away the products below would lose their digits.
  const double s_near = hits.s[lane];
  const Vec3 origin = hits.origin.at(lane) + s_near * k - corners[0];

  // Moeller and Trumbore. A ray that grazes the triangle's plane can meet it far outside the
  // triangle, and Embree's float hit may lie just outside an edge: the weights are kept within it.
  const Vec3 p = glm::cross(k, edge_v);
  const double det = glm::dot(edge_u, p);
  double u = glm::dot(origin, p) / det;
  double v = glm::dot(k, glm::cross(origin, edge_u)) / det;
  if (!(std::abs(u) < 2.0 && std::abs(v) < 2.0)) {
    u = static_cast<double>(hits.bary_u[lane]);
    v = static_cast<double>(hits.bary_v[lane]);
  }
  u = std::clamp(u, 0.0, 1.0);
  v = std::clamp(v, 0.0, 1.0 - u);
  const Vec3 point = u * edge_u + v * edge_v;
  hits.bary_u[lane] = static_cast<float>(u);
  hits.bary_v[lane] = static_cast<float>(v);
  hits.s[lane] = s_near + glm::dot(point - origin, k) / glm::dot(k, k);
}

// In s: an origin on the surface is rounded by a few ulps across it, and Embree tells where it lies
// from the triangle's corners, however far those are; along a ray that grazes it that is further.
double RestFrame::clearance(const HitPacket& hits, int lane, const Vec3& traversal_k) const {
  constexpr double float_noise = 8.0 * 0x1p-24;
  constexpr double least_cosine = 1e-3;
  const Vec3 point = hits.origin.at(lane) + hits.s[lane] * hits.k.at(lane);
  const std::array<Vec3, 3> corners = this->corners(hits, lane);
  double squared = 0;
  for (const Vec3& corner : corners) squared = std::max(squared, glm::dot(corner, corner));
  const double size = glm::length(point) + std::sqrt(squared);
  const Vec3 facet(parts_[hits.part[lane]].rest_from_facet_normal * hits.facet_normal.at(lane));
  const Vec3 rest_k = rest_from_traversal_linear_ * traversal_k;
  const double cosine =
      std::abs(glm::dot(rest_k, facet)) / (glm::length(facet) * glm::length(rest_k));
  return float_noise * size / (glm::length(traversal_k) * std::max(least_cosine, cosine));
}

double RestFrame::s_behind(const HitPacket& hits, int lane) const {
  return hits.s[lane] + clearance(hits, lane, hits.k.at(lane));
}

Event<in::World> RestFrame::hit_event(const HitPacket& hits, int lane) const {
  const Vec3 point = hits.origin.at(lane) + hits.s[lane] * hits.k.at(lane);
  return coordinates_.to_world(
      {hits.rest_t[lane] + hits.s[lane] * hits.rest_k_t[lane], rest_position(point)});
}

}  // namespace restframe
