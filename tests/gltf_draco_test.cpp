// KHR_draco_mesh_compression, against the same mesh uncompressed. Draco's own encoder makes the input.

#include <algorithm>
#include <array>

#include "support/compressed_gltf.h"
#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::bent_sheet;
using test::draco_bytes;
using test::draco_gltf;
using test::DracoSettings;
using test::expect_fault;
using test::fault_of_bytes;
using test::GltfBuilder;
using test::plain_gltf;
using test::PlainMesh;
using GltfDraco = test::GltfReading;

const std::string at = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

// A triangle as three corners of position and UV, the smallest first: Draco keeps neither the order
// of vertices nor which corner comes first, only the way around.
using Corner = std::array<float, 5>;
using Corners = std::array<Corner, 3>;

std::vector<Corners> sorted_triangles(const Mesh& mesh) {
  std::vector<Corners> all;
  for (const Triangle& triangle : mesh.triangles) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f& p = mesh.positions.at(triangle[i]);
      const Vec2f& uv = mesh.uvs.at(0).at(triangle[i]);
      corners[i] = {p.x, p.y, p.z, uv.x, uv.y};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST_F(GltfDraco, GivesTheUncompressedMesh) {
  const PlainMesh sheet = bent_sheet(7, 5);
  const std::vector<Corners> expected = sorted_triangles(load(plain_gltf(sheet)).meshes.at(0));
  for (const bool edgebreaker : {false, true}) {
    const Asset asset = load(draco_gltf(sheet, draco_bytes(sheet, {edgebreaker, 0})));
    EXPECT_TRUE(warnings_.empty());
    EXPECT_EQ(sorted_triangles(asset.meshes.at(0)), expected) << edgebreaker;
  }
}

TEST_F(GltfDraco, QuantizedPositionsAreWithinHalfAStep) {
  const PlainMesh sheet = bent_sheet(7, 5);
  const std::vector<Corners> expected = sorted_triangles(load(plain_gltf(sheet)).meshes.at(0));
  const std::vector<Corners> read =
      sorted_triangles(load(draco_gltf(sheet, draco_bytes(sheet, {true, 14}))).meshes.at(0));
  ASSERT_EQ(read.size(), expected.size());
  // The largest extent, 7, in 2^14 - 1 steps. Sorted by x first, which is whole: order may differ.
  double sum = 0, expected_sum = 0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum += read[i][c][2];
      expected_sum += expected[i][c][2];
      EXPECT_NEAR(read[i][c][0], std::round(read[i][c][0]), 0.5 * 7 / 16383 + 1e-6);
    }
  }
  EXPECT_NEAR(sum / 210, expected_sum / 210, 0.5 * 7 / 16383);
}

TEST_F(GltfDraco, AttributesMayStayOutside) {
  const PlainMesh sheet = bent_sheet(2, 2);
  // Sequential: the order of the vertices is kept, so colours beside it fit.
  GltfBuilder builder = draco_gltf(sheet, draco_bytes(sheet, {false, 0}));
  std::vector<float> colors(sheet.positions.size());
  for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = static_cast<float>(i) / 27;
  const int accessor = builder.add_accessor<float>(colors, "VEC3");
  builder.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = accessor;
  const Mesh mesh = load(builder).meshes.at(0);
  ASSERT_EQ(mesh.colors.size(), 9U);
  EXPECT_FLOAT_EQ(mesh.colors[8].z, 26.0F / 27);
  EXPECT_EQ(mesh.positions[8], Vec3f(2, 2, sheet.positions[26]));
}

TEST_F(GltfDraco, MayBeOptional) {
  const PlainMesh sheet = bent_sheet(2, 2);
  GltfBuilder builder = draco_gltf(sheet, draco_bytes(sheet, {}));
  builder.json.erase("extensionsRequired");
  EXPECT_EQ(load(builder).meshes.at(0).triangles.size(), 8U);
  EXPECT_TRUE(warnings_.empty());
}

std::string fault_after(const std::function<void(GltfBuilder&)>& damage, bool edgebreaker = true) {
  const PlainMesh sheet = bent_sheet(3, 3);
  GltfBuilder builder = draco_gltf(sheet, draco_bytes(sheet, {edgebreaker, 0}));
  damage(builder);
  return fault_of_bytes(builder.glb());
}

