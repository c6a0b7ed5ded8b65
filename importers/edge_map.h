#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "scene/mesh.h"

namespace restframe {

// The edge of a triangle from its corner `corner` to the next; corners are counted through all
// triangles.
struct HalfEdge {
  std::uint32_t low, high;  // its ends, the smaller first
  std::uint32_t corner;
  bool forward;  // from low to high
};

inline std::uint32_t next_corner(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

// All edges of all triangles, those between the same ends side by side, in order of their corners.
std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& triangles);

// Calls visit(first, count) for the half-edges between each two ends.
void for_each_edge(const std::vector<HalfEdge>& edges,
                   const std::function<void(const HalfEdge*, std::size_t)>& visit);

// Whether the half-edges of one edge join two faces, wound alike.
inline bool joins(const HalfEdge* first, std::size_t count) {
  return count == 2 && first[0].forward != first[1].forward && first[0].low != first[0].high;
}

// Sets that grow together (union-find).
class CornerSets {
 public:
  explicit CornerSets(std::size_t size);
  std::uint32_t find(std::uint32_t corner);
  void unite(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

// Unites the corners at both ends of an edge that joins two faces.
void unite_across(CornerSets& sets, const HalfEdge* edge);

}  // namespace restframe
