#include "importers/nested_surfaces.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace restframe {
namespace {

std::array<Vec3, 3> corners_of(const Mesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

bool contains(const Bounds& outer, const Bounds& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
         glm::all(glm::greaterThanEqual(outer.upper, inner.upper));
}

// The solid angle that a triangle covers, seen from the origin: positive if its back is seen
// (Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30, 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  return 2 *
         std::atan2(glm::dot(a, glm::cross(b, c)),
                    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

}  // namespace

// The volume adds up tetrahedra from the surface's first corner.
void ClosedSurface::add(const Mesh& mesh, std::uint32_t triangle, bool differs) {
  sides.push_back({triangle, differs});
  if (differs) ++differing;
  const auto [a, b, c] = corners_of(mesh, triangle);
  for (const Vec3& corner : {a, b, c}) bounds.add(corner);
  const Vec3 origin = corners_of(mesh, sides[0].triangle)[0];
  const double part = glm::dot(a - origin, glm::cross(b - origin, c - origin)) / 6;
  volume += differs ? -part : part;
}

bool NestedSurfaces::is_nested(const ClosedSurface& surface) {
  const auto [a, b, c] = corners_of(mesh_, surface.sides[0].triangle);
  const Vec3 point = (a + b + c) / 3.0;
  work_left_ -= static_cast<std::int64_t>(surfaces_.size());
  for (const ClosedSurface& outer : surfaces_) {
    if (work_left_ < 0) return true;
    if (&outer == &surface || !contains(outer.bounds, surface.bounds)) continue;
    constexpr std::int64_t side_work = 10;  // of a solid angle, in comparisons of bounds
    work_left_ -= side_work * static_cast<std::int64_t>(outer.sides.size());
    if (work_left_ >= 0 && winds_around(outer, point)) return true;
  }
  return false;
}

// By the solid angle of all sides: a whole turn of 4 pi, or none.
bool NestedSurfaces::winds_around(const ClosedSurface& outer, const Vec3& point) const {
  double sum = 0;
  for (const ClosedSurface::Side& side : outer.sides) {
    const auto [a, b, c] = corners_of(mesh_, side.triangle);
    const double angle = solid_angle(a - point, b - point, c - point);
    sum += side.differs ? -angle : angle;
  }
  return std::abs(sum) > 2 * glm::pi<double>();
}

}  // namespace restframe
