#include "scene/mesh_closed.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace restframe {
namespace {

// Equal positions, -0 and 0 among them, have equal bits after this.
std::array<std::uint32_t, 3> bits_of(const Vec3f& p) {
  std::array<std::uint32_t, 3> bits{};
  for (int i = 0; i < 3; ++i) {
    bits[static_cast<std::size_t>(i)] = std::bit_cast<std::uint32_t>(p[i] + 0.0F);
  }
  return bits;
}

// Mixed so that the low bits, which pick the place, depend on all others.
std::size_t hash_of(const Vec3f& p) {
  std::uint64_t hash = 0;
  for (const std::uint32_t bits : bits_of(p)) {
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

// For each vertex the first one at its position, by a hash table of open addressing.
std::vector<std::uint32_t> first_at_position(const std::vector<Vec3f>& positions) {
  constexpr std::uint32_t none = ~0U;
  const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
  std::vector<std::uint32_t> table(mask + 1, none);
  std::vector<std::uint32_t> first(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    std::size_t place = hash_of(positions[v]) & mask;
    while (table[place] != none && positions[table[place]] != positions[v]) {
      place = (place + 1) & mask;
    }
    if (table[place] == none) table[place] = v;
    first[v] = table[place];
  }
  return first;
}

// Calls visit(from, to) for the three edges of each triangle that has an area's worth of corners.
template <class Visit>
void for_each_side(const std::vector<Triangle>& triangles, const Visit& visit) {
  for (const Triangle& t : triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    visit(t[0], t[1]);
    visit(t[1], t[2]);
    visit(t[2], t[0]);
  }
}

// The far ends of the sides at their lower end `low`: twice the vertex, and 1 more if the side runs
// towards it. Closed: they come in pairs.
bool all_paired(std::uint64_t* begin, std::uint64_t* end) {
  std::sort(begin, end);
  if ((end - begin) % 2 != 0) return false;
  for (const std::uint64_t* side = begin; side != end; side += 2) {
    if (side[0] % 2 != 0 || side[1] != side[0] + 1) return false;
  }
  return true;
}

// Counts the sides at each lower end, lays them side by side, and looks at one end after the other.
bool sides_are_paired(const std::vector<Triangle>& triangles, std::size_t vertices) {
  std::vector<std::size_t> ends(vertices + 1, 0);
  for_each_side(triangles, [&](std::uint32_t a, std::uint32_t b) { ++ends[std::min(a, b) + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  if (ends.back() == 0) return false;
  std::vector<std::uint64_t> sides(ends.back());
  std::vector<std::size_t> next(ends.begin(), ends.end() - 1);
  for_each_side(triangles, [&](std::uint32_t a, std::uint32_t b) {
    sides[next[std::min(a, b)]++] = 2 * std::uint64_t{std::max(a, b)} + (a < b ? 1U : 0U);
  });
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!all_paired(sides.data() + ends[v], sides.data() + ends[v + 1])) return false;
  }
  return true;
}

bool bound_a_body(const Mesh& mesh, std::vector<Triangle> triangles) {
  const std::vector<std::uint32_t> first = first_at_position(mesh.positions);
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& corner : triangle) corner = first[corner];
  }
  return sides_are_paired(triangles, mesh.positions.size());
}

}  // namespace

bool is_closed(const Mesh& mesh) {
  return bound_a_body(mesh, mesh.triangles);
}

bool is_closed(const Mesh& mesh, int slot) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (material_slot(mesh, i) == slot) triangles.push_back(mesh.triangles[i]);
  }
  return bound_a_body(mesh, std::move(triangles));
}

}  // namespace restframe
