// Indices, incomplete triangles, shading without normals, and instances of primitives.

#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::expect_fault;
using test::fault_of_bytes;
using test::GltfBuilder;
using GltfPrimitives = test::GltfReading;

TEST_F(GltfPrimitives, WithoutNormalsShadingIsFlat) {
  GltfBuilder builder;
  // Two triangles that share an edge, folded a little: smooth under any crease angle.
  const int positions =
      builder.add_accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.1F}, "VEC3");
  const int indices = builder.add_accessor<std::uint8_t>({0, 1, 2, 2, 1, 3}, "SCALAR");
  builder.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const Mesh mesh = load(builder).meshes.at(0);
  EXPECT_TRUE(mesh.normals.empty());  // the triangles' own
  EXPECT_EQ(mesh.positions.size(), 4U);
}

TEST_F(GltfPrimitives, RestartValuesAreFaults) {
  const auto fault = [](const auto& indices, std::size_t vertices) {
    GltfBuilder builder;
    std::vector<float> positions(3 * vertices);
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = static_cast<float>(i % 7);
    const int accessor = builder.add_accessor<float>(positions, "VEC3");
    builder.add_mesh({{"attributes", {{"POSITION", accessor}}},
                      {"indices", builder.add_accessor(indices, "SCALAR")},
                      {"mode", 5}});
    return fault_of_bytes(builder.glb());
  };
  const std::string indices = "/meshes/0/primitives/0/indices: index ";
  const std::string restart = " is the greatest of its type: glTF has no primitive restart";
  expect_fault(fault(std::vector<std::uint8_t>{0, 1, 255, 2}, 300), indices + "255" + restart);
  expect_fault(fault(std::vector<std::uint8_t>{0, 1, 255, 2}, 10), indices + "255 is not below");
  expect_fault(fault(std::vector<std::uint16_t>{0, 1, 65535, 2}, 65536),
               indices + "65535" + restart);
  expect_fault(fault(std::vector<std::uint32_t>{0, 1, 0xFFFFFFFF}, 10),
               indices + "4294967295 is not below the 10 vertices");
  EXPECT_EQ(fault(std::vector<std::uint16_t>{0, 1, 255, 2}, 256), "");
}

TEST_F(GltfPrimitives, IncompleteTrianglesAreLeftOut) {
  for (const int mode : {4, 5, 6}) {
    GltfBuilder builder = test::one_triangle();
    builder.json["accessors"][1]["count"] = 2;
    builder.json["meshes"][0]["primitives"][0]["mode"] = mode;
    EXPECT_TRUE(load(builder).meshes.empty());
    EXPECT_TRUE(warned("/meshes/0/primitives/0: 2 corners after the last whole triangle"));
  }
}

TEST_F(GltfPrimitives, InstancesMayBeQuantizedAndSparse) {
  GltfBuilder builder = test::one_triangle();
  builder.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const int values = builder.add_view<float>({7, 8, 9});
  const int indices = builder.add_view<std::uint16_t>({1});
  const json sparse = {{"count", 1},
                       {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                       {"values", {{"bufferView", values}}}};
  const int translation = builder.add(
      "accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 2}, {"sparse", sparse}});
  // A quarter turn about z, in fractions of 127: within half a percent.
  const int rotation =
      builder.add_accessor<std::int8_t>({0, 0, 0, 127, 0, 0, 90, 90}, "VEC4", true);
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", translation}, {"ROTATION", rotation}};
  const Asset asset = load(builder);
  ASSERT_EQ(asset.parts.size(), 2U);
  EXPECT_EQ(asset.parts[0].asset_from_mesh, Mat4(1));
  const Mat4& turned = asset.parts[1].asset_from_mesh;
  EXPECT_EQ(Vec3(turned[3]), Vec3(7, 8, 9));
  EXPECT_LT(glm::distance(Vec3(turned[0]), Vec3(0, 1, 0)), 1e-12);  // normalised: exact
}

TEST_F(GltfPrimitives, UndeclaredExtensionsAreNamedOnce) {
  GltfBuilder builder = test::one_triangle();
  builder.json["extensionsUsed"] = {"EXT_declared"};
  builder.json["nodes"][0]["extensions"] = {{"EXT_one", json::object()}, {"EXT_declared", 1}};
  builder.json["meshes"][0]["extensions"] = {{"EXT_one", json::object()}};
  load(builder);
  EXPECT_TRUE(warned("/extensionsUsed/0: extension \"EXT_declared\" is left out"));
  EXPECT_TRUE(warned("/meshes/0/extensions: extension \"EXT_one\", which extensionsUsed does not"));
  EXPECT_EQ(warnings_.size(), 2U);
}

}  // namespace
}  // namespace restframe
