// Reading good glTF files. What is expected is what the test itself put into the file.

#include <cstdint>
#include <limits>

#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using Gltf = test::GltfReading;

const std::vector<float> triangle_positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST_F(Gltf, ReadsATriangle) {
  const Asset asset = load(test::one_triangle());
  EXPECT_TRUE(warnings_.empty());
  EXPECT_EQ(asset.name, "asset.glb");
  ASSERT_EQ(asset.meshes.size(), 1U);
  const Mesh& mesh = asset.meshes[0];
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_GT(mesh.positions.capacity(), mesh.positions.size());
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_TRUE(mesh.normals.empty());  // flat: the triangle's own
  ASSERT_EQ(asset.parts.size(), 1U);
  EXPECT_EQ(asset.parts[0].asset_from_mesh, Mat4(1));
  ASSERT_EQ(asset.materials.size(), 1U);
  EXPECT_EQ(asset.materials[0].name, "default");
  EXPECT_EQ(mesh.materials[0].slot, 0);
}

TEST_F(Gltf, ReadsBuffersFromFilesBesideIt) {
  const GltfBuilder builder = test::one_triangle();
  folder_.write("sub/a mesh.bin", builder.bin);
  EXPECT_EQ(load(builder.gltf("sub/a%20mesh.bin"), "a.gltf").meshes.size(), 1U);
  EXPECT_EQ(load(builder.gltf("./sub/../sub/a mesh.bin"), "a.gltf").meshes.size(), 1U);
}

TEST_F(Gltf, ReadsDataUris) {
  const GltfBuilder builder = test::one_triangle();
  const std::string uri = "data:application/octet-stream;base64," + test::base64(builder.bin);
  EXPECT_EQ(load(builder.gltf(uri), "a.gltf").meshes.at(0).triangles.size(), 1U);
}

TEST_F(Gltf, ReadsIndicesOfEveryType) {
  for (int type = 0; type < 3; ++type) {
    GltfBuilder builder;
    const int positions = builder.add_accessor<float>(triangle_positions, "VEC3");
    const int indices = type == 0   ? builder.add_accessor<std::uint8_t>({2, 0, 1}, "SCALAR")
                        : type == 1 ? builder.add_accessor<std::uint16_t>({2, 0, 1}, "SCALAR")
                                    : builder.add_accessor<std::uint32_t>({2, 0, 1}, "SCALAR");
    builder.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
    EXPECT_EQ(load(builder).meshes.at(0).triangles, (std::vector<Triangle>{{2, 0, 1}}));
  }
}

TEST_F(Gltf, ReadsStripsAndFansWithTheirOrientation) {
  // A unit square's corners in strip order: both triangles face +z.
  const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  for (const int mode : {5, 6}) {
    GltfBuilder builder;
    const int positions = builder.add_accessor<float>(square, "VEC3");
    json primitive = {{"attributes", {{"POSITION", positions}}}, {"mode", mode}};
    if (mode == 6)
      primitive["indices"] = builder.add_accessor<std::uint8_t>({0, 1, 3, 2}, "SCALAR");
    builder.add_mesh(primitive);
    const Mesh mesh = load(builder).meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 2U);
    float area = 0;
    for (const Triangle& t : mesh.triangles) {
      const Vec3f& a = mesh.positions[t[0]];
      area += glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a).z / 2;
    }
    EXPECT_FLOAT_EQ(area, 1) << "mode " << mode;
  }
}

TEST_F(Gltf, SkipsPointsAndLines) {
  GltfBuilder builder = test::one_triangle();
  json line = builder.json["meshes"][0]["primitives"][0];
  line["mode"] = 1;
  builder.json["meshes"][0]["primitives"].push_back(line);
  EXPECT_EQ(load(builder).meshes.at(0).triangles.size(), 1U);
  EXPECT_TRUE(warned("asset.glb:/meshes/0: 1 primitives of points or lines are not renderable"));
}

