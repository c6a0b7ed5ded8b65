// What bad glTF files get, part 1: the container, JSON, accessors and meshes.

#include <limits>

#include "support/gltf_faults.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::Damage;
using test::expect_damage;
using test::expect_fault;
using test::fault_of_bytes;
using test::GltfBuilder;
using test::set;

TEST(GltfContainer, HeaderAndChunksMustAddUp) {
  const std::string good = test::one_triangle().glb();
  EXPECT_EQ(fault_of_bytes(good), "");
  const auto with = [&](std::size_t at, std::uint32_t value) {
    std::string bytes = good;
    return fault_of_bytes(bytes.replace(at, 4, test::little_endian(value)));
  };
  const std::size_t bin =
      20 + (static_cast<unsigned char>(good[12]) + 256U * static_cast<unsigned char>(good[13]));
  expect_fault(fault_of_bytes(""), " the file is empty");
  expect_fault(fault_of_bytes("glTF"), " GLB ends within its header");
  expect_fault(fault_of_bytes(good.substr(0, 12)), " GLB header says");
  expect_fault(fault_of_bytes(good.substr(0, good.size() - 4)), " GLB header says");
  expect_fault(fault_of_bytes(good + "abcd"), " GLB header says");
  expect_fault(with(4, 1), " GLB version 1, only version 2");
  expect_fault(with(8, 0xFFFFFFFF), " GLB header says 4294967295 bytes");
  expect_fault(with(12, 0xFFFFFFFC), " GLB chunk claims 4294967292 bytes");
  expect_fault(with(12, 21), " GLB chunk of 21 bytes is not a multiple of 4");
  expect_fault(with(16, 0x004E4942), " first GLB chunk is not JSON");
  expect_fault(with(bin, 0x7FFFFFFC), " GLB chunk claims 2147483644 bytes");
  expect_fault(with(bin + 4, 0x4E4F534A), " GLB has a second JSON chunk");
}

TEST(GltfContainer, OnlyOneBinChunk) {
  const std::string bin = test::chunk(std::string("BIN\0", 4), "abcd");
  const std::string chunks = test::chunk("JSON", R"({"asset":{"version":"2.0"}} )") + bin + bin;
  const auto size = static_cast<std::uint32_t>(12 + chunks.size());
  expect_fault(fault_of_bytes("glTF" + test::little_endian(2) + test::little_endian(size) + chunks),
               " GLB has a BIN chunk at place 3");
}

TEST(GltfJson, MustBeJsonOfDecentSize) {
  expect_fault(fault_of_bytes("{\n  \"asset\": ,}"), "2:12: not JSON: syntax error");
  expect_fault(fault_of_bytes("{\"asset\": {\"version\": \"2.0\"}, \"x\": NaN}"), "1:36: not JSON");
  expect_fault(fault_of_bytes("{\"x\": 1e400}"), "1:", "number overflow parsing '1e400'");
  expect_fault(fault_of_bytes("{\"x\": \"\xff\xfe\"}"), "1:8: not JSON", "UTF-8");
  expect_fault(fault_of_bytes("{\"x\": 1, \"x\": 2}"), "/: key \"x\" is there twice");
  expect_fault(fault_of_bytes("[1, 2]"), "/: is array, must be an object");
  ImportLimits limits;
  limits.json_bytes = 20;
  expect_fault(fault_of_bytes("{\"asset\": {\"version\": \"2.0\"}}", limits),
               " JSON of 29 bytes, the limit is 20 bytes");
}

TEST(GltfJson, NestingIsLimitedEvenWhereNothingIsRead) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  expect_fault(fault_of_bytes("{\"extras\": " + deep + "}"),
               "/: nested deeper than the limit of 64");
  expect_fault(fault_of_bytes("{\"nodes\": " + deep + "}"), "/nodes/0/0", "the limit of 64");
}

