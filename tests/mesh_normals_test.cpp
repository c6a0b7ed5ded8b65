#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "importers/crease_sectors.h"
#include "importers/importers.h"
#include "support/triangle_mesh.h"

namespace restframe {
namespace {

constexpr double pi = std::numbers::pi;

// The cube [0, 1]^3; bit i of a vertex's number is its coordinate i.
Mesh cube() {
  std::vector<Vec3f> positions;
  for (int i = 0; i < 8; ++i) positions.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  return mesh_of(positions, {{0, 2, 3},
                             {0, 3, 1},
                             {4, 5, 7},
                             {4, 7, 6},
                             {0, 1, 5},
                             {0, 5, 4},
                             {2, 6, 7},
                             {2, 7, 3},
                             {0, 4, 6},
                             {0, 6, 2},
                             {1, 3, 7},
                             {1, 7, 5}});
}

// Around the z axis; each row starts and ends with vertices of its own at one place, as UV seams
// make.
Mesh uv_sphere(int rows, int columns) {
  Mesh mesh;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= columns; ++j) {
      const double theta = pi * i / rows, phi = 2 * pi * (j % columns) / columns;
      const double ring = i % rows == 0 ? 0 : std::sin(theta);
      mesh.positions.emplace_back(ring * std::cos(phi), ring * std::sin(phi), std::cos(theta));
      mesh.uvs[0].emplace_back(static_cast<float>(j) / static_cast<float>(columns),
                               static_cast<float>(i) / static_cast<float>(rows));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (columns + 1) + j); };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i + 1 < rows) mesh.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

Vec3 face_normal(const Mesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  return glm::normalize(glm::cross(b - a, c - a));
}

// Every triangle where it was, every normal of unit length, every attribute as long as the
// positions.
void expect_whole(const Mesh& before, const Mesh& after) {
  ASSERT_EQ(after.triangles.size(), before.triangles.size());
  ASSERT_EQ(after.normals.size(), after.positions.size());
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(after.positions.at(after.triangles[t][i]),
                before.positions.at(before.triangles[t][i]));
    }
  }
  for (const Vec3f& normal : after.normals) EXPECT_NEAR(glm::length(normal), 1, 1e-5);
}

void expect_flat(const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t vertex : t) {
      EXPECT_LT(glm::distance(Vec3(mesh.normals[vertex]), face_normal(mesh, t)), 1e-6);
    }
  }
}

TEST(AddNormals, CubeBecomesFlatWithFourVerticesAFace) {
  const Mesh before = cube();
  Mesh mesh = before;
  testing::internal::CaptureStderr();
  add_normals(mesh, 40);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  expect_whole(before, mesh);
  EXPECT_EQ(mesh.positions.size(), 24U);
  expect_flat(mesh);
}

TEST(AddNormals, CubeIsSmoothWhenItsFoldsAreBelowTheCrease) {
  Mesh mesh = cube();
  add_normals(mesh, 100);
  ASSERT_EQ(mesh.positions.size(), 8U);
  // Weighted by angle, the three faces of a corner count alike however they are cut: along the
  // diagonal.
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3 outward = glm::normalize(Vec3(mesh.positions[i]) - Vec3(0.5));
    EXPECT_LT(glm::distance(Vec3(mesh.normals[i]), outward), 1e-6);
  }
}

TEST(AddNormals, CubeWithSeamsIsAsSmoothAsOneWithout) {
  const Mesh joined = cube();
  Mesh mesh;  // every corner a vertex of its own
  for (const Triangle& t : joined.triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const std::uint32_t vertex : t) mesh.positions.push_back(joined.positions[vertex]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  mesh.uvs[0].assign(36, Vec2f(0.25F));
  mesh.uvs[0][35] = Vec2f(0.75F);
  mesh.positions[0] = Vec3f(-0.0F, 0, 0);
  add_normals(mesh, 100);
  ASSERT_EQ(mesh.positions.size(), 36U);
  EXPECT_EQ(mesh.uvs[0][35], Vec2f(0.75F));
  for (std::size_t i = 0; i < 36; ++i) {
    const Vec3 outward = glm::normalize(Vec3(mesh.positions[i]) - Vec3(0.5));
    EXPECT_LT(glm::distance(Vec3(mesh.normals[i]), outward), 1e-6);
  }
}

TEST(AddNormals, SphereHasRadialNormals) {
  const Mesh before = uv_sphere(32, 64);
  Mesh mesh = before;
  add_normals(mesh);
  expect_whole(before, mesh);
  EXPECT_EQ(mesh.positions.size(), before.positions.size());
  EXPECT_EQ(mesh.uvs[0], before.uvs[0]);
  std::vector<bool> used(mesh.positions.size(), false);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t vertex : t) used[vertex] = true;
  }
  // Facets are 180/32 degrees: their normals are within half of that, and errors cancel to second
  // order.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!used[i]) continue;
    EXPECT_LT(glm::distance(mesh.normals[i], mesh.positions[i]), 0.02F);
  }
}

TEST(AddNormals, SplitsKeepAttributesAndMaterials) {
  Mesh mesh = cube();
  for (int i = 0; i < 8; ++i) {
    mesh.uvs[1].emplace_back(i, -i);
    mesh.colors.emplace_back(i, 0, 0, 1);
  }
  mesh.materials = {{0, 0}, {6, 1}};
  const Mesh before = mesh;
  add_normals(mesh);
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.uvs[1].at(mesh.triangles[t][i]), before.uvs[1][before.triangles[t][i]]);
      EXPECT_EQ(mesh.colors.at(mesh.triangles[t][i]), before.colors[before.triangles[t][i]]);
    }
  }
  EXPECT_TRUE(mesh.uvs[0].empty());
  ASSERT_EQ(mesh.materials.size(), 2U);
  EXPECT_EQ(mesh.materials[1].first_triangle, 6U);
}

