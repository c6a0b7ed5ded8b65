// The rest pose of skinned meshes. What is expected is worked out by hand from what the test puts into
// the file.

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
using GltfSkin = test::GltfReading;

// A triangle whose corners hang on two joints: the first on joint 0, the second on joint 1, the third
// half on each. Joint 0 is at the origin of the scene; joint 1 stands 5 up and is turned a quarter
// about z (x to y), in a parent that moves by 100 along x. The node of the mesh is far away.
GltfBuilder skinned_triangle(const std::vector<float>& weights = {1, 0, 0, 0, 0, 1, 0, 0, 0.5F,
                                                                  0.5F, 0, 0}) {
  GltfBuilder builder;
  const json attributes = {
      {"POSITION", builder.add_accessor<float>(triangle, "VEC3")},
      {"NORMAL", builder.add_accessor<float>({0, 0, 1, 1, 0, 0, 0, 0, 1}, "VEC3")},
      {"TANGENT", builder.add_accessor<float>({1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1}, "VEC4")},
      {"JOINTS_0",
       builder.add_accessor<std::uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4")},
      {"WEIGHTS_0", builder.add_accessor<float>(weights, "VEC4")}};
  builder.add_mesh({{"attributes", attributes}});
  const double half = std::sqrt(0.5);
  builder.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {-1000, 7, 9}}},
                           {{"name", "root"}},
                           {{"translation", {100, 0, 0}}, {"children", {3}}},
                           {{"translation", {0, 5, 0}}, {"rotation", {0, 0, half, half}}}};
  builder.json["skins"] = {{{"joints", {1, 3}}}};
  return builder;
}

TEST_F(GltfSkin, JointsCarryVerticesWhereverTheNodeIs) {
  const Asset asset = load(skinned_triangle());
  ASSERT_EQ(asset.parts.size(), 1U);
  EXPECT_EQ(asset.parts[0].asset_from_mesh, Mat4(1));
  const Mesh& mesh = asset.meshes.at(0);
  expect_near(mesh.positions.at(0), {0, 0, 0});
  expect_near(mesh.positions.at(1), {100, 6, 0});
  expect_near(mesh.positions.at(2), {49.5F, 3, 0});  // between (0 1 0) and (99 5 0)
  expect_near(mesh.normals.at(1), {0, 1, 0});
  expect_near(Vec3f(mesh.tangents.at(1)), {-1, 0, 0});
  EXPECT_EQ(mesh.tangents[1].w, 1);
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_TRUE(warned("asset.glb:/skins: skins of 1 nodes are not moved"));
}

TEST_F(GltfSkin, InverseBindMatricesComeFirst) {
  GltfBuilder builder = skinned_triangle();
  // Bound where it stands: joint 1's matrix undoes it, and scales by 2 along the joint's own x.
  const std::vector<float> matrices = {1, 0,  0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,   0,   0,
                                       1,  //
                                       0, -1, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, -10, 100, 0, 1};
  // x_joint = 2 (y - 5), y_joint = -(x - 100).
  builder.json["skins"][0]["inverseBindMatrices"] = builder.add_accessor<float>(matrices, "MAT4");
  const Mesh mesh = load(builder).meshes.at(0);
  expect_near(mesh.positions.at(0), {0, 0, 0});
  // (1 0 0) -> joint (-10, 99, 0) -> turned (-99, -10, 0) -> (1, -5, 0).
  expect_near(mesh.positions.at(1), {1, -5, 0});
  expect_near(mesh.normals.at(1), {1, 0, 0});
}

