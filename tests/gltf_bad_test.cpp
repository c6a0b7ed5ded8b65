// What bad glTF files get: one line that names the place. Each case damages a good file in one way.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <functional>
#include <limits>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

// What load_gltf says about the file, without the folder's name; empty if it is read.
std::string fault_of(const std::filesystem::path& path, const ImportLimits& limits = {}) {
  Warnings warnings;
  try {
    load_gltf(path, limits, warnings);
  } catch (const InputError& error) {
    const std::string message = error.what(), folder = path.parent_path().string() + "/";
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.rfind(folder, 0), 0U) << message;
    return message.substr(std::min(folder.size(), message.size()));
  }
  return "";
}

std::string fault_of_bytes(const std::string& bytes, const ImportLimits& limits = {}) {
  const TemporaryFolder folder;
  return fault_of(folder.write("a.glb", bytes), limits);
}

void expect_fault(const std::string& fault, const std::string& begin,
                  const std::string& part = "") {
  EXPECT_EQ(fault.rfind("a.glb:" + begin, 0), 0U) << fault;
  EXPECT_NE(fault.find(part), std::string::npos) << fault << "\nlacks: " << part;
}

using Damage = std::function<void(GltfBuilder&)>;

// The triangle of `one_triangle` has accessors and views 0 (POSITION) and 1 (indices), mesh 0, node
// 0.
void expect_damage(const Damage& damage, const std::string& begin, const std::string& part = "",
                   const ImportLimits& limits = {}) {
  GltfBuilder builder = test::one_triangle();
  damage(builder);
  expect_fault(fault_of_bytes(builder.glb(), limits), begin, part);
}

// Sets the value at a JSON pointer.
Damage set(const std::string& pointer, const json& value) {
  return [=](GltfBuilder& b) { b.json[json::json_pointer(pointer)] = value; };
}

const json inherited = nullptr;

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
  expect_damage(set("/asset", inherited), "/asset: is null, must be an object");
  expect_damage([](GltfBuilder& b) { b.json.erase("asset"); }, "/: asset is missing");
  expect_damage(set("/asset/version", "3.0"), "/asset/version: glTF 3.0, only 2.0");
  expect_damage(set("/asset/version", "1.0"), "/asset/version: glTF 1.0, only 2.0");
  expect_damage(set("/asset/version", 2.0), "/asset/version: is number, must be a string");
  expect_damage(set("/asset/minVersion", "2.1"), "/asset/minVersion: needs glTF 2.1");
  expect_damage(set("/extensionsRequired", {"KHR_nonsense"}),
                "/extensionsRequired/0: extension \"KHR_nonsense\" is required but not supported");
  expect_damage(set("/nodes", inherited), "/nodes: is null, must be an array");
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

TEST(GltfGraph, IsAForest) {
  expect_damage(set("/nodes/0/children", {0}), "/nodes/0: is its own descendant: a cycle");
  expect_damage(set("/nodes", {{{"children", {1}}}, {{"children", {2}}}, {{"children", {0}}}}),
                "/nodes/", "a cycle");
  expect_damage(set("/nodes", {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}}),
                "/nodes/1/children/0: node 2 has another parent, node 0");
  expect_damage(set("/nodes", {{{"children", {1, 1}}}, {{"mesh", 0}}}),
                "/nodes/0/children/1: node 1 has another parent, node 0");
  expect_damage(set("/nodes/0/children", {5}), "/nodes/0/children/0: is 5");
  expect_damage(set("/nodes/0/mesh", 1), "/nodes/0/mesh: is 1");
  expect_damage(set("/scenes", {{{"nodes", {0, 0}}}}), "/scenes/0/nodes/1: node 0 is listed twice");
  expect_damage(set("/scenes", {{{"nodes", {1}}}}), "/scenes/0/nodes/0: is 1");
  expect_damage(set("/scene", 3), "/scene: is 3, but there is nothing");
}