// Pages of a book that share their back.
TEST(AddNormals, AnEdgeOfThreeFacesKeepsThemAll) {
  const Mesh before = mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0.1F, 0}, {0, 1, 0}},
                              {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  Mesh mesh = before;
  testing::internal::CaptureStderr();
  add_normals(mesh, 180);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  expect_whole(before, mesh);
  expect_flat(mesh);
}

// Two fans that touch in a point do not know of each other.
TEST(AddNormals, FansThatShareAPointAreSeparate) {
  const Mesh before = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, -1, -0.1F}},
                              {{0, 1, 2}, {0, 3, 4}});
  Mesh mesh = before;
  add_normals(mesh, 180);
  expect_whole(before, mesh);
  expect_flat(mesh);
}

TEST(AddNormals, MoebiusStripComesThroughWhole) {
  Mesh before;
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i) {
    const double phi = 2 * pi * i / steps;
    for (const double s : {-0.3, 0.3}) {
      const double radius = 1 + s * std::cos(phi / 2);
      before.positions.emplace_back(radius * std::cos(phi), radius * std::sin(phi),
                                    s * std::sin(phi / 2));
    }
  }
  for (std::uint32_t i = 0; i < steps; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1;
    const bool last = i + 1 == steps;
    const std::uint32_t c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    before.triangles.insert(before.triangles.end(), {Triangle{a, c, b}, Triangle{b, c, d}});
  }
  Mesh mesh = before;
  add_normals(mesh, 40);
  expect_whole(before, mesh);
  // Smooth but for the one edge where the winding turns over.
  EXPECT_EQ(mesh.positions.size(), before.positions.size() + 2);
}

TEST(AddNormals, DegenerateTrianglesGetFiniteUnitNormals) {
  const Mesh before = mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 0}},
                              {{0, 1, 3}, {0, 1, 2}, {0, 0, 1}, {0, 4, 3}, {3, 3, 3}});
  for (const double crease : {0.0, 40.0, 180.0}) {
    Mesh mesh = before;
    add_normals(mesh, crease);
    expect_whole(before, mesh);
    EXPECT_EQ(mesh.normals[mesh.triangles[0][1]], Vec3f(0, 0, 1));
  }
}

TEST(AddNormals, OppositeFacesCancelToSomeUnitNormal) {
  const Mesh before = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  Mesh mesh = before;
  add_normals(mesh, 181);
  expect_whole(before, mesh);
}

TEST(AddNormals, GivenNormalsStay) {
  Mesh mesh = cube();
  mesh.normals.assign(8, Vec3f(0, 1, 0));
  add_normals(mesh);
  EXPECT_EQ(mesh.positions.size(), 8U);
  EXPECT_EQ(mesh.normals[3], Vec3f(0, 1, 0));
}

// A disc of so many faces around one point that their squares can not be afforded.
TEST(AddNormals, ManyFacesAroundAPointAreNoProblem) {
  Mesh before;
  constexpr std::uint32_t count = 100'000;
  before.positions.emplace_back(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    before.positions.emplace_back(std::cos(2 * pi * i / count), std::sin(2 * pi * i / count), 0);
    before.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  Mesh mesh = before;
  add_normals(mesh);
  EXPECT_EQ(mesh.positions.size(), before.positions.size());
  EXPECT_LT(glm::distance(mesh.normals[0], Vec3f(0, 0, 1)), 1e-5F);
}

// A bumpy sheet: the half-edge walk and the edge map, made apart, find the same sectors.
TEST(CreaseSectors, BothWaysAgree) {
  constexpr std::uint32_t side = 30;
  Surface surface;
  surface.positions = side * side;
  std::vector<Vec3> points;
  std::uint32_t random = 12345;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    random = random * 1664525U + 1013904223U;
    points.emplace_back(i % side, i / side, static_cast<double>(random >> 8U) / (1U << 24U));
  }
  for (std::uint32_t i = 0; i + side < side * side; ++i) {
    if (i % side + 1 == side || i % 37 == 0) continue;  // with holes
    surface.triangles.push_back({i, i + 1, i + side});
    surface.triangles.push_back({i + 1, i + side + 1, i + side});
  }
  for (const Triangle& t : surface.triangles) {
    surface.face_normals.push_back(
        glm::normalize(glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])));
  }
  ASSERT_TRUE(fits_half_edges(surface));
  const Sectors walked = half_edge_sectors(surface, std::cos(0.6));
  const Sectors mapped = edge_map_sectors(surface, std::cos(0.6));
  ASSERT_EQ(walked.count, mapped.count);
  EXPECT_GT(walked.count, surface.positions);
  std::vector<std::uint32_t> mapped_from_walked(walked.count, 0xFFFFFFFFU);
  for (std::size_t corner = 0; corner < walked.sector.size(); ++corner) {
    std::uint32_t& known = mapped_from_walked[walked.sector[corner]];
    if (known == 0xFFFFFFFFU) known = mapped.sector[corner];
    EXPECT_EQ(known, mapped.sector[corner]);
  }
}

}  // namespace
}  // namespace restframe
