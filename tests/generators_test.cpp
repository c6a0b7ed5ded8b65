#include "scene/generators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "scene/error.h"

namespace restframe {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

struct Plane {
  Vec3 normal;
  double height;
};

Plane plane_of(const Mesh& mesh, const Triangle& triangle) {
  const Vec3 a = mesh.positions[triangle[0]], b = mesh.positions[triangle[1]],
             c = mesh.positions[triangle[2]];
  const Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
  return {normal, glm::dot(normal, a)};
}

// Edges in the direction in which their triangles run around, and how often.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    ++edges[{a, b}];
    ++edges[{b, c}];
    ++edges[{c, a}];
  }
  return edges;
}

void expect_closed(const Mesh& mesh) {
  const auto edges = directed_edges(mesh);
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.count({edge.second, edge.first})) << edge.first << " " << edge.second;
  }
}

class Balls : public ::testing::TestWithParam<int> {};

TEST_P(Balls, AreClosedAndFaceOutward) {
  const double radius = 2.5;
  const Mesh ball = make_ball({radius, GetParam()});
  const std::size_t triangles = 20U << (2 * GetParam());
  EXPECT_EQ(ball.name, "ball");
  ASSERT_EQ(ball.triangles.size(), triangles);
  EXPECT_EQ(ball.positions.size(), triangles / 2 + 2);  // Euler: V - E + F = 2, with E = 3F/2
  EXPECT_GT(ball.positions.capacity(), ball.positions.size());
  expect_closed(ball);
  for (const Triangle& triangle : ball.triangles) ASSERT_GT(plane_of(ball, triangle).height, 0);
}

TEST_P(Balls, LieOnTheSphereWithRadialNormals) {
  const double radius = 2.5;
  const Mesh ball = make_ball({radius, GetParam()});
  ASSERT_EQ(ball.normals.size(), ball.positions.size());
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    const Vec3 position = ball.positions[i], normal = ball.normals[i];
    ASSERT_NEAR(glm::length(position), radius, 3e-7 * radius);
    ASSERT_NEAR(glm::length(normal), 1, 3e-7);
    ASSERT_NEAR(glm::distance(radius * normal, position), 0, 3e-7 * radius);
  }
}

// Triangles that overlapped or left a hole would not sum up to the full solid angle, and flat faces
// enclose nearly the sphere's volume.
TEST_P(Balls, EncloseTheVolumeOfTheSphere) {
  const Mesh ball = make_ball({1, GetParam()});
  double volume = 0;
  for (const auto& [a, b, c] : ball.triangles) {
    const Vec3 p = ball.positions[a], q = ball.positions[b], r = ball.positions[c];
    volume += glm::dot(p, glm::cross(q, r)) / 6;
  }
  const double sphere = 4 * M_PI / 3;
  EXPECT_LT(volume, sphere);
  EXPECT_GT(volume, sphere * (1 - 0.5 * std::pow(0.3, GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Fineness, Balls, ::testing::Range(0, 6));

TEST(Ball, OfFinenessZeroIsTheIcosahedron) {
  // Edge over circumradius, as Euclid has it.
  const double edge = 1 / std::sin(2 * M_PI / 5);
  const Mesh ball = make_ball({1, 0});
  for (const auto& [a, b, c] : ball.triangles) {
    EXPECT_NEAR(glm::distance(ball.positions[a], ball.positions[b]), edge, 1e-6);
    EXPECT_NEAR(glm::distance(ball.positions[b], ball.positions[c]), edge, 1e-6);
  }
}

TEST(Ball, FinestHasThreeHundredThousandTriangles) {
  EXPECT_EQ(make_ball({1, 7}).triangles.size(), 327'680U);
}

TEST(Ball, RefusesWhatMakesNoBall) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double radius : {0.0, -1.0, nan, 1e30, std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(ball_faults({radius, 3}), Contains(HasSubstr("radius"))) << radius;
    EXPECT_THROW(make_ball({radius, 3}), InputError);
  }
  for (const int fineness : {-1, 8, 1000}) {
    EXPECT_THAT(ball_faults({1, fineness}), Contains(HasSubstr("fineness"))) << fineness;
  }
}

TEST(Ball, IsAnAsset) {
  const Asset asset = make_sphere_asset({2, 2});
  ASSERT_EQ(asset.meshes.size(), 1U);
  ASSERT_EQ(asset.parts.size(), 1U);
  ASSERT_EQ(asset.materials.size(), 1U);
  EXPECT_EQ(asset.materials[0].name, "ball");
  EXPECT_EQ(asset.materials[0].base_color.value, Vec3f(0.8F));
  EXPECT_EQ(asset.materials[0].metallic.value, 0);
}

TEST(Rod, IsAnOpenTubeAlongZ) {
  const Mesh rod = make_rod(0.5, 3, 12);
  EXPECT_EQ(rod.triangles.size(), 24U);
  const Bounds bounds = bounds_of(rod);
  EXPECT_NEAR(glm::distance(bounds.lower, Vec3(-0.5, -0.5, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(bounds.upper, Vec3(0.5, 0.5, 3)), 0, 1e-6);
  for (const Triangle& triangle : rod.triangles) {
    for (const std::uint32_t vertex : triangle) {
      const Vec3 position = rod.positions[vertex], normal = rod.normals[vertex];
      EXPECT_NEAR(glm::distance(0.5 * normal, position - Vec3(0, 0, position.z)), 0, 1e-6);
      EXPECT_GT(glm::dot(plane_of(rod, triangle).normal, normal), 0.9);
    }
  }
}

TEST(Rod, HasTwoRimsAndNoOtherOpenEdge) {
  const Mesh rod = make_rod(0.5, 3, 12);
  const auto edges = directed_edges(rod);
  int open = 0;
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    if (edges.count({edge.second, edge.first}) == 0) {
      ++open;
      EXPECT_EQ(rod.positions[edge.first].z, rod.positions[edge.second].z);
    }
  }
  EXPECT_EQ(open, 24);
}

}  // namespace
}  // namespace restframe
