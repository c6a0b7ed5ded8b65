// EXT_meshopt_compression, against the same mesh uncompressed. meshoptimizer's own encoders make the
// input.

#include <meshoptimizer.h>

#include "support/compressed_gltf.h"
#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::add_meshopt_view;
using test::bent_sheet;
using test::expect_fault;
using test::fault_of_bytes;
using test::GltfBuilder;
using test::meshopt_gltf;
using test::meshopt_vertices;
using test::plain_gltf;
using test::PlainMesh;
using GltfMeshopt = test::GltfReading;

const std::string at = "/bufferViews/0/extensions/EXT_meshopt_compression";

TEST_F(GltfMeshopt, GivesTheUncompressedMesh) {
  const PlainMesh sheet = bent_sheet(20, 15);
  const Mesh expected = load(plain_gltf(sheet)).meshes.at(0);
  const Mesh mesh = load(meshopt_gltf(sheet)).meshes.at(0);
  EXPECT_TRUE(warnings_.empty());
  EXPECT_EQ(mesh.positions, expected.positions);
  EXPECT_EQ(mesh.uvs[0], expected.uvs[0]);
  ASSERT_EQ(mesh.triangles.size(), expected.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {  // rotated, but the same way around
    Triangle triangle = mesh.triangles[i];
    std::rotate(triangle.begin(),
                std::find(triangle.begin(), triangle.end(), expected.triangles[i][0]),
                triangle.end());
    EXPECT_EQ(triangle, expected.triangles[i]);
  }
}

TEST_F(GltfMeshopt, ReadsSequencesOfShortIndices) {
  GltfBuilder builder;
  const std::vector<unsigned> strip = {0, 1, 2, 3};
  std::vector<std::uint8_t> bytes(meshopt_encodeIndexSequenceBound(4, 4));
  bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), strip.data(), 4));
  const int view = add_meshopt_view(builder, bytes, 4, 2, "INDICES");
  const std::vector<float> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const int positions = builder.add_accessor_of_view(
      add_meshopt_view(builder, meshopt_vertices(corners.data(), 4, 12), 4, 12, "ATTRIBUTES"), 5126,
      "VEC3", 12, false);
  builder.add_mesh({{"attributes", {{"POSITION", positions}}},
                    {"indices", builder.add_accessor_of_view(view, 5123, "SCALAR", 4, false)},
                    {"mode", 5}});
  EXPECT_EQ(load(builder).meshes.at(0).triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
}

TEST_F(GltfMeshopt, UndoesFilters) {
  const float half = std::sqrt(0.5F);
  // Four numbers a vertex, whatever is in the last.
  const std::vector<float> normals = {0, 0, 1, 0, 0.6F, 0, 0.8F, 0, 0, -1, 0, 0};
  const std::vector<float> positions = {0.25F, -3, 1e-3F, 1, 0, 0, 0, 1000, 7};
  const std::vector<float> rotations = {0, 0, 0, 1, 0, half, 0, half};
  std::vector<std::int16_t> oct(12), quat(8);
  std::vector<std::uint32_t> exponential(9);
  meshopt_encodeFilterOct(oct.data(), 3, 8, 16, normals.data());
  meshopt_encodeFilterExp(exponential.data(), 9, 4, 15, positions.data());
  meshopt_encodeFilterQuat(quat.data(), 2, 8, 16, rotations.data());
  GltfBuilder builder;
  const int position_view = add_meshopt_view(builder, meshopt_vertices(exponential.data(), 3, 12),
                                             3, 12, "ATTRIBUTES", "EXPONENTIAL");
  const int normal_view = add_meshopt_view(builder, meshopt_vertices(oct.data(), 3, 8), 3, 8,
                                           "ATTRIBUTES", "OCTAHEDRAL");
  const int rotation_view = add_meshopt_view(builder, meshopt_vertices(quat.data(), 2, 8), 2, 8,
                                             "ATTRIBUTES", "QUATERNION");
  builder.json["extensionsUsed"].push_back("KHR_mesh_quantization");
  builder.add_mesh(
      {{"attributes",
        {{"POSITION", builder.add_accessor_of_view(position_view, 5126, "VEC3", 9, false)},
         {"NORMAL", builder.add_accessor_of_view(normal_view, 5122, "VEC3", 9, true)}}}});
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"ROTATION", builder.add_accessor_of_view(rotation_view, 5122, "VEC4", 8, true)}};
  const Asset asset = load(builder);
  const Mesh& mesh = asset.meshes.at(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3f normal(normals[4 * i], normals[4 * i + 1], normals[4 * i + 2]);
    EXPECT_LT(glm::distance(mesh.normals[i], normal), 1e-3F);
    for (int c = 0; c < 3; ++c) {
      const float expected = positions[3 * i + static_cast<std::size_t>(c)];
      EXPECT_NEAR(mesh.positions[i][c], expected, std::abs(expected) / 8000);
    }
  }
  ASSERT_EQ(asset.parts.size(), 2U);
  // A quarter turn about y brings x to -z.
  const Vec3 turned(asset.parts[1].asset_from_mesh * glm::dvec4(1, 0, 0, 0));
  EXPECT_LT(glm::distance(turned, Vec3(0, 0, -1)), 1e-3);
}

