#include "importers/mesh_split.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace restframe {
namespace {

using Indices = std::vector<std::uint32_t>;

void add_material(Mesh& mesh, std::size_t triangle, int slot) {
  if (!mesh.materials.empty() && mesh.materials.back().slot == slot) return;
  mesh.materials.push_back({static_cast<std::uint32_t>(triangle), slot});
}

constexpr std::uint32_t none = 0xFFFFFFFFU;

// The triangles `which` of `whole`. `renumbered` holds `none` for every vertex, before and after.
Mesh part_of(const TaggedMesh& whole, const Indices& which, Indices& renumbered) {
  Mesh result;
  Indices vertices;
  for (const std::uint32_t t : which) {
    Triangle triangle = whole.mesh.triangles[t];
    for (std::uint32_t& vertex : triangle) {
      if (renumbered[vertex] == none) {
        renumbered[vertex] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(vertex);
      }
      vertex = renumbered[vertex];
    }
    add_material(result, result.triangles.size(), whole.tags[t].slot);
    result.triangles.push_back(triangle);
  }
  for (const std::uint32_t vertex : vertices) renumbered[vertex] = none;
  take_vertices(whole.mesh, vertices, result);
  return result;
}

}  // namespace

std::vector<std::pair<int, Mesh>> split_by_group(TaggedMesh whole) {
  const std::vector<TriangleTag>& tags = whole.tags;
  std::vector<std::pair<int, Mesh>> result;
  const bool one = std::all_of(tags.begin(), tags.end(),
                               [&](const TriangleTag& tag) { return tag.group == tags[0].group; });
  if (one) {
    for (std::size_t t = 0; t < tags.size(); ++t) add_material(whole.mesh, t, tags[t].slot);
    result.emplace_back(tags[0].group, std::move(whole.mesh));
    return result;
  }
  Indices order(tags.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto group = [&](std::uint32_t t) { return tags[t].group; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return group(a) < group(b); });
  Indices renumbered(whole.mesh.positions.size(), none);
  for (auto first = order.begin(); first != order.end();) {
    const auto last = std::find_if(first, order.end(),
                                   [&](std::uint32_t t) { return group(t) != group(*first); });
    result.emplace_back(group(*first), part_of(whole, Indices(first, last), renumbered));
    first = last;
  }
  return result;
}

}  // namespace restframe
