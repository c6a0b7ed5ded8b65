#include "scene/mesh.h"

#include <algorithm>
#include <limits>

#include "scene/error.h"
#include "scene/mesh_append.h"

namespace restframe {
namespace {

// Some unit vector for triangles without area; which one does not matter, nothing sees them.
Vec3f normal_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return length > 0 ? Vec3f(normal / length) : Vec3f(0, 0, 1);
}

template <class T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<std::uint32_t>& which) {
  std::vector<T> result;
  if (all.empty()) return result;
  result.reserve(which.size() + 1);
  for (const std::uint32_t i : which) result.push_back(all[i]);
  return result;
}

// Gives each triangle three vertices of its own with the triangle's normal: flat shading, stored.
void store_flat_normals(Mesh& mesh) {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  mesh.normals.clear();
  take_vertices(mesh, corners, mesh);
  std::uint32_t vertex = 0;
  for (Triangle& triangle : mesh.triangles) {
    triangle = {vertex, vertex + 1, vertex + 2};
    vertex += 3;
    const auto& p = mesh.positions;
    mesh.normals.insert(mesh.normals.end(), 3,
                        normal_of(p[triangle[0]], p[triangle[1]], p[triangle[2]]));
  }
}

// The number of vertices of the two meshes that become one, and what the first has room for.
struct JoinedCounts {
  std::size_t to, from, room;
};

// `to` holds one value for each of its vertices, or none; likewise `from`.
template <class T>
void append_attribute(const JoinedCounts& counts, std::vector<T>& to, std::vector<T> from,
                      const T& missing) {
  if (to.empty() && from.empty()) return;
  to.reserve(counts.room);
  to.resize(counts.to, missing);
  if (from.empty()) {
    to.resize(counts.to + counts.from, missing);
  } else {
    to.insert(to.end(), from.begin(), from.end());
  }
}

void append_range(Mesh& mesh, int slot) {
  if (mesh.triangles.empty()) {
    mesh.materials = {{0, slot}};
  } else if (mesh.materials.back().slot != slot) {
    mesh.materials.push_back({static_cast<std::uint32_t>(mesh.triangles.size()), slot});
  }
}

void append_same_normals(Mesh& mesh, Mesh part, int slot) {
  const std::size_t count = mesh.positions.size(), more = part.positions.size();
  if (count + more > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError("mesh '" + mesh.name + "': more than 4294967295 vertices");
  }
  if (!part.triangles.empty()) append_range(mesh, slot);
  const JoinedCounts counts{count, more, mesh.positions.capacity()};
  append_attribute(counts, mesh.normals, std::move(part.normals), Vec3f(0, 0, 1));
  append_attribute(counts, mesh.tangents, std::move(part.tangents), Vec4f(0));
  append_attribute(counts, mesh.colors, std::move(part.colors), Vec4f(1));
  const std::size_t sets = std::max(mesh.uvs.size(), part.uvs.size());
  mesh.uvs.resize(sets);
  part.uvs.resize(sets);
  for (std::size_t set = 0; set < sets; ++set) {
    append_attribute(counts, mesh.uvs[set], std::move(part.uvs[set]), Vec2f(0));
  }
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  const auto first = static_cast<std::uint32_t>(count);
  for (const Triangle& t : part.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

}  // namespace

Bounds bounds_of(const Mesh& mesh) {
  Bounds bounds;
  for (const Vec3f& position : mesh.positions) bounds.add(position);
  return bounds;
}

std::size_t bytes_of(const Mesh& mesh) {
  const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
  std::size_t sum = bytes(mesh.positions) + bytes(mesh.triangles) + bytes(mesh.normals) +
                    bytes(mesh.tangents) + bytes(mesh.colors);
  for (const std::vector<Vec2f>& uvs : mesh.uvs) sum += bytes(uvs);
  return sum;
}

std::size_t count_degenerate(const Mesh& mesh) {
  const auto has_no_area = [&](const Triangle& triangle) {
    // Products of differences of floats: in double none underflows to a false zero.
    const Vec3 a = mesh.positions[triangle[0]];
    const Vec3 b = mesh.positions[triangle[1]], c = mesh.positions[triangle[2]];
    return glm::cross(b - a, c - a) == Vec3(0);
  };
  const auto count = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), has_no_area);
  return static_cast<std::size_t>(count);
}

void take_vertices(const Mesh& from, const std::vector<std::uint32_t>& which, Mesh& to) {
  to.positions = picked(from.positions, which);
  to.normals = picked(from.normals, which);
  to.tangents = picked(from.tangents, which);
  to.uvs.resize(from.uvs.size());
  for (std::size_t set = 0; set < to.uvs.size(); ++set) to.uvs[set] = picked(from.uvs[set], which);
  to.colors = picked(from.colors, which);
}

int find_material_slot(const Mesh& mesh, std::uint32_t triangle) {
  const auto after = std::upper_bound(mesh.materials.begin(), mesh.materials.end(), triangle,
                                      [](std::uint32_t wanted, const MaterialRange& range) {
                                        return wanted < range.first_triangle;
                                      });
  return std::prev(after)->slot;
}

void append(Mesh& mesh, const Mesh& part, int slot) {
  append_and_free(mesh, part, slot);
}

void append_and_free(Mesh& mesh, Mesh part, int slot) {
  if (mesh.materials.empty()) mesh.materials = {{0, slot}};
  const bool both = !mesh.positions.empty() && !part.positions.empty();
  if (both && mesh.normals.empty() && !part.normals.empty()) store_flat_normals(mesh);
  if (both && part.normals.empty() && !mesh.normals.empty()) store_flat_normals(part);
  append_same_normals(mesh, std::move(part), slot);
}

void pad_for_embree(Mesh& mesh) {
  mesh.positions.reserve(mesh.positions.size() + 1);
}

}  // namespace restframe
