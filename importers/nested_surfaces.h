#pragma once

#include <cstdint>
#include <vector>

#include "scene/mesh.h"

namespace restframe {

// A surface without edges, once all of its sides that differ from the first are turned over.
struct ClosedSurface {
  struct Side {
    std::uint32_t triangle = 0;
    bool differs = false;
  };

  std::vector<Side> sides;
  std::size_t differing = 0;
  double volume = 0;  // positive if the first side faces outwards
  Bounds bounds;

  void add(const Mesh& mesh, std::uint32_t triangle, bool differs);
};

// Tells which of the closed surfaces of a mesh lie within others of them.
class NestedSurfaces {
 public:
  // Both must stay as they are.
  NestedSurfaces(const Mesh& mesh, const std::vector<ClosedSurface>& surfaces)
      : mesh_(mesh), surfaces_(surfaces) {}

  // Works up to a bound; a surface for which none is left counts as nested.
  bool is_nested(const ClosedSurface& surface);

 private:
  bool winds_around(const ClosedSurface& outer, const Vec3& point) const;

  const Mesh& mesh_;
  const std::vector<ClosedSurface>& surfaces_;
  std::int64_t work_left_ = 300'000'000;
};

}  // namespace restframe
