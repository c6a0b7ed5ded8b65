// The rest pose of meshes with morph targets. What is expected is worked out by hand from what the
// test puts into the file.

#include <cmath>
#include <limits>

#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::expect_fault;
using test::expect_near;
using test::fault_of_bytes;
using test::GltfBuilder;
using test::triangle;
using GltfMorph = test::GltfReading;

// A triangle with normals (+z), tangents (+x) and UVs, and two targets: one lifts the third corner by
// 2, turns its normal and moves its UV; the other moves the second corner along x, by a sparse
// accessor.
GltfBuilder morphing_triangle() {
  GltfBuilder builder;
  const int values = builder.add_view<float>({10, 0, 0});
  const int indices = builder.add_view<std::uint8_t>({1});
  const json sparse = {{"count", 1},
                       {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                       {"values", {{"bufferView", values}}}};
  const int along_x = builder.add(
      "accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 3}, {"sparse", sparse}});
  const json lift = {
      {"POSITION", builder.add_accessor<float>({0, 0, 0, 0, 0, 0, 0, 0, 2}, "VEC3")},
      {"NORMAL", builder.add_accessor<float>({0, 0, 0, 0, 0, 0, 1, 0, 0}, "VEC3")},
      {"TANGENT", builder.add_accessor<float>({0, 0, 0, 0, 0, 0, -1, 0, -1}, "VEC3")},
      {"TEXCOORD_0", builder.add_accessor<float>({0, 0, 0, 0, 0.5F, 0.25F}, "VEC2")}};
  const json attributes = {
      {"POSITION", builder.add_accessor<float>(triangle, "VEC3")},
      {"NORMAL", builder.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")},
      {"TANGENT", builder.add_accessor<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1}, "VEC4")},
      {"TEXCOORD_0", builder.add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2")}};
  builder.add_mesh({{"attributes", attributes}, {"targets", {lift, {{"POSITION", along_x}}}}});
  return builder;
}

TEST_F(GltfMorph, TargetsWithoutWeightsAreNotAdded) {
  const Mesh mesh = load(morphing_triangle()).meshes.at(0);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_TRUE(warned("asset.glb:/meshes: morph targets of 1 meshes are not moved"));
}

TEST_F(GltfMorph, TargetsAreAddedWithTheMeshsWeights) {
  GltfBuilder builder = morphing_triangle();
  builder.json["meshes"][0]["weights"] = {1, 0.5};
  const Mesh mesh = load(builder).meshes.at(0);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {6, 0, 0}, {0, 1, 2}}));
  const float half = std::sqrt(0.5F);
  expect_near(mesh.normals.at(0), {0, 0, 1});
  expect_near(mesh.normals.at(2), {half, 0, half});
  EXPECT_EQ(mesh.tangents.at(1), Vec4f(1, 0, 0, 1));
  EXPECT_EQ(mesh.tangents.at(2), Vec4f(0, 0, -1, -1));
  EXPECT_EQ(mesh.uvs[0].at(2), Vec2f(0.5F, 1.25F));
}

TEST_F(GltfMorph, NodesHaveWeightsOfTheirOwn) {
  GltfBuilder builder = morphing_triangle();
  builder.json["meshes"][0]["weights"] = {1, 0};
  builder.json["nodes"].push_back({{"mesh", 0}, {"weights", {0, 1}}});
  builder.json["nodes"].push_back({{"mesh", 0}, {"weights", {1, 0}}});
  const Asset asset = load(builder);
  ASSERT_EQ(asset.parts.size(), 3U);
  ASSERT_EQ(asset.meshes.size(), 2U);  // the first node and the third show the same
  const auto corners = [&](std::size_t part) {
    return asset.meshes[static_cast<std::size_t>(asset.parts[part].mesh)].positions;
  };
  EXPECT_EQ(corners(0), (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 2}}));
  EXPECT_EQ(corners(1), (std::vector<Vec3f>{{0, 0, 0}, {11, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(asset.parts[2].mesh, asset.parts[0].mesh);
}

TEST_F(GltfMorph, BadTargetsAreFaults) {
  const auto fault = [](const json& patch) {
    GltfBuilder builder = morphing_triangle();
    const int two = builder.add_accessor<float>({0, 0, 0, 0, 0, 0}, "VEC3");
    const int bytes = builder.add_accessor<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
    const int nan = builder.add_accessor<float>(
        {0, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0}, "VEC3");
    EXPECT_EQ(nan, bytes + 1);
    EXPECT_EQ(bytes, two + 1);
    builder.json["meshes"][0].merge_patch(patch);
    return fault_of_bytes(builder.glb());
  };
  const auto target = [&](int accessor) {
    GltfBuilder builder = morphing_triangle();
    json primitives = builder.json["meshes"][0]["primitives"];
    primitives[0]["targets"][1]["POSITION"] = accessor;
    return fault({{"primitives", primitives}, {"weights", {0, 1}}});
  };
  const std::string at = "/meshes/0/primitives/0/targets/1/POSITION: ";
  expect_fault(fault({{"weights", {1}}}), "/meshes/0/weights: has 1 numbers, must have 2");
  GltfBuilder builder = morphing_triangle();
  builder.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  expect_fault(fault_of_bytes(builder.glb()),
               "/meshes/0/primitives/0/targets/0/NORMAL: the primitive has no attribute");
  expect_fault(target(99), at + "is 99, must be an index below 12");
  expect_fault(target(9), at + "has 2 elements, POSITION 3");
  expect_fault(target(10), at + "has componentType 5121, not normalized, which it can not have");
  expect_fault(target(11), "/meshes/0/primitives/0/attributes/POSITION: vertex 1 is");
}

TEST_F(GltfMorph, PosesCountAgainstTheLimits) {
  ImportLimits limits;
  limits.triangles = 3;
  GltfBuilder builder = morphing_triangle();
  for (const double weight : {0.1, 0.2, 0.3}) {
    builder.json["nodes"].push_back({{"mesh", 0}, {"weights", {weight, 0.0}}});
  }
  expect_fault(fault_of_bytes(builder.glb(), limits),
               "/meshes/0: posed by nodes: more than 3 triangles in all");
  builder.json["nodes"].erase(3);
  EXPECT_EQ(fault_of_bytes(builder.glb(), limits), "");
}

}  // namespace
}  // namespace restframe
