#pragma once

#include <cstdint>
#include <vector>

#include "importers/corner_grid.h"
#include "physics/vectors.h"
#include "scene/mesh.h"

namespace restframe {

// Cuts polygons into triangles by clipping ears, in the plane of the polygon's Newell normal.
class PolygonCutter {
 public:
  // Appends corners.size() - 2 triangles of indices into `corners`, wound as the polygon. A polygon
  // without crossings is covered exactly, be it concave, touching itself, or with corners that
  // repeat or lie on straight edges (some triangles then have no area). Of one that crosses itself
  // the rest without an ear is cut by smallest corners; one without area becomes a fan.
  void cut(const std::vector<Vec3>& corners, std::vector<Triangle>& triangles);

  // Polygons met after so many steps in all (about a second's worth; ten thousand corners rarely
  // take thousandths of it) become fans. Says whether that happened.
  bool exhausted() const { return steps_left_ <= 0; }

 private:
  using Vec2 = glm::dvec2;
  struct Link {
    std::uint32_t previous, next;
  };

  bool project(const std::vector<Vec3>& corners);
  void link_corners();
  void clip_ears(std::uint32_t kept, std::vector<Triangle>& triangles);
  void collect_candidates(std::uint32_t first);
  void collect_concave();
  double turn(std::uint32_t corner) const;
  bool is_void(std::uint32_t corner) const;
  bool is_ear(std::uint32_t corner);
  bool blocks(std::uint32_t other, std::uint32_t ear) const;
  std::uint32_t smallest_corner(std::uint32_t first);
  void cut_off(std::uint32_t corner, std::vector<Triangle>& triangles);
  std::uint32_t cut_voids(std::vector<Triangle>& triangles);
  void cut_rest(std::uint32_t first, std::vector<Triangle>& triangles) const;
  void cut_quad(std::uint32_t first, std::vector<Triangle>& triangles) const;
  void cut_fan(std::uint32_t first, std::vector<Triangle>& triangles) const;

  std::int64_t steps_left_ = 150'000'000;
  std::vector<Vec2> points_;  // the corners in the polygon's plane, counter-clockwise
  std::vector<Link> links_;   // of the corners not yet cut off; of others, to themselves
  std::size_t left_ = 0;      // corners not yet cut off
  std::vector<std::uint32_t> concave_, candidates_;
  std::int64_t reach_ = 0;  // ears cover at most so many cells of the grid
  CornerGrid grid_;         // of the concave corners: only they can lie in an ear
};

}  // namespace restframe