TEST_F(GltfSkin, NormalsStayUprightUnderUnevenScales) {
  GltfBuilder builder = skinned_triangle({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  builder.json["nodes"][1]["scale"] = {2, 1, 1};
  const std::vector<float> slanted = {0.6F, 0.8F, 0, 0.6F, 0.8F, 0, 0.6F, 0.8F, 0};
  builder.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      builder.add_accessor<float>(slanted, "VEC3");
  const Vec3f expected = glm::normalize(Vec3f(0.3F, 0.8F, 0));  // the inverse's transpose
  expect_near(load(builder).meshes.at(0).normals.at(0), expected);
}

TEST_F(GltfSkin, AMirroringNodeTurnsItsTrianglesOver) {
  GltfBuilder builder = skinned_triangle({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  // The mesh and its joints are below one node that mirrors, as exporters write it.
  builder.json["nodes"][0].erase("translation");
  builder.json["nodes"].push_back({{"scale", {-1, 1, 1}}, {"children", {0, 1}}});
  const Mesh mesh = load(builder).meshes.at(0);
  expect_near(mesh.positions.at(1), {-1, 0, 0});
  const Triangle& t = mesh.triangles.at(0);
  const Vec3f& a = mesh.positions[t[0]];
  EXPECT_GT(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a).z, 0);
  expect_near(mesh.normals.at(0), {0, 0, 1});
  expect_near(Vec3f(mesh.tangents.at(0)), {-1, 0, 0});
  EXPECT_EQ(mesh.tangents[0].w, -1);
}

TEST_F(GltfSkin, WeightsAreMadeToSumToOne) {
  const Mesh expected = load(skinned_triangle()).meshes.at(0);
  const std::vector<float> weights = {3, 0, 0, 0, 0, 0.5F, 0, 0, 0.25F, 0.25F, 0, 0};
  const Mesh mesh = load(skinned_triangle(weights)).meshes.at(0);
  for (std::size_t i = 0; i < 3; ++i) expect_near(mesh.positions.at(i), expected.positions.at(i));
  EXPECT_TRUE(warned("/meshes/0/primitives/0/attributes/WEIGHTS_0: the weights of 3 vertices"));
}

TEST_F(GltfSkin, SetsOfJointsAddUp) {
  GltfBuilder builder = skinned_triangle({1, 0, 0, 0, 0, 1, 0, 0, 0.5F, 0, 0, 0});
  const Mesh expected = load(skinned_triangle()).meshes.at(0);
  json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_1"] =
      builder.add_accessor<std::uint16_t>({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  attributes["WEIGHTS_1"] =
      builder.add_accessor<std::uint16_t>({0, 0, 0, 0, 0, 0, 0, 0, 32768, 0, 0, 0}, "VEC4", true);
  const Vec3f third = load(builder).meshes.at(0).positions.at(2);
  EXPECT_LT(glm::distance(third, expected.positions.at(2)), 1e-3F);
}

TEST_F(GltfSkin, OneMeshMayBeSkinnedAndNot) {
  GltfBuilder builder = skinned_triangle();
  builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 1}}});
  const Asset asset = load(builder);
  ASSERT_EQ(asset.parts.size(), 2U);
  ASSERT_EQ(asset.meshes.size(), 2U);
  const Part& still = asset.parts[1];
  EXPECT_EQ(asset.meshes[static_cast<std::size_t>(still.mesh)].positions.at(1), Vec3f(1, 0, 0));
  EXPECT_EQ(Vec3(still.asset_from_mesh[3]), Vec3(0, 0, 1));
}

std::string fault_after(const std::function<void(GltfBuilder&)>& damage) {
  GltfBuilder builder = skinned_triangle();
  damage(builder);
  return fault_of_bytes(builder.glb());
}

TEST_F(GltfSkin, BadSkinsAreFaults) {
  const auto skin = [](const json& patch) {
    return fault_after([&](GltfBuilder& b) { b.json["skins"][0].merge_patch(patch); });
  };
  const std::string at = "/skins/0";
  expect_fault(skin({{"joints", nullptr}}), at + ": joints is missing");
  expect_fault(skin({{"joints", json::array()}}), at + "/joints: is empty");
  expect_fault(skin({{"joints", {1, 4}}}), at + "/joints/1: is 4");
  expect_fault(skin({{"joints", {1, 1}}}), at + "/joints: node 1 is listed twice");
  expect_fault(skin({{"inverseBindMatrices", 0}}),
               at + "/inverseBindMatrices: must be MAT4 of floats");
  const auto matrices = [](std::vector<float> numbers) {
    return fault_after([&](GltfBuilder& b) {
      b.json["skins"][0]["inverseBindMatrices"] = b.add_accessor<float>(numbers, "MAT4");
    });
  };
  std::vector<float> numbers = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  expect_fault(matrices(numbers), at + "/inverseBindMatrices: has 1 matrices for 2 joints");
  numbers.insert(numbers.end(), numbers.begin(), numbers.begin() + 16);
  EXPECT_EQ(matrices(numbers), "");
  numbers[19] = 0.5F;
  expect_fault(matrices(numbers), at + "/inverseBindMatrices: matrix 1 is not finite");
  numbers[19] = std::numeric_limits<float>::infinity();
  expect_fault(matrices(numbers), at + "/inverseBindMatrices: matrix 1 is not finite");
  expect_fault(fault_after([](GltfBuilder& b) {
                 b.json["nodes"][3]["translation"] = {1e200, 0, 0};
               }),
               at + "/joints/1: its transform is not finite or beyond 1e15");
  expect_fault(fault_after([](GltfBuilder& b) { b.json["nodes"][0].erase("mesh"); }),
               "/nodes/0/skin: the node has no mesh");
}

TEST_F(GltfSkin, BadJointsAndWeightsAreFaults) {
  const auto attribute = [](const char* name, const auto& make) {
    return fault_after([&](GltfBuilder& b) {
      b.json["meshes"][0]["primitives"][0]["attributes"][name] = make(b);
    });
  };
  const std::string at = "/meshes/0/primitives/0/attributes";
  expect_fault(
      attribute("JOINTS_0",
                [](GltfBuilder& b) {
                  return b.add_accessor<std::uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 2}, "VEC4");
                }),
      at + "/JOINTS_0: vertex 2 hangs on joint 2, the skin has 2");
  for (const float bad :
       {-0.5F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    expect_fault(
        attribute("WEIGHTS_0",
                  [&](GltfBuilder& b) {
                    return b.add_accessor<float>({1, 0, 0, 0, 1, 0, 0, bad, 1, 0, 0, 0}, "VEC4");
                  }),
        at + "/WEIGHTS_0: vertex 1 has weight ");
  }
  expect_fault(attribute("JOINTS_1", [](GltfBuilder&) { return 3; }),
               at + ": has 2 attributes JOINTS_n, but 1 WEIGHTS_n");
  expect_fault(fault_after([](GltfBuilder& b) {
                 b.json["meshes"][0]["primitives"][0]["attributes"].erase("JOINTS_0");
                 b.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
               }),
               "/nodes/0/skin: mesh 0 has a primitive without JOINTS_0 and WEIGHTS_0");
}

}  // namespace
}  // namespace restframe
