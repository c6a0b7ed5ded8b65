#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "scene/error.h"
#include "scene/generators.h"

namespace restframe {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Mesh flattened(const Asset& asset) {
  Mesh all;
  for (const Part& part : asset.parts) {
    Mesh moved = asset.meshes.at(static_cast<std::size_t>(part.mesh));
    for (Vec3f& position : moved.positions) {
      position = Vec3(part.asset_from_mesh * glm::dvec4(position, 1));
    }
    for (Vec3f& normal : moved.normals) normal = Mat3(part.asset_from_mesh) * Vec3(normal);
    append(all, moved, material_slot(moved, 0));
  }
  return all;
}

// 7 x 7 x 20 balls; rods: 6 x 7 x 20 along x and along y each, 7 x 7 x 19 along z.
TEST(Lattice, OfThePaperHasTheCountsOfTheBench) {
  const int balls = 7 * 7 * 20, rods = 2 * 6 * 7 * 20 + 7 * 7 * 19;
  const Asset flat = make_lattice({}, true);
  ASSERT_EQ(flat.meshes.size(), 1U);
  EXPECT_EQ(flat.meshes[0].triangles.size(), balls * 1280U + rods * 32U);
  EXPECT_EQ(flat.meshes[0].triangles.size(), 1'337'952U);
  EXPECT_EQ(lattice_triangles({}), 1'337'952U);
  EXPECT_EQ(lattice_parts({}), static_cast<std::uint64_t>(balls + rods));
  ASSERT_EQ(flat.meshes[0].materials.size(), 2U);
  EXPECT_EQ(flat.meshes[0].materials[1].first_triangle, balls * 1280U);
  EXPECT_GT(flat.meshes[0].positions.capacity(), flat.meshes[0].positions.size());
  EXPECT_EQ(make_lattice({}, false).parts.size(), static_cast<std::size_t>(balls + rods));
}

TEST(Lattice, IsCentredOnTheOrigin) {
  const LatticeSettings settings{3, 1, 4, 2.0, 0.25, 0.1, 0, 8};
  const Bounds bounds = bounds_of(make_lattice(settings, true).meshes[0]);
  EXPECT_NEAR(glm::length(bounds.center()), 0, 1e-6);
  // An icosahedron with an edge across the ends of the axes reaches phi / sqrt(1 + phi^2) of its
  // radius.
  const double reach = 0.25 * 0.8506508083520399;
  EXPECT_NEAR(glm::distance(0.5 * bounds.extent(), Vec3(2, 0, 3) + reach), 0, 1e-6);
}

TEST(Lattice, OfSharedPartsIsTheFlatOne) {
  const LatticeSettings settings{3, 2, 4, 1.5, 0.3, 0.1, 1, 5};
  const Asset shared = make_lattice(settings, false), flat = make_lattice(settings, true);
  ASSERT_EQ(shared.meshes.size(), 2U);
  EXPECT_EQ(shared.meshes[0].name, "ball");
  EXPECT_EQ(shared.meshes[1].name, "rod");
  const Mesh joined = flattened(shared);
  const Mesh& mesh = flat.meshes[0];
  ASSERT_EQ(joined.triangles, mesh.triangles);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    ASSERT_NEAR(glm::distance(joined.positions[i], mesh.positions[i]), 0, 1e-6);
    ASSERT_NEAR(glm::distance(joined.normals[i], mesh.normals[i]), 0, 1e-6);
  }
  ASSERT_EQ(joined.materials.size(), 2U);
  EXPECT_EQ(joined.materials[1].first_triangle, mesh.materials[1].first_triangle);
  EXPECT_EQ(joined.materials[1].slot, mesh.materials[1].slot);
}

TEST(Lattice, PartsAreTurnedButNeverMirrored) {
  for (const Part& part : make_lattice({3, 3, 3}, false).parts) {
    EXPECT_EQ(glm::determinant(Mat3(part.asset_from_mesh)), 1);
  }
}

TEST(Lattice, OfOneBallHasNoRod) {
  const Asset asset = make_lattice({1, 1, 1}, false);
  EXPECT_EQ(asset.meshes.size(), 1U);
  ASSERT_EQ(asset.parts.size(), 1U);
  EXPECT_EQ(name_of(asset, asset.parts[0]), "ball_0_0_0");
  EXPECT_EQ(make_lattice({1, 1, 1}, true).meshes[0].materials.size(), 1U);
}

// How deep `point` lies below the nearest face of a convex mesh; negative outside.
double depth_inside(const Mesh& ball, const Vec3& point) {
  double depth = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : ball.triangles) {
    const Vec3 p = ball.positions[a], q = ball.positions[b], r = ball.positions[c];
    const Vec3 normal = glm::normalize(glm::cross(q - p, r - p));
    depth = std::min(depth, glm::dot(normal, p - point));
  }
  return depth;
}

