#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/lattice_layout.h"
#include "scene/mesh_append.h"

namespace restframe {
namespace {

constexpr int ball_slot = 0, rod_slot = 1;

Material matte(const std::string& name, const Vec3f& color) {
  Material material;
  material.name = name;
  material.base_color.value = color;
  material.metallic.value = 0;
  material.roughness.value = 0.5F;
  return material;
}

Mat4 placed(const Mat3& rotation, const Vec3& translation) {
  Mat4 matrix(rotation);
  matrix[3] = glm::dvec4(translation, 1);
  return matrix;
}

// Calls place(asset_from_mesh, cell) for every ball.
template <class Place>
void place_balls(const LatticeSettings& settings, const Place& place) {
  for_each_cell(cells_of(settings), [&](const Cell& cell) {
    place(placed(Mat3(1), ball_center(settings, cell)), cell);
  });
}

// Calls place(asset_from_mesh, axis, cell) for every rod.
template <class Place>
void place_rods(const LatticeSettings& settings, double inset, const Place& place) {
  for (int axis = 0; axis < 3; ++axis) {
    for_each_cell(rod_cells(settings, axis), [&](const Cell& cell) {
      place(placed(rod_rotation(axis), rod_start(settings, axis, cell, inset)), axis, cell);
    });
  }
}

void append_placed(Mesh& mesh, const Mesh& part, const Mat4& matrix, int slot) {
  Mesh moved = part;
  for (Vec3f& position : moved.positions) position = Vec3(matrix * glm::dvec4(position, 1));
  for (Vec3f& normal : moved.normals) normal = Mat3(matrix) * Vec3(normal);
  append_and_free(mesh, std::move(moved), slot);
}

Mesh joined(const LatticeSettings& settings, const Mesh& ball, const Mesh& rod, double inset) {
  const auto balls =
      static_cast<std::size_t>(settings.cells_x) * settings.cells_y * settings.cells_z;
  const std::size_t rods = lattice_parts(settings) - balls;
  const std::size_t vertices = balls * ball.positions.size() + rods * rod.positions.size();
  Mesh lattice;
  lattice.name = "lattice";
  lattice.positions.reserve(vertices + 1);
  lattice.normals.reserve(vertices);
  lattice.triangles.reserve(lattice_triangles(settings));
  place_balls(settings, [&](const Mat4& matrix, const Cell&) {
    append_placed(lattice, ball, matrix, ball_slot);
  });
  place_rods(settings, inset, [&](const Mat4& matrix, int, const Cell&) {
    append_placed(lattice, rod, matrix, rod_slot);
  });
  return lattice;
}

void add_shared_parts(const LatticeSettings& settings, double inset, Asset& asset) {
  asset.parts.reserve(lattice_parts(settings));
  asset.tree.nodes.reserve(lattice_parts(settings));
  place_balls(settings, [&](const Mat4& matrix, const Cell& cell) {
    add_part(asset, 0, fmt::format("ball_{}_{}_{}", cell.x, cell.y, cell.z), matrix);
  });
  place_rods(settings, inset, [&](const Mat4& matrix, int axis, const Cell& cell) {
    add_part(asset, 1, fmt::format("rod_{}_{}_{}_{}", "xyz"[axis], cell.x, cell.y, cell.z), matrix);
  });
}

}  // namespace

double rod_inset(const Mesh& ball, double ball_radius, double rod_radius) {
  // The point of a circle of radius r around the axis, at height d above the centre, that is
  // nearest to a plane of normal n and distance h fulfils n_axis d + sqrt(1 - n_axis^2) r = h when
  // it touches.
  double lowest = ball_radius;
  for (const Triangle& triangle : ball.triangles) {
    const Vec3 a = ball.positions[triangle[0]];
    const Vec3 b = ball.positions[triangle[1]], c = ball.positions[triangle[2]];
    const Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const double h = glm::dot(normal, a);
    if (rod_radius >= h) return -ball_radius;
    for (int axis = 0; axis < 3; ++axis) {
      const double along = std::abs(normal[axis]);
      const double across = std::sqrt(std::max(0.0, 1 - along * along));
      if (along > 0) lowest = std::min(lowest, (h - across * rod_radius) / along);
    }
  }
  return lowest - 0.01 * ball_radius;
}

Mesh make_rod(double radius, double length, int sides) {
  Mesh rod;
  rod.name = "rod";
  rod.materials = {{0, 0}};
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const Vec3 normal(std::cos(angle), std::sin(angle), 0);
    const std::uint32_t near = 2 * i, far = near + 1;
    const std::uint32_t next_near = 2 * ((i + 1) % count), next_far = next_near + 1;
    rod.positions.emplace_back(radius * normal);
    rod.positions.emplace_back(radius * normal + Vec3(0, 0, length));
    rod.normals.insert(rod.normals.end(), 2, Vec3f(normal));
    rod.triangles.push_back({near, next_near, next_far});
    rod.triangles.push_back({near, next_far, far});
  }
  pad_for_embree(rod);
  return rod;
}

Asset make_lattice(const LatticeSettings& settings, bool flat) {
  if (const auto faults = lattice_faults(settings, flat); !faults.empty()) throw InputError(faults);
  const Mesh ball = make_ball({settings.ball_radius, settings.fineness});
  const double inset = rod_inset(ball, settings.ball_radius, settings.rod_radius);
  Mesh rod = make_rod(settings.rod_radius, rod_length(settings, inset), settings.rod_sides);
  rod.materials = {{0, rod_slot}};
  Asset asset;
  asset.name = "lattice";
  asset.materials = {matte("balls", {0.8F, 0.15F, 0.1F}), matte("rods", {0.7F, 0.7F, 0.75F})};
  if (flat) {
    asset.meshes.push_back(joined(settings, ball, rod, inset));
    add_part(asset, 0, "lattice");
  } else {
    add_shared_parts(settings, inset, asset);
    asset.meshes = {ball};
    if (asset.parts.back().mesh == 1) asset.meshes.push_back(rod);
  }
  for (Mesh& mesh : asset.meshes) pad_for_embree(mesh);
  return asset;
}

}  // namespace restframe
