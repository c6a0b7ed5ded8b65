#pragma once

#include <cstdint>
#include <vector>

#include "physics/vectors.h"
#include "scene/mesh.h"

namespace restframe {

// Cuts polygons into triangles by clipping ears, in the plane of the polygon's Newell normal.
class PolygonCutter {
 public:
  // Appends corners.size() - 2 triangles of indices into `corners`, wound as the polygon. A concave
  // polygon is covered exactly; one that has no proper cut (no area, crossing itself) becomes a fan
  // where no ear is left.
  void cut(const std::vector<Vec3>& corners, std::vector<Triangle>& triangles);

  // Ear tests grow with the square of a concave polygon's size; polygons met after so many tests in
  // all become fans. Says whether that happened.
  bool exhausted() const { return tests_left_ <= 0; }

 private:
  using Vec2 = glm::dvec2;
  struct Link {
    std::uint32_t previous, next;
  };

  bool project(const std::vector<Vec3>& corners);
  void link_corners();
  double turn(std::uint32_t corner) const;
  bool is_ear(std::uint32_t corner);
  void cut_quad(std::uint32_t first, std::vector<Triangle>& triangles) const;
  void cut_fan(std::uint32_t first, std::vector<Triangle>& triangles) const;

  std::int64_t tests_left_ = 150'000'000;
  std::vector<Vec2> points_;            // the corners in the polygon's plane, counter-clockwise
  std::vector<Link> links_;             // of the corners not yet cut off
  std::vector<std::uint32_t> concave_;  // corners that may lie in an ear
};

}  // namespace restframe
