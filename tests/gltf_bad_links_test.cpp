// What bad glTF files get, part 2: the graph, URIs, images and materials.

#include <sys/stat.h>

#include "support/gltf_faults.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::Damage;
using test::expect_damage;
using test::expect_fault;
using test::fault_of;
using test::GltfBuilder;
using test::set;

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
                 "leads out of the asset's folder");
  }
  const std::string absolute = (folder.path() / "in/inside.bin").string();
  expect_fault(fault_of_uri(folder, absolute), "/buffers/0/uri: ", "is an absolute path");
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
  expect_fault(fault_of_uri(folder, "link.bin"),
               "/buffers/0/uri: ", "leads out of the asset's folder");
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
  expect_fault(fault_of_uri(folder, "zero"), "/buffers/0/uri: ", "leads out of the asset's folder");
  EXPECT_NE(fault_of(folder.path() / "in/fifo").find("not a regular file"), std::string::npos);
  EXPECT_NE(fault_of(folder.path() / "in/folder").find("not a regular file"), std::string::npos);
  EXPECT_NE(fault_of(folder.path() / "in/nothing").find("no such file"), std::string::npos);
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
                "/images/0/uri: ", "leads out of the asset's folder");
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
  const auto extended = [&](const char* name, const json& value) {
    return material({{"extensions", {{name, value}}}});
  };
  const std::string in = at + "/extensions/KHR_materials_";
  expect_damage(extended("KHR_materials_ior", 3), in + "ior: is number, must be an object");
  expect_damage(extended("KHR_materials_ior", {{"ior", -1}}), in + "ior/ior: is -1");
  expect_damage(extended("KHR_materials_transmission", {{"transmissionFactor", 2}}),
                in + "transmission/transmissionFactor: is 2");
  expect_damage(extended("KHR_materials_transmission", {{"transmissionTexture", {{"index", 0}}}}),
                in + "transmission/transmissionTexture/index: is 0, but there is nothing");
  expect_damage(extended("KHR_materials_volume", {{"attenuationColor", {1, 1}}}),
                in + "volume/attenuationColor: has 2 numbers, must have 3");
  expect_damage(extended("KHR_materials_volume", {{"attenuationDistance", "far"}}),
                in + "volume/attenuationDistance");
  expect_damage(set("/textures", {{{"source", 0}}}),
                "/textures/0/source: is 0, but there is nothing");
  expect_damage(set("/samplers", {{{"wrapS", 10498}}}), "/samplers/0/wrapS: is 10498");
}

}  // namespace
}  // namespace restframe