TEST_F(GltfMeshopt, AFallbackIsNotEvenLookedFor) {
  GltfBuilder builder = meshopt_gltf(bent_sheet(4, 4));
  builder.json["buffers"][1]["uri"] = "is-not-there.bin";
  EXPECT_EQ(load(builder).meshes.at(0).triangles.size(), 32U);
}

std::string fault_after(const std::function<void(GltfBuilder&)>& damage) {
  GltfBuilder builder = meshopt_gltf(bent_sheet(4, 4));
  damage(builder);
  return fault_of_bytes(builder.glb());
}

TEST_F(GltfMeshopt, TheExtensionIsChecked) {
  const auto with = [](const char* key, const json& value, std::size_t view = 0) {
    return fault_after([&](GltfBuilder& b) {
      b.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"].merge_patch(
          {{key, value}});
    });
  };
  const std::string indices = "/bufferViews/2/extensions/EXT_meshopt_compression";
  expect_fault(with("buffer", 2), at + "/buffer: is 2, must be an index below 2");
  expect_fault(with("buffer", 1), at + "/buffer: is a fallback, which has no data");
  expect_fault(with("byteOffset", 1 << 20), at + ": ends at byte ");
  expect_fault(with("byteLength", 0), at + "/byteLength: is 0");
  expect_fault(with("byteLength", 2), at + ": has 2 bytes, too few for its count");
  expect_fault(with("byteStride", 13), at + "/byteStride: is 13, which ATTRIBUTES");
  expect_fault(with("byteStride", 260), at + "/byteStride: is 260");
  expect_fault(with("byteStride", 8, 2), indices + "/byteStride: is 8, which TRIANGLES");
  expect_fault(with("byteStride", 16), at + "/byteStride: is 16, the view's is 12");
  expect_fault(with("count", 26), at + ": gives 26 elements of 12 bytes, the view has 300 bytes");
  expect_fault(with("count", 95, 2), indices + "/count: is 95, must be a multiple of 3");
  expect_fault(with("mode", "POINTS"), at + "/mode: is \"POINTS\", must be ATTRIBUTES");
  expect_fault(with("mode", nullptr), at + ": mode is missing");
  expect_fault(with("filter", "BLUR"), at + "/filter: is \"BLUR\", must be NONE");
  expect_fault(with("filter", "OCTAHEDRAL"), at + "/byteStride: is 12, which ATTRIBUTES");
  expect_fault(with("filter", "EXPONENTIAL", 2), indices + "/filter: is EXPONENTIAL, but only");
  expect_fault(fault_after([](GltfBuilder& b) { b.json["bufferViews"][0].erase("extensions"); }),
               "/bufferViews/0/buffer: is a fallback without data");
}

TEST_F(GltfMeshopt, WhatDecompressesIsLimited) {
  ImportLimits limits;
  limits.total_bytes = 1'500'000;
  GltfBuilder builder = meshopt_gltf(bent_sheet(4, 4));
  json huge = builder.json["bufferViews"][0];
  huge["byteLength"] = 960'000;
  huge["extensions"]["EXT_meshopt_compression"]["count"] = 80'000;
  huge["extensions"]["EXT_meshopt_compression"]["byteLength"] = 20'000;
  huge["extensions"]["EXT_meshopt_compression"]["byteOffset"] = 0;
  builder.bin.resize(20'000);
  builder.json["buffers"][0]["byteLength"] = 20'000;
  builder.json["bufferViews"].push_back(huge);
  builder.json["bufferViews"].push_back(huge);
  expect_fault(fault_of_bytes(builder.glb(), limits), "/bufferViews/4/extensions",
               "more than 1500000 bytes decompressed in all");
}

// Every byte changed, and every length: read, or refused in one line.
TEST_F(GltfMeshopt, DamagedStreamsAreReadOrRefused) {
  const GltfBuilder good = meshopt_gltf(bent_sheet(4, 4));
  for (std::size_t i = 0; i < good.bin.size(); ++i) {
    GltfBuilder bad = good;
    bad.bin[i] = static_cast<char>(bad.bin[i] ^ (1 << (i % 8)));
    fault_of_bytes(bad.glb());
  }
  GltfBuilder bad = good;
  bad.bin[0] = 'X';
  expect_fault(fault_of_bytes(bad.glb()), at + ": can not be decompressed: it is damaged");
}

}  // namespace
}  // namespace restframe
