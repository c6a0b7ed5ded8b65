// Accessors, geometry and graphs that would read beyond what is there, or never end.

#include <limits>

#include "support/hostile_gltf.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::HostileGltf;

class HostileAccessors : public HostileGltf {};
class HostileGeometry : public HostileGltf {};
class HostileGraph : public HostileGltf {};

TEST_F(HostileAccessors, ViewsBeyondBuffers) {
  expect_set("/bufferViews/0/byteLength", 45, "/bufferViews/0: ends at byte 45 of a buffer of 42");
  expect_set("/bufferViews/0/byteOffset", 0xFFFFFFFFU, "/bufferViews/0/byteOffset: is 4294967295");
  expect_set("/bufferViews/0/byteOffset", 1ULL << 63,
             "/bufferViews/0/byteOffset: is 9223372036854775808");
  expect_set("/bufferViews/0/byteOffset", std::numeric_limits<std::uint64_t>::max() - 30,
             "/bufferViews/0/byteOffset: is 18446744073709551585");
  expect_set("/bufferViews/0/byteOffset", -4, "/bufferViews/0/byteOffset: is -4");
  expect_set("/bufferViews/0/buffer", 1, "/bufferViews/0/buffer: is 1, must be an index below 1");
}

TEST_F(HostileAccessors, AccessorsBeyondViews) {
  expect_set("/accessors/0/byteOffset", 4, "/accessors/0: ends at byte 40 of a bufferView of 36");
  expect_set("/accessors/0/count", 4, "/accessors/0: ends at byte 48 of a bufferView of 36");
  expect_set("/accessors/0/count", 0xFFFFFFFFU, "/accessors/0: ends at byte 51539607540");
  expect_set("/accessors/0/bufferView", 9, "/accessors/0/bufferView: is 9");
}

TEST_F(HostileAccessors, Counts) {
  for (const json& count : {json(0), json(-1), json(1ULL << 32), json(1ULL << 63), json(2.5),
                            json("3"), json(nullptr)}) {
    expect_set("/accessors/0/count", count, "/accessors/0/count: is ", "must be a whole number");
  }
}

TEST_F(HostileAccessors, ComponentTypesAndStrides) {
  for (const int type : {0, 5119, 5124, 5127, 5130}) {
    expect_set("/accessors/0/componentType", type, "/accessors/0/componentType: is ");
  }
  expect_set("/accessors/0/type", "VEC5", "/accessors/0/type: is \"VEC5\"");
  expect_set("/bufferViews/0/byteStride", 5, "/bufferViews/0/byteStride: must be a multiple of 4");
  expect_set("/bufferViews/0/byteStride", 0, "/bufferViews/0/byteStride: is 0");
  expect_set("/bufferViews/0/byteStride", 256, "/bufferViews/0/byteStride: is 256");
  expect_set("/bufferViews/0/byteStride", 8, "/accessors/0: byteStride 8",
             "less than its 12 bytes");
}

TEST_F(HostileAccessors, SparseIndices) {
  const auto expect_sparse = [this](const std::vector<std::uint8_t>& indices, int count,
                                    const std::string& begin) {
    expect_broken(
        [&](GltfBuilder& b) {
          const int view = b.add_view(indices), values = b.add_view(std::vector<float>(6, 0));
          b.json["accessors"][0]["sparse"] = {
              {"count", count},
              {"indices", {{"bufferView", view}, {"componentType", 5121}}},
              {"values", {{"bufferView", values}}}};
        },
        "/accessors/0/sparse" + begin);
  };
  expect_sparse({1, 3}, 2, "/indices: index 3 at 1 is not below the count of 3");
  expect_sparse({2, 1}, 2, "/indices: index 1 at 1 is not above the one before");
  expect_sparse({1, 1}, 2, "/indices: index 1 at 1 is not above the one before");
  expect_sparse({0, 1}, 3, "/indices: ends at byte 3 of a bufferView of 2");
  expect_sparse({0, 1}, 4, "/count: is 4");
}

TEST_F(HostileGeometry, VertexIndices) {
  GltfBuilder builder = test::one_triangle();
  builder.bin[40] = 3;
  expect_bytes_refused(builder.glb(),
                       "/meshes/0/primitives/0/indices: index 3 is not below the 3 vertices");
}

