// Where nodes of glTF files place their meshes.

#include <cmath>

#include "support/gltf_reading.h"

namespace restframe {
namespace {

using test::GltfBuilder;
using GltfNodes = test::GltfReading;

void expect_near(const Mat4& matrix, const std::vector<double>& columns) {
  for (int i = 0; i < 16; ++i) {
    EXPECT_NEAR(matrix[i / 4][i % 4], columns[static_cast<std::size_t>(i)], 1e-12) << "entry " << i;
  }
}

TEST_F(GltfNodes, ComposesTransformsDownTheHierarchy) {
  GltfBuilder builder = test::one_triangle();
  const double half = std::sqrt(0.5);
  // Rotates x to y about z after a mirroring scale; its child moves along its own x.
  builder.json["nodes"] = {{{"name", "child"}, {"mesh", 0}, {"translation", {10, 0, 0}}},
                           {{"rotation", {0, 0, half, half}},
                            {"scale", {-2, 3, 4}},
                            {"translation", {1, 2, 3}},
                            {"children", {0}}}};
  const Asset asset = load(builder);
  ASSERT_EQ(asset.parts.size(), 1U);
  EXPECT_EQ(name_of(asset, asset.parts[0]), "child");
  // x -> -2 y, y -> -3 x, z -> 4 z; (10, 0, 0) -> (1, 2 - 20, 3).
  expect_near(asset.parts[0].asset_from_mesh, {0, -2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 1, -18, 3, 1});
}

TEST_F(GltfNodes, ReadsMatricesAndSharesMeshes) {
  GltfBuilder builder = test::one_triangle();
  const std::vector<double> mirror = {-1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
  builder.json["nodes"].push_back({{"mesh", 0}, {"matrix", mirror}});
  const Asset asset = load(builder);
  EXPECT_EQ(asset.meshes.size(), 1U);
  ASSERT_EQ(asset.parts.size(), 2U);
  EXPECT_EQ(asset.parts[1].mesh, 0);
  expect_near(asset.parts[1].asset_from_mesh, mirror);
}

TEST_F(GltfNodes, ReadsTheDefaultSceneOrTheFirst) {
  GltfBuilder builder = test::one_triangle();
  builder.json["nodes"][0]["name"] = "first";
  builder.json["nodes"].push_back({{"mesh", 0}, {"name", "second"}});
  builder.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  const auto shown = [&] {
    const AssetTree tree = load(builder).tree;
    std::string names;
    for (const NodeRange& range : nodes_of_default_scene(tree)) {
      for (int i = range.begin; i < range.end; ++i)
        names += tree.nodes.at(static_cast<std::size_t>(i)).name + " ";
    }
    return names;
  };
  EXPECT_EQ(shown(), "first ");
  builder.json["scene"] = 1;
  EXPECT_EQ(shown(), "second ");
}

TEST_F(GltfNodes, LeavesOutFlattenedNodesWithAWarning) {
  GltfBuilder builder = test::one_triangle();
  builder.json["nodes"].push_back({{"mesh", 0}, {"scale", {1, 0, 1}}});
  EXPECT_EQ(load(builder).parts.size(), 1U);
  EXPECT_TRUE(warned("asset.glb:/nodes/1: flattened"));
  builder.json["nodes"][1]["scale"] = {1e-9, 1e-9, 1e-9};  // small is not flat
  EXPECT_EQ(load(builder).parts.size(), 2U);
}

TEST_F(GltfNodes, ReadsInstances) {
  GltfBuilder builder = test::one_triangle();
  const float half = std::sqrt(0.5F);
  builder.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  builder.json["nodes"][0]["translation"] = {100, 0, 0};
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", builder.add_accessor<float>({1, 0, 0, 0, 2, 0}, "VEC3")},
      {"ROTATION", builder.add_accessor<float>({0, 0, 0, 1, 0, 0, half, half}, "VEC4")},
      {"SCALE", builder.add_accessor<float>({1, 1, 1, 2, 2, 2}, "VEC3")}};
  const Asset asset = load(builder);
  EXPECT_TRUE(warnings_.empty());
  ASSERT_EQ(asset.parts.size(), 2U);
  expect_near(asset.parts[0].asset_from_mesh, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 101, 0, 0, 1});
  const Vec3 corner(asset.parts[1].asset_from_mesh * glm::dvec4(1, 0, 0, 1));
  EXPECT_LT(glm::distance(corner, Vec3(100, 4, 0)), 1e-6);
}

}  // namespace
}  // namespace restframe