TEST(GltfJson, NumbersOfElementsAreLimited) {
  std::string many = "{\"asset\":{\"version\":\"2.0\"},\"materials\":[{}";
  for (int i = 0; i < 60'000; ++i) many += ",{}";
  expect_fault(fault_of_bytes(many + "]}"), "/materials: has 60001 elements, the limit is 50000");
  ImportLimits limits;
  limits.nodes = 3;
  expect_damage(set("/nodes", {{{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}}}),
                "/nodes: has 4 nodes, the limit is 3", "", limits);
}

TEST(GltfDocument, VersionsAndExtensions) {
  expect_damage(set("/asset", json(nullptr)), "/asset: is null, must be an object");
  expect_damage([](GltfBuilder& b) { b.json.erase("asset"); }, "/: asset is missing");
  expect_damage(set("/asset/version", "3.0"), "/asset/version: glTF 3.0, only 2.0");
  expect_damage(set("/asset/version", "1.0"), "/asset/version: glTF 1.0, only 2.0");
  expect_damage(set("/asset/version", 2.0), "/asset/version: is number, must be a string");
  expect_damage(set("/asset/minVersion", "2.1"), "/asset/minVersion: needs glTF 2.1");
  expect_damage(set("/extensionsRequired", {"KHR_nonsense"}),
                "/extensionsRequired/0: extension \"KHR_nonsense\" is required but not supported");
  expect_damage(set("/nodes", json(nullptr)), "/nodes: is null, must be an array");
  expect_damage(set("/meshes/0", 7), "/meshes/0: is number, must be an object");
}

TEST(GltfAccessors, ViewsLieInBuffersAndAccessorsInViews) {
  expect_damage(set("/bufferViews/0/buffer", 1),
                "/bufferViews/0/buffer: is 1, must be an index below 1");
  expect_damage(set("/bufferViews/0/byteLength", 45),
                "/bufferViews/0: ends at byte 45 of a buffer of 42");
  expect_damage(set("/bufferViews/0/byteOffset", 1ULL << 63),
                "/bufferViews/0/byteOffset: is 9223372036854775808");
  expect_damage(set("/bufferViews/0/byteOffset", -4), "/bufferViews/0/byteOffset: is -4");
  expect_damage(set("/accessors/0/byteOffset", 4),
                "/accessors/0: ends at byte 40 of a bufferView of 36");
  expect_damage(set("/accessors/0/byteOffset", 2),
                "/accessors/0/byteOffset: is 2, must be a multiple of 4");
  expect_damage(set("/accessors/0/bufferView", 9), "/accessors/0/bufferView: is 9");
  for (const json& count : {json(0), json(-1), json(1ULL << 32), json(2.5), json("3")}) {
    expect_damage(set("/accessors/0/count", count), "/accessors/0/count: is ",
                  "must be a whole number");
  }
  expect_damage(set("/accessors/0/count", 0xFFFFFFFFU), "/accessors/0: ends at byte 51539607540");
  for (const int type : {0, 5119, 5124, 5127, 5130}) {
    expect_damage(set("/accessors/0/componentType", type), "/accessors/0/componentType: is ");
  }
  expect_damage(set("/accessors/0/type", "VEC5"), "/accessors/0/type: is \"VEC5\"");
  expect_damage(set("/bufferViews/0/byteStride", 5),
                "/bufferViews/0/byteStride: must be a multiple of 4");
  expect_damage(set("/bufferViews/0/byteStride", 256), "/bufferViews/0/byteStride: is 256");
  expect_damage(set("/bufferViews/0/byteStride", 8), "/accessors/0: byteStride 8",
                "less than its 12 bytes");
  expect_damage(set("/bufferViews/0/byteStride", 16), "/accessors/0: ends at byte 44");
}

TEST(GltfAccessors, SparseIndicesIncreaseAndStayInRange) {
  const auto sparse = [](const std::vector<std::uint8_t>& indices, const json& patch) {
    return [=](GltfBuilder& b) {
      const int view = b.add_view(indices), values = b.add_view(std::vector<float>(6, 0));
      b.json["accessors"][0]["sparse"] = {
          {"count", 2},
          {"indices", {{"bufferView", view}, {"componentType", 5121}}},
          {"values", {{"bufferView", values}}}};
      b.json["accessors"][0].merge_patch({{"sparse", patch}});
    };
  };
  const std::string at = "/accessors/0/sparse";
  expect_damage(sparse({1, 3}, json::object()),
                at + "/indices: index 3 at 1 is not below the count of 3");
  expect_damage(sparse({2, 1}, json::object()),
                at + "/indices: index 1 at 1 is not above the one before");
  expect_damage(sparse({1, 1}, json::object()),
                at + "/indices: index 1 at 1 is not above the one before");
  expect_damage(sparse({0, 1}, {{"count", 4}}), at + "/count: is 4");
  expect_damage(sparse({0, 1}, {{"count", 3}}),
                at + "/indices: ends at byte 3 of a bufferView of 2");
  expect_damage(sparse({0, 1}, {{"values", {{"byteOffset", 4}}}}), at + "/values: ends at byte 28");
  expect_damage(sparse({0, 1}, {{"indices", {{"componentType", 5126}}}}),
                at + "/indices/componentType: is 5126");
  expect_damage(sparse({0, 1}, {{"indices", {{"bufferView", 99}}}}),
                at + "/indices/bufferView: is 99");
}

TEST(GltfMesh, AttributesFitTogether) {
  const std::string primitive = "/meshes/0/primitives/0", attributes = primitive + "/attributes";
  expect_damage(set(attributes, json::object()), attributes + ": POSITION is missing");
  expect_damage(set(attributes + "/POSITION", 1), attributes + "/POSITION: has type \"SCALAR\"");
  expect_damage(set(attributes + "/POSITION", 2),
                attributes + "/POSITION: is 2, must be an index below 2");
  expect_damage(set(primitive + "/indices", 0), primitive + "/indices: must be scalars");
  expect_damage(set(primitive + "/indices", -1), primitive + "/indices: is -1");
  expect_damage(set(primitive + "/mode", 7), primitive + "/mode: is 7");
  expect_damage(set(primitive + "/material", 0),
                primitive + "/material: is 0, but there is nothing");
  expect_damage(
      [](GltfBuilder& b) {
        const int normals = b.add_accessor<float>({0, 0, 1}, "VEC3");
        b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
      },
      attributes + "/NORMAL: has 1 elements, POSITION 3");
  expect_damage(
      [](GltfBuilder& b) {
        const int uvs = b.add_accessor<std::uint8_t>({0, 0, 1, 1, 2, 2}, "VEC2");
        b.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = uvs;
      },
      attributes + "/TEXCOORD_0: has componentType 5121, not normalized");
}

TEST(GltfMesh, PositionsAreFiniteAndIndicesInRange) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 1.1e15F}) {
    GltfBuilder builder;
    const int positions = builder.add_accessor<float>({0, 0, 0, 1, bad, 0, 0, 1, 0}, "VEC3");
    builder.add_mesh({{"attributes", {{"POSITION", positions}}}});
    expect_fault(fault_of_bytes(builder.glb()),
                 "/meshes/0/primitives/0/attributes/POSITION: vertex 1 is",
                 "must be finite and below 1e15");
  }
  GltfBuilder builder = test::one_triangle();
  builder.bin[40] = 3;
  expect_fault(fault_of_bytes(builder.glb()),
               "/meshes/0/primitives/0/indices: index 3 is not below the 3 vertices");
}

TEST(GltfMesh, TheWholeIsLimited) {
  ImportLimits limits;
  limits.triangles = 1;
  const auto twice = [](GltfBuilder& b) {
    json& primitives = b.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
  };
  expect_damage(twice, "/meshes/0/primitives/1: more than 1 triangles in all", "", limits);
  // Zeros take no room in a file.
  expect_damage(
      set("/accessors/0", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 4'000'000'000U}}),
      "/meshes/0/primitives/0: geometry of more than 4000000000 bytes");
  limits = {};
  limits.total_bytes = 100;
  expect_damage(set("/asset/version", "2.0"), " file of ", "the limit is 100 bytes", limits);
}

}  // namespace
}  // namespace restframe
