#include "scene/tangent_points.h"

#include <array>
#include <bit>

namespace restframe {
namespace {

using Key = std::array<std::uint32_t, 8>;

// Adding 0 makes one zero of both.
Key key_of(const TangentPoints& points, std::uint32_t point) {
  const Vec3f& p = points.position(point);
  const Vec3f& n = points.normal(point);
  const Vec2f uv = points.uv(point);
  const std::array<float, 8> parts = {p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
  Key key;
  for (std::size_t i = 0; i < key.size(); ++i)
    key[i] = std::bit_cast<std::uint32_t>(parts[i] + 0.0F);
  return key;
}

std::size_t hash_of(const Key& key) {
  std::uint64_t h = 0;
  for (const std::uint32_t part : key) {
    h = (h ^ part) * 0x9E3779B97F4A7C15ULL;
    h ^= h >> 29U;
  }
  return static_cast<std::size_t>(h);
}

}  // namespace

TangentPoints::TangentPoints(const Mesh& mesh, int uv_set, const UvTransform& transform)
    : mesh_(mesh),
      uvs_(mesh.uvs[static_cast<std::size_t>(uv_set)]),
      transform_(transform),
      flat_(mesh.normals.empty()) {
  if (!flat_) return;
  facets_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    const Vec3 normal = glm::cross(Vec3(mesh.positions[t[1]]) - a, Vec3(mesh.positions[t[2]]) - a);
    const double length = glm::length(normal);
    facets_.push_back(length > 0 ? Vec3f(normal / length) : Vec3f(0));
  }
}

std::vector<std::uint32_t> welded(const TangentPoints& points) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  const std::size_t count = points.count();
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * count + 2), none);
  std::vector<std::uint32_t> first(count);
  for (std::uint32_t point = 0; point < count; ++point) {
    const Key key = key_of(points, point);
    std::size_t slot = hash_of(key) & (slots.size() - 1);
    while (slots[slot] != none && key_of(points, slots[slot]) != key) {
      slot = (slot + 1) & (slots.size() - 1);
    }
    if (slots[slot] == none) slots[slot] = point;
    first[point] = slots[slot];
  }
  return first;
}

}  // namespace restframe
