#include "scene/mesh.h"

#include <gtest/gtest.h>

namespace restframe {
namespace {

// The square [0, 1] x [0, 1] at height z, two triangles that share an edge, seen from +Z.
Mesh square(float z) {
  Mesh mesh;
  mesh.positions = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {{0, 0}};
  return mesh;
}

TEST(Mesh, BoundsHoldEveryVertex) {
  Mesh mesh = square(2);
  mesh.positions.push_back({-3, 5, -7});
  const Bounds bounds = bounds_of(mesh);
  EXPECT_EQ(bounds.lower, Vec3(-3, 0, -7));
  EXPECT_EQ(bounds.upper, Vec3(1, 5, 2));
  EXPECT_EQ(bounds.center(), Vec3(-1, 2.5, -2.5));
  EXPECT_TRUE(bounds_of(Mesh{}).empty());
}

TEST(Mesh, MaterialSlotIsThatOfTheLastRangeBegunBefore) {
  Mesh mesh;
  mesh.materials = {{0, 4}, {3, 1}, {4, 4}, {1000, 0}};
  for (const auto& [triangle, slot] :
       {std::pair{0U, 4}, {2U, 4}, {3U, 1}, {4U, 4}, {999U, 4}, {1000U, 0}, {4'000'000'000U, 0}}) {
    EXPECT_EQ(material_slot(mesh, triangle), slot) << triangle;
  }
}

TEST(Mesh, AppendShiftsIndicesAndOpensAMaterialRange) {
  Mesh mesh = square(0);
  append(mesh, square(1), 3);
  append(mesh, square(2), 3);
  append(mesh, Mesh{}, 5);
  EXPECT_EQ(mesh.positions.size(), 12U);
  ASSERT_EQ(mesh.triangles.size(), 6U);
  EXPECT_EQ(mesh.triangles[3], (Triangle{4, 6, 7}));
  EXPECT_EQ(mesh.triangles[4], (Triangle{8, 9, 10}));
  ASSERT_EQ(mesh.materials.size(), 2U);
  EXPECT_EQ(mesh.materials[1].first_triangle, 2U);
  EXPECT_EQ(mesh.materials[1].slot, 3);
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(Mesh, AppendToNothingTakesThePartAsItIs) {
  Mesh part = square(0), mesh;
  part.normals.assign(4, {1, 0, 0});
  append(mesh, part, 2);
  EXPECT_EQ(mesh.positions, part.positions);
  EXPECT_EQ(mesh.normals, part.normals);
  EXPECT_EQ(mesh.triangles, part.triangles);
  ASSERT_EQ(mesh.materials.size(), 1U);
  EXPECT_EQ(mesh.materials[0].slot, 2);
  EXPECT_TRUE(mesh.colors.empty());
}

TEST(Mesh, AppendFillsInUvsAndColors) {
  Mesh mesh = square(0), part = square(1);
  mesh.uvs[1].assign(4, {0.5F, 0.25F});
  part.colors.assign(4, Vec4f(0.1F));
  append(mesh, part, 0);
  EXPECT_TRUE(mesh.uvs[0].empty());
  ASSERT_EQ(mesh.uvs[1].size(), 8U);
  EXPECT_EQ(mesh.uvs[1][3], Vec2f(0.5F, 0.25F));
  EXPECT_EQ(mesh.uvs[1][4], Vec2f(0));
  ASSERT_EQ(mesh.colors.size(), 8U);
  EXPECT_EQ(mesh.colors[3], Vec4f(1));
  EXPECT_EQ(mesh.colors[4], Vec4f(0.1F));
}

TEST(Mesh, AppendFillsInFurtherUvSetsAndTangents) {
  Mesh mesh = square(0), part = square(1);
  mesh.normals.assign(4, {0, 0, 1});
  part.normals.assign(4, {0, 0, 1});
  part.tangents.assign(4, {1, 0, 0, -1});
  part.uvs.resize(3);
  part.uvs[2].assign(4, {0.5F, 0.25F});
  append(mesh, part, 0);
  append(mesh, square(2), 0);  // has fewer sets
  ASSERT_EQ(mesh.uvs.size(), 3U);
  ASSERT_EQ(mesh.uvs[2].size(), mesh.positions.size());
  EXPECT_EQ(mesh.uvs[2][3], Vec2f(0));
  EXPECT_EQ(mesh.uvs[2][4], Vec2f(0.5F, 0.25F));
  ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
  EXPECT_EQ(mesh.tangents[0], Vec4f(0));
  EXPECT_EQ(mesh.tangents[7], Vec4f(1, 0, 0, -1));
  EXPECT_EQ(mesh.tangents.back(), Vec4f(0));
}

TEST(Mesh, TakingVerticesTakesAllTheirAttributes) {
  Mesh mesh = square(0);
  mesh.uvs.resize(4);
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.uvs[3].emplace_back(static_cast<float>(i), 0.0F);
    mesh.tangents.emplace_back(static_cast<float>(i), 0.0F, 0.0F, 1.0F);
  }
  Mesh taken;
  take_vertices(mesh, {3, 1}, taken);
  ASSERT_EQ(taken.uvs.size(), 4U);
  EXPECT_TRUE(taken.uvs[0].empty());
  EXPECT_EQ(taken.uvs[3], (std::vector<Vec2f>{{3, 0}, {1, 0}}));
  EXPECT_EQ(taken.tangents, (std::vector<Vec4f>{{3, 0, 0, 1}, {1, 0, 0, 1}}));
  EXPECT_EQ(bytes_of(taken), 2 * (sizeof(Vec3f) + sizeof(Vec2f) + sizeof(Vec4f)));
}

// Every triangle of `mesh` in [first, last) has corners whose normals are +Z.
void expect_upward(const Mesh& mesh, std::size_t first, std::size_t last) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (std::size_t i = first; i < last; ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      EXPECT_EQ(mesh.normals.at(vertex), Vec3f(0, 0, 1)) << i;
    }
  }
}

TEST(Mesh, AppendFillsInTheNormalsOfTriangles) {
  Mesh smooth = square(1);
  smooth.normals.assign(4, {1, 0, 0});
  Mesh mesh = square(0);
  append(mesh, smooth, 1);
  expect_upward(mesh, 0, 2);
  EXPECT_EQ(mesh.normals[mesh.triangles[2][0]], Vec3f(1, 0, 0));
  EXPECT_EQ(mesh.positions[mesh.triangles[1][2]], Vec3f(0, 1, 0));

  mesh = smooth;
  append(mesh, square(0), 1);
  expect_upward(mesh, 2, 4);
  EXPECT_EQ(mesh.normals[mesh.triangles[1][1]], Vec3f(1, 0, 0));
  EXPECT_EQ(mesh.positions[mesh.triangles[3][1]], Vec3f(1, 1, 0));
}

TEST(Mesh, PaddingLeavesRoomForOneMoreVertex) {
  Mesh mesh = square(0);
  mesh.positions.shrink_to_fit();
  pad_for_embree(mesh);
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_GE(mesh.positions.capacity(), 5U);
}

}  // namespace
}  // namespace restframe
