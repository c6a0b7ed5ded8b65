#include "importers/edge_map.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace restframe {

// Sorted by counting on the lower end, then within each: positions are dense, so this is linear but
// for positions with very many edges.
std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  std::uint32_t greatest = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), 3 * t + i, from < to});
      greatest = std::max({greatest, from, to});
    }
  }
  std::vector<std::size_t> starts(static_cast<std::size_t>(greatest) + 2, 0);
  for (const HalfEdge& edge : edges) ++starts[edge.low + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<HalfEdge> sorted(edges.size());
  std::vector<std::size_t> places = starts;
  for (const HalfEdge& edge : edges) sorted[places[edge.low]++] = edge;
  for (std::size_t low = 0; low + 1 < starts.size(); ++low) {
    const auto at = [&](std::size_t i) { return sorted.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(starts[low]), at(starts[low + 1]), [](const HalfEdge& a, const HalfEdge& b) {
      return std::pair(a.high, a.corner) < std::pair(b.high, b.corner);
    });
  }
  return sorted;
}

void for_each_edge(const std::vector<HalfEdge>& edges,
                   const std::function<void(const HalfEdge*, std::size_t)>& visit) {
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].low == edges[first].low &&
           edges[last].high == edges[first].high) {
      ++last;
    }
    visit(&edges[first], last - first);
  }
}

CornerSets::CornerSets(std::size_t size) : parent_(size) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t CornerSets::find(std::uint32_t corner) {
  while (parent_[corner] != corner) {
    parent_[corner] = parent_[parent_[corner]];
    corner = parent_[corner];
  }
  return corner;
}

// The lower number leads, so that the outcome does not depend on the order.
void CornerSets::unite(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  parent_[std::max(a, b)] = std::min(a, b);
}

void unite_across(CornerSets& sets, const HalfEdge* edge) {
  sets.unite(edge[0].corner, next_corner(edge[1].corner));
  sets.unite(next_corner(edge[0].corner), edge[1].corner);
}

}  // namespace restframe