TEST_F(Gltf, ReadsAttributes) {
  GltfBuilder builder;
  const json attributes = {
      {"POSITION", builder.add_accessor<float>(triangle_positions, "VEC3")},
      {"NORMAL", builder.add_accessor<float>({0, 0, 2, 0, 3, 4, 1, 0, 0}, "VEC3")},
      {"TEXCOORD_0", builder.add_accessor<float>({0, 0, 2, -1, 0.5F, 0.25F}, "VEC2")},
      {"TEXCOORD_1", builder.add_accessor<std::uint16_t>({0, 65535, 0, 0, 13107, 0}, "VEC2", true)},
      {"COLOR_0", builder.add_accessor<float>({1, 0, 0, 0, 0.5F, 0, 0, 0, 0.25F}, "VEC3")}};
  builder.add_mesh({{"attributes", attributes}});
  const Mesh mesh = load(builder).meshes.at(0);
  EXPECT_EQ(mesh.normals, (std::vector<Vec3f>{{0, 0, 1}, {0, 0.6F, 0.8F}, {1, 0, 0}}));
  EXPECT_EQ(mesh.uvs[0], (std::vector<Vec2f>{{0, 0}, {2, -1}, {0.5F, 0.25F}}));
  EXPECT_EQ(mesh.uvs[1], (std::vector<Vec2f>{{0, 1}, {0, 0}, {0.2F, 0}}));
  EXPECT_EQ(mesh.colors, (std::vector<Vec4f>{{1, 0, 0, 1}, {0, 0.5F, 0, 1}, {0, 0, 0.25F, 1}}));
}

TEST_F(Gltf, ReadsNormalizedColorsWithAlpha) {
  GltfBuilder builder;
  const json attributes = {
      {"POSITION", builder.add_accessor<float>(triangle_positions, "VEC3")},
      {"COLOR_0", builder.add_accessor<std::uint8_t>({255, 0, 51, 102, 0, 0, 0, 0, 0, 0, 0, 255},
                                                     "VEC4", true)}};
  builder.add_mesh({{"attributes", attributes}});
  EXPECT_EQ(load(builder).meshes.at(0).colors,
            (std::vector<Vec4f>{{1, 0, 0.2F, 0.4F}, {0, 0, 0, 0}, {0, 0, 0, 1}}));
}

TEST_F(Gltf, ReadsQuantizedMeshes) {
  GltfBuilder builder;
  builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::vector<std::int16_t> positions = {0, 0, 0, 100, 0, 0, 0, -100, 7};
  const std::vector<std::int8_t> normals = {0, 0, 127, 0, -128, 0, 127, 0, 0};
  builder.add_mesh({{"attributes",
                     {{"POSITION", builder.add_accessor(positions, "VEC3")},
                      {"NORMAL", builder.add_accessor(normals, "VEC3", true)}}}});
  const Mesh mesh = load(builder).meshes.at(0);
  EXPECT_EQ(mesh.positions[2], Vec3f(0, -100, 7));
  EXPECT_EQ(mesh.normals, (std::vector<Vec3f>{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}}));
}

TEST_F(Gltf, ReadsInterleavedAttributes) {
  GltfBuilder builder;
  const std::vector<float> rows = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0};
  const int view = builder.add_view(rows, 24);
  const int positions = builder.add_accessor_of_view(view, 5126, "VEC3", 9, false);
  const int normals = builder.add_accessor_of_view(view, 5126, "VEC3", 9, false);
  builder.json["accessors"][static_cast<std::size_t>(normals)]["byteOffset"] = 12;
  builder.add_mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
  const Mesh mesh = load(builder).meshes.at(0);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.normals, (std::vector<Vec3f>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

TEST_F(Gltf, ReadsSparseAccessorsOverZerosAndOverViews) {
  for (const bool over_view : {false, true}) {
    GltfBuilder builder;
    const int indices = builder.add_view<std::uint8_t>({1, 2});
    const int values = builder.add_view<float>({5, 0, 0, 0, 6, 0});
    json accessor = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 3}};
    if (over_view) accessor["bufferView"] = builder.add_view<float>({0, 0, 1, 1, 1, 1, 2, 2, 2});
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                          {"values", {{"bufferView", values}}}};
    const int positions = builder.add("accessors", accessor);
    builder.add_mesh({{"attributes", {{"POSITION", positions}}}});
    const float z = over_view ? 1 : 0;
    EXPECT_EQ(load(builder).meshes.at(0).positions,
              (std::vector<Vec3f>{{0, 0, z}, {5, 0, 0}, {0, 6, 0}}));
  }
}

TEST_F(Gltf, ReadsIndicesWithoutAViewAsZeros) {
  GltfBuilder builder = test::one_triangle();
  builder.json["accessors"][1].erase("bufferView");
  builder.json["accessors"][0].erase("bufferView");
  builder.json.erase("bufferViews");
  builder.bin.clear();
  const Mesh mesh = load(builder).meshes.at(0);
  ASSERT_EQ(mesh.triangles.size(), 1U);
  for (const std::uint32_t vertex : mesh.triangles[0]) EXPECT_EQ(mesh.positions[vertex], Vec3f(0));
}