TEST(GltfGraph, DeepAndDoublingGraphsEndQuickly) {
  json chain, doubling;
  for (int i = 0; i < 100'000; ++i) chain.push_back({{"children", {i + 1}}});
  chain.push_back(json::object());
  expect_damage(set("/nodes", chain), "/nodes/", "levels deep");
  for (int i = 0; i < 40; ++i) doubling.push_back({{"children", {i + 1, i + 1}}});
  doubling.push_back({{"mesh", 0}});
  expect_damage(set("/nodes", doubling), "/nodes/0/children/1: node 1 has another parent");
}

TEST(GltfGraph, TransformsAreWholeAndFinite) {
  expect_damage(set("/nodes/0/matrix", {1, 0, 0}), "/nodes/0/matrix: has 3 numbers, must have 16");
  expect_damage(set("/nodes/0/translation", {1, nullptr, 0}), "/nodes/0/translation/1: is null");
  expect_damage(set("/nodes/0/rotation", {0, 0, 0, 0}),
                "/nodes/0/rotation: is a quaternion of length 0");
  expect_damage(set("/nodes/0/scale", {1e200, 1, 1}), "/nodes/0: its transform is not finite");
  expect_damage(set("/nodes/0/matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1}),
                "/nodes/0/matrix/11: is 0.5", "last row");
  expect_damage(
      [](GltfBuilder& b) {
        set("/nodes/0/matrix", std::vector<int>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})(b);
        set("/nodes/0/scale", {1, 1, 1})(b);
      },
      "/nodes/0: has both a matrix and a scale");
}

TEST(GltfGraph, InstancesAreLimited) {
  ImportLimits limits;
  limits.nodes = 100;
  const std::string at = "/nodes/0/extensions/EXT_mesh_gpu_instancing";
  const auto instanced = [](std::uint32_t count) {
    return [=](GltfBuilder& b) {
      const json accessor = {{"componentType", 5126}, {"type", "VEC3"}, {"count", count}};
      b.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
          {"TRANSLATION", b.add("accessors", accessor)}};
    };
  };
  expect_damage(instanced(101), "/nodes/0: more than 100 instances and nodes in all", "", limits);
  expect_damage(set(at, {{"attributes", json::object()}}), at + "/attributes: is empty");
  expect_damage(set(at, {{"attributes", {{"SCALE", 1}}}}), at + "/attributes/SCALE: must be VEC3");
}

// A file whose one buffer is at this URI.
std::string fault_of_uri(const TemporaryFolder& folder, const std::string& uri) {
  return fault_of(folder.write("in/a.glb", test::one_triangle().gltf(uri)));
}

TEST(GltfUris, StayWithinTheFolder) {
  const TemporaryFolder folder;
  const std::string bin = test::one_triangle().bin;
  folder.write("outside.bin", bin);
  folder.write("in/inside.bin", bin);
  EXPECT_EQ(fault_of_uri(folder, "inside.bin"), "");
  for (const std::string uri : {"../outside.bin", "..%2foutside.bin", "%2e%2e/outside.bin",
                                "x/../../outside.bin", "./%2E./outside.bin"}) {
    expect_fault(fault_of_uri(folder, uri), "/buffers/0/uri: URI \"" + uri,
                 "leaves the asset's folder");
  }
  const std::string absolute = (folder.path() / "in/inside.bin").string();
  expect_fault(fault_of_uri(folder, absolute), "/buffers/0/uri: ", "leaves the asset's folder");
  for (const std::string uri : {"http://example.com/a.bin", "file:inside.bin", "C:/a.bin"}) {
    expect_fault(fault_of_uri(folder, uri),
                 "/buffers/0/uri: ", "neither a relative path nor data:");
  }
  expect_fault(fault_of_uri(folder, "C:\\a.bin"), "/buffers/0/uri: backslash");
  expect_fault(fault_of_uri(folder, "inside.bin%00.png"), "/buffers/0/uri: NUL in URI");
  expect_fault(fault_of_uri(folder, "inside%zz.bin"), "/buffers/0/uri: malformed %");
  expect_fault(fault_of_uri(folder, ""), "/buffers/0/uri: URI is empty");
  expect_fault(fault_of_uri(folder, "missing.bin"),
               "/buffers/0/uri: can not find file \"missing.bin\"");

  std::filesystem::create_symlink("../outside.bin", folder.path() / "in/link.bin");
  expect_fault(fault_of_uri(folder, "link.bin"), "/buffers/0/uri: ", "leaves the asset's folder");
  std::filesystem::create_symlink("inside.bin", folder.path() / "in/good_link.bin");
  EXPECT_EQ(fault_of_uri(folder, "good_link.bin"), "");
}

TEST(GltfUris, NameRegularFiles) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "in/folder");
  ASSERT_EQ(::mkfifo((folder.path() / "in/fifo").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder.path() / "in/zero");
  expect_fault(fault_of_uri(folder, "folder"), "/buffers/0/uri: ", "not a regular file");
  expect_fault(fault_of_uri(folder, "fifo"), "/buffers/0/uri: ", "not a regular file");
  expect_fault(fault_of_uri(folder, "zero"), "/buffers/0/uri: ", "leaves the asset's folder");
  EXPECT_NE(fault_of(folder.path() / "in/fifo").find("not a regular file"), std::string::npos);
  EXPECT_NE(fault_of(folder.path() / "in/folder").find("not a regular file"), std::string::npos);
  EXPECT_NE(fault_of(folder.path() / "in/nothing").find("No such file"), std::string::npos);
}

