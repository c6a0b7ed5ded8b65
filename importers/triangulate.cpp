#include "importers/triangulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  left_ = corners.size();
  link_corners();
  if (corners.size() == 3 || !project(corners)) return cut_fan(0, triangles);

  const std::uint32_t kept = cut_voids(triangles);
  if (left_ <= 4) return cut_rest(kept, triangles);
  collect_concave();
  clip_ears(kept, triangles);
}

// Down to the last four corners. A corner is looked at again when a neighbour was cut off, and, as
// what lay in its way may be gone, after all others. Small ears go first: large ones take long to
// look through, and leave slivers.
void PolygonCutter::clip_ears(std::uint32_t kept, std::vector<Triangle>& triangles) {
  candidates_.clear();
  reach_ = 8;
  bool is_stuck = false;
  for (std::size_t i = 0; left_ > 4;) {
    if (exhausted()) return cut_fan(kept, triangles);
    std::uint32_t corner = 0;
    if (i < candidates_.size()) {
      corner = candidates_[i++];
      --steps_left_;
      if (links_[corner].next == corner || (!is_void(corner) && !is_ear(corner))) continue;
    } else if (!is_stuck || reach_ < grid_.cells()) {
      if (is_stuck) reach_ *= 4;
      collect_candidates(kept);
      is_stuck = true;  // unless one of them is cut off
      i = 0;
      continue;
    } else {
      corner = smallest_corner(kept);
    }
    const auto [previous, next] = links_[corner];
    cut_off(corner, triangles);
    candidates_.insert(candidates_.end(), {previous, next});
    kept = next;
    is_stuck = false;
  }
  cut_rest(kept, triangles);
}

// All that are left, every other one first: neighbours in turn would make slivers.
void PolygonCutter::collect_candidates(std::uint32_t first) {
  candidates_.clear();
  for (const bool odd : {true, false}) {
    bool is_odd = false;
    for (std::uint32_t i = links_[first].next; i != first; i = links_[i].next) {
      is_odd = !is_odd;
      if (is_odd == odd) candidates_.push_back(i);
    }
  }
  candidates_.push_back(first);
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

// Of those that are left.
void PolygonCutter::collect_concave() {
  concave_.clear();
  for (std::uint32_t i = 0; i < links_.size(); ++i) {
    if (links_[i].next != i && turn(i) <= 0) concave_.push_back(i);
  }
  grid_.build(points_, concave_);
}

// A corner that repeats its neighbour, or a spike without width: cut off, it takes nothing away.
bool PolygonCutter::is_void(std::uint32_t corner) const {
  const auto [previous, next] = links_[corner];
  const Vec2 &a = points_[previous], &b = points_[corner], &c = points_[next];
  return a == b || b == c || c == a;
}

bool PolygonCutter::is_ear(std::uint32_t corner) {
  if (turn(corner) <= 0) return false;
  const auto [previous, next] = links_[corner];
  const Vec2 &a = points_[previous], &b = points_[corner], &c = points_[next];
  const Vec2 lower = glm::min(glm::min(a, b), c), upper = glm::max(glm::max(a, b), c);
  if (grid_.cells(lower, upper) > reach_) return false;
  bool is_free = true;
  steps_left_ -= grid_.search(lower, upper, [&](std::uint32_t other) {
    if (links_[other].next == other || turn(other) > 0) return CornerGrid::Next::take_out;
    is_free = !blocks(other, corner);
    return is_free ? CornerGrid::Next::go_on : CornerGrid::Next::stop;
  });
  return is_free;
}

// Whether a concave corner lies in the ear, or on its edge and not at its ends.
bool PolygonCutter::blocks(std::uint32_t other, std::uint32_t ear) const {
  const auto [previous, next] = links_[ear];
  const Vec2 &a = points_[previous], &b = points_[ear], &c = points_[next];
  const Vec2& point = points_[other];
  return point != a && point != b && point != c && covers(a, b, c, point);
}

// The convex one that takes least away; if there is none, the least concave one.
std::uint32_t PolygonCutter::smallest_corner(std::uint32_t first) {
  const auto rank = [this](std::uint32_t i) {
    const double turned = turn(i);
    return std::pair(turned < 0, std::abs(turned));
  };
  std::uint32_t smallest = first;
  for (std::uint32_t i = links_[first].next; i != first; i = links_[i].next) {
    if (rank(i) < rank(smallest)) smallest = i;
  }
  steps_left_ -= static_cast<std::int64_t>(left_);
  return smallest;
}

void PolygonCutter::cut_off(std::uint32_t corner, std::vector<Triangle>& triangles) {
  const auto [previous, next] = links_[corner];
  triangles.push_back({previous, corner, next});
  links_[previous].next = next;
  links_[next].previous = previous;
  links_[corner] = {corner, corner};
  --left_;
}

// Before it is known what is concave: without a spike its neighbours may be. Returns a corner that
// is left.
std::uint32_t PolygonCutter::cut_voids(std::vector<Triangle>& triangles) {
  std::uint32_t corner = 0;
  for (std::size_t kept = 0; left_ > 3 && kept < left_;) {
    const auto [previous, next] = links_[corner];
    if (is_void(corner)) {
      cut_off(corner, triangles);
      corner = previous;
      kept = kept > 0 ? kept - 1 : 0;
    } else {
      ++kept;
      corner = next;
    }
  }
  return corner;
}

void PolygonCutter::cut_rest(std::uint32_t first, std::vector<Triangle>& triangles) const {
  if (left_ == 4) return cut_quad(first, triangles);
  cut_fan(first, triangles);
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
