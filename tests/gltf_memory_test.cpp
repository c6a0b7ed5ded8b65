// Meshes of many primitives are joined in place, and the file's bytes are let go before images are
// decoded.

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "support/gltf_builder.h"
#include "support/gltf_faults.h"
#include "support/gltf_reading.h"
#include "support/image_files.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using GltfMemory = test::GltfReading;

// A row of `count` triangles from x = `first` on, without shared vertices.
std::vector<float> row(int count, float first) {
  std::vector<float> positions;
  for (int i = 0; i < count; ++i) {
    const float x = first + static_cast<float>(i);
    positions.insert(positions.end(), {x, 0, 0, x + 0.5F, 0, 0, x, 1, 0});
  }
  return positions;
}

json primitive(GltfBuilder& builder, int count, float first, const char* more = nullptr) {
  json attributes = {{"POSITION", builder.add_accessor(row(count, first), "VEC3")}};
  if (more != nullptr) {
    const std::vector<float> uvs(static_cast<std::size_t>(count) * 6, 0.25F);
    attributes[more] = builder.add_accessor(uvs, "VEC2");
  }
  return {{"attributes", attributes}};
}

TEST_F(GltfMemory, PrimitivesAreJoinedWithoutSpareRoom) {
  GltfBuilder builder;
  builder.add_mesh(primitive(builder, 7, 0, "TEXCOORD_0"));
  for (const int count : {1, 5, 2}) {
    builder.json["meshes"][0]["primitives"].push_back(
        primitive(builder, count, 100.0F * static_cast<float>(count)));
  }
  const Asset asset = load(builder);
  const Mesh& mesh = asset.meshes.at(0);
  ASSERT_EQ(mesh.triangles.size(), 15U);
  ASSERT_EQ(mesh.positions.size(), 45U);
  EXPECT_EQ(mesh.positions.capacity(), 46U);  // Embree reads past the last
  EXPECT_EQ(mesh.triangles.capacity(), 15U);
  EXPECT_EQ(mesh.uvs.at(0).capacity(), 46U);
  EXPECT_EQ(mesh.triangles[7], (Triangle{21, 22, 23}));
  EXPECT_EQ(mesh.positions[21], Vec3f(100, 0, 0));
  EXPECT_EQ(mesh.positions[24 + 14], Vec3f(504, 1, 0));
  EXPECT_EQ(mesh.positions[42], Vec3f(201, 0, 0));
  EXPECT_EQ(mesh.uvs[0][20], Vec2f(0.25F));
  EXPECT_EQ(mesh.uvs[0][21], Vec2f(0));  // that primitive has none
}

// As many exporters write them: one list of vertices, and indices for each material.
TEST_F(GltfMemory, SharedVerticesAreNoMoreThanTheFileHas) {
  GltfBuilder builder;
  builder.add_mesh(primitive(builder, 4, 0));
  json& primitives = builder.json["meshes"][0]["primitives"];
  const json attributes = primitives[0]["attributes"];
  primitives.clear();
  for (const auto& indices : {std::vector<std::uint8_t>{3, 4, 5, 9, 10, 11},
                              std::vector<std::uint8_t>{0, 1, 2},
                              {6, 7, 8}}) {
    primitives.push_back(
        {{"attributes", attributes}, {"indices", builder.add_accessor(indices, "SCALAR")}});
  }
  const Asset asset = load(builder);
  const Mesh& mesh = asset.meshes.at(0);
  ASSERT_EQ(mesh.positions.size(), 12U);
  EXPECT_EQ(mesh.positions.capacity(), 13U);
  EXPECT_EQ(mesh.triangles.capacity(), 4U);
  const float first_corners[] = {1, 3, 0, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mesh.positions[mesh.triangles[i][0]], Vec3f(first_corners[i], 0, 0));
  }
}

// Only those vertices are read that a primitive uses, whatever lies between them, but faults show in
// all.
TEST_F(GltfMemory, UnusedVerticesAreNotReadButChecked) {
  GltfBuilder builder;
  json one = primitive(builder, 4, 0, "TEXCOORD_0");
  const std::vector<std::uint16_t> indices = {9, 2, 4, 2, 4, 9};
  one["indices"] = builder.add_accessor(indices, "SCALAR");
  const int replaced = builder.add_view(std::vector<std::uint16_t>{3, 4, 11, 0});
  const int values = builder.add_view(std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9});
  builder.json["accessors"][0]["sparse"] = {
      {"count", 3},
      {"indices", {{"bufferView", replaced}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
  builder.add_mesh(one);
  const Asset asset = load(builder);
  const Mesh& mesh = asset.meshes.at(0);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 1, 0}, {4, 5, 6}, {3, 0, 0}}));
  EXPECT_EQ(mesh.uvs[0], std::vector<Vec2f>(3, Vec2f(0.25F)));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{2, 0, 1}, {0, 1, 2}}));

  const float infinite = std::numeric_limits<float>::infinity();
  std::memcpy(builder.bin.data() + 12 * 7 + 4, &infinite, sizeof infinite);
  test::expect_fault(test::fault_of_bytes(builder.glb()),
                     "/meshes/0/primitives/0/attributes/POSITION: vertex 7 is (2.5");
}

// Many blocks of vertices, of which the last has the fault.
TEST_F(GltfMemory, FaultsOfUnusedVerticesHaveTheirNumber) {
  GltfBuilder builder;
  std::vector<float> positions = row(20'000, 0);
  positions[3 * 50'001] = std::numeric_limits<float>::quiet_NaN();
  json one = {{"attributes", {{"POSITION", builder.add_accessor(positions, "VEC3")}}}};
  one["indices"] = builder.add_accessor(std::vector<std::uint16_t>{9, 10, 11}, "SCALAR");
  builder.add_mesh(one);
  test::expect_fault(test::fault_of_bytes(builder.glb()),
                     "/meshes/0/primitives/0/attributes/POSITION: vertex 50001 is (");
}

// The buffers go before the images are decoded: where images are the lesser part of them, and where
// they are not.
TEST_F(GltfMemory, ImagesOutliveTheirBuffers) {
  for (const std::size_t others : {0U, 20'000U}) {
    GltfBuilder builder = test::one_triangle();
    builder.add_view(std::vector<std::uint8_t>(others + 1, 7));
    for (const char value : {'\x21', '\x63'}) {
      const std::string file = test::png(1, 1, std::string(3, value) + '\xff');
      const int view = builder.add_view(file.data(), file.size());
      const int image = builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
      const int texture = builder.add("textures", {{"source", image}});
      builder.add("materials",
                  {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
    }
    const Asset asset = load(builder);
    ASSERT_EQ(asset.images.size(), 2U);
    EXPECT_EQ(asset.images[0].rgba, (std::vector<std::uint8_t>{0x21, 0x21, 0x21, 255}));
    EXPECT_EQ(asset.images[1].rgba, (std::vector<std::uint8_t>{0x63, 0x63, 0x63, 255}));
  }
}

}  // namespace
}  // namespace restframe
