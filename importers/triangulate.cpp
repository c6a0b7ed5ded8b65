#include "importers/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace restframe {
namespace {

using Vec2 = glm::dvec2;

// Twice the signed area of the triangle.
double area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Inside or on the edges of a counter-clockwise triangle.
bool covers(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& point) {
  return area(a, b, point) >= 0 && area(b, c, point) >= 0 && area(c, a, point) >= 0;
}

// Perpendicular to the polygon, as long as twice its area; relative to a corner, so that digits
// survive far from the origin.
Vec3 newell_normal(const std::vector<Vec3>& corners) {
  Vec3 normal(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return normal;
}

}  // namespace

void PolygonCutter::cut(const std::vector<Vec3>& corners, std::vector<Triangle>& triangles) {
  links_.resize(corners.size());
  link_corners();
  if (corners.size() == 3 || !project(corners)) return cut_fan(0, triangles);

  std::uint32_t corner = 0;
  std::size_t left = corners.size(), misses = 0;
  while (left > 4) {
    if (misses > left || exhausted()) return cut_fan(corner, triangles);
    const auto [previous, next] = links_[corner];
    if (is_ear(corner)) {
      triangles.push_back({previous, corner, next});
      links_[previous].next = next;
      links_[next].previous = previous;
      links_[corner] = {corner, corner};
      --left;
      misses = 0;
      corner = links_[next].next;  // not the neighbour: fewer slivers
    } else {
      ++misses;
      corner = next;
    }
  }
  cut_quad(corner, triangles);
}

// False if the polygon has no plane.
bool PolygonCutter::project(const std::vector<Vec3>& corners) {
  const Vec3 normal = newell_normal(corners);
  const double length = glm::length(normal);
  if (!(length > 0) || !std::isfinite(length)) return false;
  const Vec3 n = normal / length;
  const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 u = glm::normalize(glm::cross(axis, n));
  const Vec3 v = glm::cross(n, u);
  points_.clear();
  for (const Vec3& corner : corners) {
    const Vec3 offset = corner - corners[0];
    points_.emplace_back(glm::dot(offset, u), glm::dot(offset, v));
  }
  concave_.clear();
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    if (turn(i) <= 0) concave_.push_back(i);
  }
  return true;
}

void PolygonCutter::link_corners() {
  const auto count = static_cast<std::uint32_t>(links_.size());
  for (std::uint32_t i = 0; i < count; ++i) links_[i] = {(i + count - 1) % count, (i + 1) % count};
}

// Positive where the polygon is convex.
double PolygonCutter::turn(std::uint32_t corner) const {
  const auto [previous, next] = links_[corner];
  return area(points_[previous], points_[corner], points_[next]);
}

bool PolygonCutter::is_ear(std::uint32_t corner) {
  if (turn(corner) <= 0) return false;
  const auto [previous, next] = links_[corner];
  const Vec2 &a = points_[previous], &b = points_[corner], &c = points_[next];
  const Vec2 lower = glm::min(glm::min(a, b), c), upper = glm::max(glm::max(a, b), c);
  for (std::size_t i = 0; i < concave_.size(); ++i) {
    const std::uint32_t other = concave_[i];
    --tests_left_;
    const Vec2& point = points_[other];
    const bool near =
        point.x >= lower.x && point.x <= upper.x && point.y >= lower.y && point.y <= upper.y;
    if (!near && links_[other].next != other) continue;
    if (links_[other].next == other || turn(other) > 0) {  // cut off, or convex by now
      concave_[i--] = concave_.back();
      concave_.pop_back();
    } else if (point != a && point != b && point != c && covers(a, b, c, point)) {
      return false;
    }
  }
  return true;
}

// Along the diagonal that leaves no triangle turned over; of two such, the shorter.
void PolygonCutter::cut_quad(std::uint32_t first, std::vector<Triangle>& triangles) const {
  const std::uint32_t i = first, j = links_[i].next, k = links_[j].next, l = links_[k].next;
  const Vec2 &a = points_[i], &b = points_[j], &c = points_[k], &d = points_[l];
  const double least_ac = std::min(area(a, b, c), area(a, c, d));
  const double least_bd = std::min(area(a, b, d), area(b, c, d));
  const bool both = least_ac > 0 && least_bd > 0;
  if (both ? glm::distance(a, c) <= glm::distance(b, d) : least_ac >= least_bd) {
    triangles.insert(triangles.end(), {Triangle{i, j, k}, Triangle{i, k, l}});
  } else {
    triangles.insert(triangles.end(), {Triangle{i, j, l}, Triangle{j, k, l}});
  }
}

void PolygonCutter::cut_fan(std::uint32_t first, std::vector<Triangle>& triangles) const {
  std::uint32_t i = links_[first].next;
  for (std::uint32_t j = links_[i].next; j != first; j = links_[j].next) {
    triangles.push_back({first, i, j});
    i = j;
  }
}

}  // namespace restframe