struct Joint {
  int fineness, sides;
  double ball, rod;
};
class Joints : public ::testing::TestWithParam<Joint> {};

// Each end of each rod, all around its rim, is inside the two balls that it joins; one point of the
// rim at least is just below the faces.
TEST_P(Joints, LieJustBelowTheFlatFaces) {
  const auto [fineness, sides, ball_radius, rod_radius] = GetParam();
  const Asset asset = make_lattice({2, 2, 2, 1.0, ball_radius, rod_radius, fineness, sides}, false);
  const Mesh &ball = asset.meshes.at(0), &rod = asset.meshes.at(1);
  int ends = 0;
  for (const Part& part : asset.parts) {
    if (part.mesh == 0) continue;
    std::map<std::array<double, 3>, double> least;
    for (const Vec3f& vertex : rod.positions) {
      const Vec3 point(part.asset_from_mesh * glm::dvec4(vertex, 1));
      const Vec3 center = glm::sign(point) * 0.5;  // of the ball in the point's octant
      const double depth = depth_inside(ball, point - center);
      ASSERT_GT(depth, 1e-4 * ball_radius);
      auto [entry, is_new] = least.emplace(std::array{center.x, center.y, center.z}, depth);
      entry->second = std::min(entry->second, depth);
    }
    for (const auto& [center, depth] : least) {
      EXPECT_LT(depth, 0.03 * ball_radius);
      ++ends;
    }
  }
  EXPECT_EQ(ends, 24);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Joints,
                         ::testing::Values(Joint{0, 3, 0.15, 0.05}, Joint{0, 16, 0.5, 0.3},
                                           Joint{1, 5, 0.15, 0.05}, Joint{2, 16, 0.3, 0.01},
                                           Joint{3, 16, 0.15, 0.05}, Joint{3, 16, 0.15, 0.14},
                                           Joint{5, 64, 0.4, 0.2}, Joint{3, 7, 1e-4, 5e-5}));

// The depth above is exact only where the faceted ball is convex: no vertex lies above another
// face.
TEST(Lattice, BallsAreConvex) {
  for (int fineness = 0; fineness <= 3; ++fineness) {
    const Mesh ball = make_ball({1, fineness});
    for (const Vec3f& vertex : ball.positions) ASSERT_GT(depth_inside(ball, vertex), -1e-6);
  }
}

TEST(Lattice, NamesEveryFault) {
  EXPECT_THAT(lattice_faults({}), IsEmpty());
  const auto has = [](const char* words) { return Contains(HasSubstr(words)); };
  EXPECT_THAT(lattice_faults({.cells_y = 0}), has("cells along y 0"));
  EXPECT_THAT(lattice_faults({.cells_z = -2147483647 - 1}), has("cells along z"));
  EXPECT_THAT(lattice_faults({.cells_x = 2147483647}), has("cells along x"));
  EXPECT_THAT(lattice_faults({.pitch = NAN}), has("pitch nan"));
  EXPECT_THAT(lattice_faults({.pitch = -1}), has("pitch -1"));
  EXPECT_THAT(lattice_faults({.ball_radius = INFINITY}), has("ball inf"));
  EXPECT_THAT(lattice_faults({.rod_radius = 0}), has("rod 0"));
  EXPECT_THAT(lattice_faults({.rod_sides = 2}), has("rod sides 2"));
  EXPECT_THAT(lattice_faults({.fineness = 8}), has("fineness 8"));
  EXPECT_THAT(lattice_faults({.rod_radius = 0.2}), has("rod 0.2 is thicker than ball 0.15"));
  EXPECT_THAT(lattice_faults({.rod_radius = 0.1499}), has("flat faces"));
  EXPECT_THAT(lattice_faults({.ball_radius = 0.6}), has("overlap at pitch 1"));
  EXPECT_THAT(lattice_faults({.pitch = 1e6}), has("single precision"));
  EXPECT_THAT(lattice_faults({10'000'000, 10'000'000, 10'000'000}), has("too many"));
  EXPECT_THAT(lattice_faults({.cells_x = -1, .cells_y = 0}), ::testing::SizeIs(2));
  EXPECT_THROW(make_lattice({.cells_y = 0}, false), InputError);
}

TEST(Lattice, OfAMillionBallsIsTooLargeOnlyWhenFlat) {
  const LatticeSettings settings{100, 100, 100};
  EXPECT_THAT(lattice_faults(settings), IsEmpty());
  EXPECT_THAT(lattice_faults(settings, true), Contains(HasSubstr("triangles are too many")));
  EXPECT_EQ(lattice_parts(settings), 1'000'000U + 3U * 99 * 100 * 100);
  EXPECT_EQ(lattice_parts({2147483647, 2147483647, 2147483647}),
            std::numeric_limits<std::uint64_t>::max());
}

}  // namespace
}  // namespace restframe
