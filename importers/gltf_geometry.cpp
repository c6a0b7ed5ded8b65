#include "importers/gltf_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace restframe {
namespace {

template <class Element>
bool within(const Element& element) {
  return is_within(element, static_cast<float>(largest_coordinate));
}

// The first element that is not within bounds, or the size.
template <class Element>
std::size_t first_outside(const std::vector<Element>& elements) {
  bool all_within = true;
  for (const Element& element : elements) all_within &= within(element);
  if (all_within) return elements.size();
  const auto outside = std::find_if_not(elements.begin(), elements.end(), within<Element>);
  return static_cast<std::size_t>(outside - elements.begin());
}

template <class Element>
void check_within(const PrimitivePlace& place, const std::string& attribute,
                  const std::vector<Element>& elements, std::size_t first) {
  const std::size_t i = first_outside(elements);
  if (i == elements.size()) return;
  std::string text;
  for (int c = 0; c < Element::length(); ++c) {
    text += (c > 0 ? ", " : "") + std::to_string(elements[i][c]);
  }
  place.context.fault(
      place.pointer + "/attributes/" + attribute,
      "vertex " + std::to_string(first + i) + " is (" + text + "), must be finite and below 1e15");
}

Vec3f area_normal(const Mesh& mesh, const Triangle& triangle) {
  const Vec3 a(mesh.positions[triangle[0]]), b(mesh.positions[triangle[1]]),
      c(mesh.positions[triangle[2]]);
  const Vec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return length > 0 ? Vec3f(normal / length) : Vec3f(0);
}

}  // namespace

void check_positions(const PrimitivePlace& place, const std::vector<Vec3f>& positions,
                     std::size_t first) {
  check_within(place, "POSITION", positions, first);
}

void check_attributes(const PrimitivePlace& place, const Mesh& mesh, std::size_t first) {
  for (std::size_t set = 0; set < mesh.uvs.size(); ++set) {
    check_within(place, "TEXCOORD_" + std::to_string(set), mesh.uvs[set], first);
  }
  check_within(place, "COLOR_0", mesh.colors, first);
}

void check_indices(const PrimitivePlace& place, const std::uint32_t* indices, std::size_t count,
                   std::size_t vertices, std::uint32_t restart) {
  std::uint32_t greatest = 0;
  for (std::size_t i = 0; i < count; ++i) greatest = std::max(greatest, indices[i]);
  if (count == 0 || (greatest < vertices && greatest != restart)) return;
  place.context.fault(
      place.pointer + "/indices",
      "index " + std::to_string(greatest) +
          (greatest < vertices ? " is the greatest of its type: glTF has no primitive restart"
                               : " is not below the " + std::to_string(vertices) + " vertices"));
}

void mend_normals(const PrimitivePlace& place, Mesh& mesh) {
  std::size_t bad = 0;
  for (Vec3f& normal : mesh.normals) {
    const float squared = glm::dot(normal, normal);
    if (squared > 1e-20F && squared < 1e20F) {
      normal /= std::sqrt(squared);
    } else {
      normal = Vec3f(0);
      ++bad;
    }
  }
  if (bad == 0) return;
  std::vector<Vec3f> sums(mesh.normals.size(), Vec3f(0));
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3f normal = area_normal(mesh, triangle);
    for (const std::uint32_t vertex : triangle) sums[vertex] += normal;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (mesh.normals[i] != Vec3f(0)) continue;
    const float length = glm::length(sums[i]);
    mesh.normals[i] = length > 1e-6F ? sums[i] / length : Vec3f(0, 0, 1);
  }
  place.context.warn(place.pointer + "/attributes/NORMAL",
                     std::to_string(bad) + " normals without a direction were recomputed");
}

void mend_tangents(const PrimitivePlace& place, Mesh& mesh) {
  std::size_t bad = 0;
  for (Vec4f& tangent : mesh.tangents) {
    const Vec3f along(tangent);
    const float squared = glm::dot(along, along);
    if (squared > 1e-20F && squared < 1e20F) {
      tangent = Vec4f(along / std::sqrt(squared), tangent.w < 0 ? -1 : 1);
    } else {
      tangent = Vec4f(0);
      ++bad;
    }
  }
  if (bad == 0) return;
  place.context.warn(place.pointer + "/attributes/TANGENT",
                     std::to_string(bad) + " tangents have no direction and are left out");
}

std::vector<std::uint32_t> renumber_used(std::vector<Triangle>& triangles) {
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max(), greatest = 0;
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) {
      least = std::min(least, vertex);
      greatest = std::max(greatest, vertex);
    }
  }
  std::vector<std::uint32_t> used;
  if (triangles.empty()) return used;
  // 1 for those in use, then their new numbers. Others cost nothing here beyond that range.
  std::vector<std::uint32_t> numbers(std::size_t{greatest} - least + 1, 0);
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) numbers[vertex - least] = 1;
  }
  used.reserve(static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), 1U)));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == 0) continue;
    numbers[i] = static_cast<std::uint32_t>(used.size());
    used.push_back(least + static_cast<std::uint32_t>(i));
  }
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& vertex : triangle) vertex = numbers[vertex - least];
  }
  return used;
}

void drop_unused_vertices(Mesh& mesh) {
  const std::vector<std::uint32_t> used = renumber_used(mesh.triangles);
  if (used.size() < mesh.positions.size()) take_vertices(mesh, used, mesh);
}

}  // namespace restframe