TEST_F(HostileGeometry, PositionsThatAreNoPlaces) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 1.1e15F,
                          std::numeric_limits<float>::max()}) {
    GltfBuilder builder;
    const int positions = builder.add_accessor<float>({0, 0, 0, 1, bad, 0, 0, 1, 0}, "VEC3");
    builder.add_mesh({{"attributes", {{"POSITION", positions}}}});
    expect_bytes_refused(builder.glb(), "/meshes/0/primitives/0/attributes/POSITION: vertex 1 is",
                         "must be finite and below 1e15");
  }
}

TEST_F(HostileGeometry, AttributesThatDoNotFit) {
  const std::string attributes = "/meshes/0/primitives/0/attributes";
  expect_set(attributes, json::object(), attributes + ": POSITION is missing");
  expect_broken(
      [](GltfBuilder& b) {
        const int normals = b.add_accessor<float>({0, 0, 1}, "VEC3");
        b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
      },
      attributes + "/NORMAL: has 1 elements, POSITION 3");
}

TEST_F(HostileGeometry, ZerosTakeNoRoomInAFile) {
  // Without a bufferView an accessor is zeros.
  GltfBuilder builder = test::one_triangle();
  builder.json["accessors"][0].erase("bufferView");
  folder.write("zeros.glb", builder.glb());
  expect_rendered("zeros.glb", "1 triangles are degenerate");
  builder.json["accessors"][0]["count"] = 4'000'000'000U;
  expect_bytes_refused(builder.glb(),
                       "/meshes/0/primitives/0: geometry of more than 4000000000 bytes");
}

TEST_F(HostileGeometry, WhatIsOnlyWarnedOf) {
  GltfBuilder normals = test::one_triangle();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int bad = normals.add_accessor<float>({0, 0, 0, nan, 0, 1, 0, 0, 1}, "VEC3");
  normals.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = bad;
  folder.write("normals.glb", normals.glb());
  expect_rendered("normals.glb", "normal");
  GltfBuilder points = test::one_triangle();
  points.json["meshes"][0]["primitives"].push_back(
      {{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  points.json["meshes"][0]["primitives"].push_back(
      {{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  folder.write("points.glb", points.glb());
  expect_rendered("points.glb", "not renderable");
}

TEST_F(HostileGraph, CyclesAndSharedNodes) {
  expect_set("/nodes/0/children", {0}, "/nodes/0: is its own descendant: a cycle");
  expect_set("/nodes", {{{"children", {1}}}, {{"children", {2}}}, {{"children", {0}}}}, "/nodes/",
             "a cycle");
  expect_set("/nodes", {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}},
             "/nodes/1/children/0: node 2 has another parent, node 0");
}

TEST_F(HostileGraph, DoublingAndDepth) {
  json chain, doubling;
  for (int i = 0; i < 40; ++i) doubling.push_back({{"children", {i + 1, i + 1}}});
  doubling.push_back({{"mesh", 0}});
  expect_set("/nodes", doubling, "/nodes/0/children/1: node 1 has another parent");
  for (int i = 0; i < 100'000; ++i) chain.push_back({{"children", {i + 1}}});
  chain.push_back({{"mesh", 0}});
  expect_set("/nodes", chain, "/nodes/", "levels deep");
}

TEST_F(HostileGraph, Matrices) {
  expect_set("/nodes/0/matrix", {1, 0, 0}, "/nodes/0/matrix: has 3 numbers, must have 16");
  expect_set("/nodes/0/translation", {1, nullptr, 0}, "/nodes/0/translation/1: is null");
  expect_set("/nodes/0/rotation", {0, 0, 0, 0}, "/nodes/0/rotation: is a quaternion of length 0");
  expect_set("/nodes/0/scale", {1e200, 1, 1}, "/nodes/0: its transform is not finite");
  const std::string nan =
      R"({"asset":{"version":"2.0"},"nodes":[{"matrix":[NaN,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}]})";
  expect_bytes_refused(nan, "1:", "not JSON");
}

TEST_F(HostileGraph, ASingularMatrixLeavesItsNodeOut) {
  GltfBuilder builder = test::one_triangle();
  builder.json["nodes"][0]["matrix"] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  folder.write("flat.glb", builder.glb());
  expect_rendered("flat.glb", "/nodes/0");
}

}  // namespace
}  // namespace restframe
