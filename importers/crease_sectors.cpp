#include "importers/crease_sectors.h"

#include <algorithm>

#include "importers/edge_map.h"

namespace restframe {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

bool has_distinct_corners(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

// OpenMesh searches all edges of a position for each face there: squares of the counts.
bool is_quick_to_build(const Surface& surface) {
  constexpr std::uint64_t quick = 100'000'000;
  std::vector<std::uint64_t> counts(surface.positions, 0);
  for (const Triangle& triangle : surface.triangles) {
    for (const std::uint32_t position : triangle) ++counts[position];
  }
  std::uint64_t steps = 0;
  for (const std::uint64_t count : counts) steps += count * count;
  return steps <= quick + 50 * surface.triangles.size();
}

// Whether the faces at each position hang together over edges.
bool has_single_fans(const Surface& surface, CornerSets& fans) {
  std::vector<std::uint32_t> fan_of(surface.positions, none);
  for (std::uint32_t corner = 0; corner < 3 * surface.triangles.size(); ++corner) {
    std::uint32_t& fan = fan_of[surface.triangles[corner / 3][corner % 3]];
    if (fan == none) fan = fans.find(corner);
    if (fan != fans.find(corner)) return false;
  }
  return true;
}

}  // namespace

bool fits_half_edges(const Surface& surface) {
  const std::vector<Triangle>& triangles = surface.triangles;
  if (!std::all_of(triangles.begin(), triangles.end(), has_distinct_corners)) return false;
  if (!is_quick_to_build(surface)) return false;
  CornerSets fans(3 * triangles.size());
  bool fits = true;
  for_each_edge(sorted_half_edges(triangles), [&](const HalfEdge* edge, std::size_t count) {
    if (joins(edge, count)) {
      unite_across(fans, edge);
    } else if (count > 1) {
      fits = false;
    }
  });
  return fits && has_single_fans(surface, fans);
}

Sectors edge_map_sectors(const Surface& surface, double cos_crease) {
  const std::size_t corners = 3 * surface.triangles.size();
  CornerSets sets(corners);
  for_each_edge(sorted_half_edges(surface.triangles), [&](const HalfEdge* edge, std::size_t count) {
    if (!joins(edge, count)) return;
    const Vec3& a = surface.face_normals[edge[0].corner / 3];
    const Vec3& b = surface.face_normals[edge[1].corner / 3];
    if (is_smooth(a, b, cos_crease)) unite_across(sets, edge);
  });
  Sectors result;
  result.sector.resize(corners);
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const std::uint32_t leader = sets.find(corner);  // the lowest of its set, so numbered before
    result.sector[corner] = leader == corner ? result.count++ : result.sector[leader];
  }
  return result;
}

}  // namespace restframe