TEST(GltfUris, AFileInTheCurrentFolderOnlyIsNotFound) {
  const TemporaryFolder folder;
  const std::string bin = folder.write("elsewhere/here.bin", test::one_triangle().bin).filename();
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path() / "elsewhere");
  const std::string fault = fault_of_uri(folder, bin);
  std::filesystem::current_path(before);
  expect_fault(fault, "/buffers/0/uri: can not find file");
}

TEST(GltfUris, SizesAndBase64MustBeRight) {
  const TemporaryFolder folder;
  const std::string bin = test::one_triangle().bin, data = "data:application/octet-stream;base64,";
  folder.write("in/short.bin", bin.substr(1));
  folder.write("in/long.bin", bin + "x");
  expect_fault(fault_of_uri(folder, "short.bin"),
               "/buffers/0: byteLength is 42, but there are 41 bytes");
  expect_fault(fault_of_uri(folder, "long.bin"),
               "/buffers/0: byteLength is 42, but there are 43 bytes");
  expect_fault(fault_of_uri(folder, data + "AAAA"),
               "/buffers/0: byteLength is 42, but there are 3 bytes");
  for (const std::string text : {"A", "AAA*", "AA=A", "====", "AAAA\n"}) {
    expect_fault(fault_of_uri(folder, data + text), "/buffers/0/uri: malformed base64");
  }
  expect_fault(fault_of_uri(folder, "data:,hello"), "/buffers/0/uri: data URI", "is not ;base64,");
  ImportLimits limits;
  limits.total_bytes = 3000;
  const std::string huge = test::one_triangle().gltf(data + std::string(2000, 'A'));
  EXPECT_NE(fault_of(folder.write("in/b.gltf", huge), limits), "");
}

TEST(GltfUris, AGlbBufferMustBeThere) {
  expect_damage(set("/buffers", {{{"byteLength", 0}}}), "/buffers/0/byteLength: is 0");
  expect_damage(set("/buffers", {{{"byteLength", 1000}}}),
                "/buffers/0: byteLength is 1000, but there are 44");
  expect_damage(set("/buffers", {{{"byteLength", 42}}, {{"byteLength", 42}}}),
                "/buffers/1: has neither");
  expect_damage(set("/buffers", {{{"byteLength", 4'000'000'001U}}}),
                "/buffers/0/byteLength: is 4000000001");
}

// A triangle whose base colour is this image, added to bufferView 2.
Damage textured(const std::string& bytes, const json& image) {
  return [=](GltfBuilder& b) {
    b.add_view(bytes.data(), bytes.size());
    b.add("images", image);
    b.add("textures", {{"source", 0}});
    b.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  };
}

TEST(GltfImages, AreDecodedWithinLimits) {
  const json in_view = {{"bufferView", 2}, {"mimeType", "image/png"}};
  const std::string good = test::png(2, 2, std::string(16, 'x'));
  expect_damage(textured(test::png_header(16000, 16000), in_view),
                "/images/0: image of 16000 x 16000 pixels, the limit is");
  expect_damage(textured(good.substr(0, 60), in_view), "/images/0: image can not be decoded");
  expect_damage(textured("GIF89a and so on", in_view), "/images/0: image is neither PNG nor JPEG");
  expect_damage(textured(good, {{"bufferView", 3}}), "/images/0/bufferView: is 3");
  expect_damage(textured(good, {{"uri", "gone.png"}}),
                "/images/0/uri: can not find file \"gone.png\"");
  expect_damage(textured(good, {{"uri", "../a.png"}}),
                "/images/0/uri: ", "leaves the asset's folder");
  expect_damage(textured(good, json::object()),
                "/images/0: must have either a uri or a bufferView");
  expect_damage(textured(good, {{"uri", "a.png"}, {"bufferView", 2}}),
                "/images/0: must have either");
}

TEST(GltfMaterials, ReferToWhatIsThere) {
  const auto material = [](const json& value) { return set("/materials", json::array({value})); };
  const std::string at = "/materials/0";
  expect_damage(material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}),
                at + "/pbrMetallicRoughness/baseColorTexture/index: is 0, but there is nothing");
  expect_damage(material({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1}}}}}),
                at + "/pbrMetallicRoughness/baseColorFactor: has 3 numbers, must have 4");
  expect_damage(material({{"pbrMetallicRoughness", {{"metallicFactor", 1.5}}}}),
                at + "/pbrMetallicRoughness/metallicFactor: is 1.5");
  expect_damage(material({{"alphaMode", "SHINY"}}), at + "/alphaMode: is \"SHINY\"");
  expect_damage(material({{"doubleSided", 1}}), at + "/doubleSided: must be true or false");
  expect_damage(set("/textures", {{{"source", 0}}}),
                "/textures/0/source: is 0, but there is nothing");
  expect_damage(set("/samplers", {{{"wrapS", 10498}}}), "/samplers/0/wrapS: is 10498");
}

}  // namespace
}  // namespace restframe