TEST_F(GltfDraco, CountsMustBeThoseOfTheAccessors) {
  for (const bool edgebreaker : {false, true}) {
    for (const std::size_t accessor : {0U, 1U, 2U}) {
      const auto count = [&](std::size_t value) {
        return fault_after(
            [&](GltfBuilder& b) {
              b.json["accessors"][accessor]["count"] = value;
              if (accessor == 0) b.json["accessors"][1]["count"] = value;
            },
            edgebreaker);
      };
      if (accessor == 0) expect_fault(count(17), at + ": has 16 vertices, its accessors 17");
      if (accessor == 2) expect_fault(count(51), at + ": has 18 triangles, its accessors 17");
      if (accessor == 2) {
        expect_fault(count(55), at + ": is of triangles, but the count of the indices is 55");
      }
    }
  }
  // The limits are checked before anything is decompressed.
  expect_fault(fault_after([](GltfBuilder& b) { b.json["accessors"][2]["count"] = 4'000'000'000; }),
               "/meshes/0/primitives/0: more than 50000000 triangles in all");
}

TEST_F(GltfDraco, TheExtensionIsChecked) {
  const auto with = [](const char* key, const json& value) {
    return fault_after([&](GltfBuilder& b) {
      b.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"].merge_patch(
          {{key, value}});
    });
  };
  expect_fault(with("bufferView", 1), at + "/bufferView: is 1, must be an index below 1");
  expect_fault(with("bufferView", nullptr), at + ": bufferView is missing");
  expect_fault(with("attributes", nullptr), at + ": attributes is missing");
  expect_fault(with("attributes", {{"POSITION", nullptr}}),
               at + "/attributes: POSITION is missing");
  expect_fault(with("attributes", {{"NORMAL", 2}}),
               at + "/attributes/NORMAL: the primitive has no attribute of this name");
  expect_fault(with("attributes", {{"POSITION", -1}}), at + "/attributes/POSITION: is -1");
  expect_fault(with("attributes", {{"POSITION", 7}}), at + ": has no attribute 7");
  expect_fault(with("attributes", {{"POSITION", 1}}),
               at + ": has attribute 1 of 2 components, its accessor 3");
  const auto primitive = [](const json& patch) {
    return fault_after(
        [&](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0].merge_patch(patch); });
  };
  expect_fault(primitive({{"mode", 6}}), "/meshes/0/primitives/0/mode: is 6, but Draco has");
  expect_fault(primitive({{"indices", nullptr}}), "/meshes/0/primitives/0: indices is missing");
}

TEST_F(GltfDraco, WhatIsNotDracoIsNamed) {
  const auto with = [](std::size_t byte, char value) {
    return fault_after([&](GltfBuilder& b) { b.bin[byte] = value; });
  };
  expect_fault(with(0, 'X'), at + ": is not of Draco");
  expect_fault(with(7, 0), at + ": is not a mesh");
  expect_fault(with(6, 1), at + ": is of a bitstream version that is not 2.2");
  expect_fault(fault_after([](GltfBuilder& b) { b.json["bufferViews"][0]["byteLength"] = 40; }),
               at + ": can not be decompressed");
  expect_fault(fault_after([](GltfBuilder& b) { b.json["bufferViews"][0]["byteLength"] = 9; }),
               at + ": is not of Draco");
}

// Every byte changed, and every length: read, or refused in one line.
TEST_F(GltfDraco, DamagedStreamsAreReadOrRefused) {
  const PlainMesh sheet = bent_sheet(3, 3);
  for (const bool edgebreaker : {false, true}) {
    const std::vector<std::uint8_t> good = draco_bytes(sheet, {edgebreaker, 10});
    for (std::size_t i = 0; i < good.size(); ++i) {
      std::vector<std::uint8_t> bad = good;
      bad[i] ^= static_cast<std::uint8_t>(1U << (i % 8));
      fault_of_bytes(draco_gltf(sheet, bad).glb());
      bad.resize(i + 1);
      fault_of_bytes(draco_gltf(sheet, bad).glb());
    }
  }
}

}  // namespace
}  // namespace restframe