TEST_F(Gltf, IndicesWithoutAViewAllNameTheFirstVertex) {
  GltfBuilder builder;
  const int positions = builder.add_accessor<float>({4, 5, 6, 1, 0, 0, 0, 1, 0}, "VEC3");
  const int indices =
      builder.add("accessors", {{"componentType", 5125}, {"type", "SCALAR"}, {"count", 3}});
  builder.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const Mesh mesh = load(builder).meshes.at(0);
  for (const std::uint32_t vertex : mesh.triangles.at(0)) {
    EXPECT_EQ(mesh.positions[vertex], Vec3f(4, 5, 6));
  }
}

TEST_F(Gltf, JoinsPrimitivesAndDropsVerticesTheyDoNotUse) {
  GltfBuilder builder;
  const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const int positions = builder.add_accessor<float>(square, "VEC3");
  const int first = builder.add_accessor<std::uint8_t>({0, 1, 2}, "SCALAR");
  const int second = builder.add_accessor<std::uint8_t>({2, 1, 3}, "SCALAR");
  builder.add("materials", {{"name", "red"}});
  const json attributes = {{"POSITION", positions}};
  builder.add_mesh({{"attributes", attributes}, {"indices", first}, {"material", 0}});
  builder.json["meshes"][0]["primitives"].push_back(
      {{"attributes", attributes}, {"indices", second}});
  const Asset asset = load(builder);
  ASSERT_EQ(asset.meshes.size(), 1U);
  const Mesh& mesh = asset.meshes[0];
  EXPECT_EQ(mesh.positions.size(), 6U);
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.positions[mesh.triangles[1][2]], Vec3f(1, 1, 0));
  EXPECT_EQ(material_slot(mesh, 0), 0);
  EXPECT_EQ(material_slot(mesh, 1), 1);
  EXPECT_EQ(asset.materials.at(1).name, "default");
}

TEST_F(Gltf, RecomputesNormalsWithoutDirection) {
  GltfBuilder builder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const json attributes = {
      {"POSITION", builder.add_accessor<float>(triangle_positions, "VEC3")},
      {"NORMAL", builder.add_accessor<float>({0, 0, 0, nan, 0, 0, 1, 0, 0}, "VEC3")}};
  builder.add_mesh({{"attributes", attributes}});
  const Mesh mesh = load(builder).meshes.at(0);
  EXPECT_EQ(mesh.normals, (std::vector<Vec3f>{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}}));
  EXPECT_TRUE(warned("/meshes/0/primitives/0/attributes/NORMAL: 2 normals"));
}

TEST_F(Gltf, CountsDegenerateTriangles) {
  GltfBuilder builder;
  const int positions = builder.add_accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0}, "VEC3");
  const int indices = builder.add_accessor<std::uint8_t>({0, 1, 2, 0, 1, 3, 1, 1, 2}, "SCALAR");
  builder.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  load(builder);
  EXPECT_TRUE(warned("/meshes: 2 triangles are degenerate"));
}

TEST_F(Gltf, WarnsOfWhatItLeavesOut) {
  GltfBuilder builder = test::one_triangle();
  builder.json["extensionsUsed"] = {"KHR_xmp_json_ld"};
  builder.json["animations"] = {{{"name", "walk"}}};
  builder.json["extras"] = {{"anything", {1, 2, 3}}};
  load(builder);
  EXPECT_TRUE(warned("/extensionsUsed/0: extension \"KHR_xmp_json_ld\" is left out"));
  EXPECT_TRUE(warned("/animations: left out: the asset is read in its rest pose"));
  EXPECT_EQ(warnings_.size(), 2U);
}

TEST_F(Gltf, AcceptsAnEmptyBinChunk) {
  const std::string document = R"({"asset": {"version": "2.0"} }  )";
  const std::string chunks =
      test::chunk("JSON", document) + test::chunk(std::string("BIN\0", 4), "");
  const auto size = static_cast<std::uint32_t>(12 + chunks.size());
  EXPECT_TRUE(
      load("glTF" + test::little_endian(2) + test::little_endian(size) + chunks).parts.empty());
}

}  // namespace
}  // namespace restframe
