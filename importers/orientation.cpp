#include "importers/orientation.h"

#include <fmt/format.h>

#include <algorithm>

#include "importers/edge_map.h"
#include "importers/nested_surfaces.h"
#include "importers/parity_sets.h"
#include "importers/weld.h"

namespace restframe {
namespace {

// Triangles by number, those that welding made lines or points left out.
struct Sides {
  std::vector<std::uint32_t> number;
  std::vector<Triangle> triangles;  // of places
};

Sides find_sides(const Mesh& mesh) {
  const std::vector<Triangle> all = welded_triangles(mesh, weld(mesh.positions));
  Sides sides;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const Triangle& t = all[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    sides.number.push_back(i);
    sides.triangles.push_back(t);
  }
  return sides;
}

// Which sides hang together, and which of them must be turned over to agree with the first of them.
class Winding {
 public:
  explicit Winding(const std::vector<Triangle>& triangles)
      : sets_(triangles.size()), broken_(triangles.size(), 0) {
    for_each_edge(sorted_half_edges(triangles), [this](const HalfEdge* edge, std::size_t count) {
      const std::uint32_t first = edge[0].corner / 3, second = edge[count - 1].corner / 3;
      const bool pair = count == 2;
      if (pair && sets_.unite(first, second, edge[0].forward == edge[1].forward)) return;
      for (std::size_t i = 0; i < count; ++i) broken_[edge[i].corner / 3] = 1;
    });
    for (std::uint32_t i = 0; i < broken_.size(); ++i) {
      if (broken_[i] != 0) broken_[sets_.find(i).root] = 1;
    }
  }

  ParitySets::Member find(std::uint32_t side) { return sets_.find(side); }
  bool is_closed(std::uint32_t root) const { return broken_[root] == 0; }

 private:
  ParitySets sets_;
  std::vector<char> broken_;
};

// The closed surfaces, their triangles wound alike.
std::vector<ClosedSurface> closed_surfaces(const Mesh& mesh, const Sides& sides) {
  Winding winding(sides.triangles);
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  std::vector<std::uint32_t> surface_of_root(sides.triangles.size(), none);
  std::vector<ClosedSurface> surfaces;
  for (std::uint32_t i = 0; i < sides.triangles.size(); ++i) {
    const auto [root, differs] = winding.find(i);
    if (!winding.is_closed(root)) continue;
    if (surface_of_root[root] == none) {
      surface_of_root[root] = static_cast<std::uint32_t>(surfaces.size());
      surfaces.emplace_back();
    }
    surfaces[surface_of_root[root]].add(mesh, sides.number[i], differs);
  }
  return surfaces;
}

// Whether the sides that differ are to be turned, or the others.
bool turns_those_that_differ(const ClosedSurface& surface, bool nested) {
  if (!nested && surface.volume != 0) return surface.volume > 0;
  return 2 * surface.differing <= surface.sides.size();
}

}  // namespace

std::size_t orient_outwards(Mesh& mesh) {
  const std::vector<ClosedSurface> surfaces = closed_surfaces(mesh, find_sides(mesh));
  NestedSurfaces nesting(mesh, surfaces);
  std::vector<std::uint32_t> turned;
  for (const ClosedSurface& surface : surfaces) {
    if (surface.differing == 0 && surface.volume >= 0) continue;
    const bool wanted = turns_those_that_differ(surface, nesting.is_nested(surface));
    for (const ClosedSurface::Side& side : surface.sides) {
      if (side.differs == wanted) turned.push_back(side.triangle);
    }
  }
  for (const std::uint32_t triangle : turned) {
    std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
  }
  return turned.size();
}

std::string turned_over(const std::string& file, std::size_t triangles) {
  return fmt::format("{}: {} triangles of closed surfaces were turned over, to face outwards", file,
                     triangles);
}

}  // namespace restframe
