// glTF's container and JSON from strangers: each gets one line, exit code 2, and nothing else.

#include <limits>

#include "support/hostile_gltf.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::HostileGltf;

class HostileContainer : public HostileGltf {
 protected:
  std::string good = test::one_triangle().glb();
  std::string with(std::size_t at, std::uint32_t value) const {
    std::string bytes = good;
    return bytes.replace(at, 4, test::little_endian(value));
  }
  std::size_t bin_chunk() const {
    return 20 +
           (static_cast<unsigned char>(good[12]) + 256U * static_cast<unsigned char>(good[13]));
  }
};

TEST_F(HostileContainer, Lengths) {
  expect_bytes_refused("", " the file is empty");
  expect_bytes_refused("glTF", " GLB ends within its header");
  expect_bytes_refused(good.substr(0, 100), " GLB header says");
  expect_bytes_refused(good + "abcd", " GLB header says");
  expect_bytes_refused(with(8, 0xFFFFFFFF), " GLB header says 4294967295 bytes");
  expect_bytes_refused(with(12, 0xFFFFFFFC), " GLB chunk claims 4294967292 bytes");
  expect_bytes_refused(with(bin_chunk(), 0x7FFFFFFC), " GLB chunk claims 2147483644 bytes");
  expect_bytes_refused(with(12, 21), " GLB chunk of 21 bytes is not a multiple of 4");
}

TEST_F(HostileContainer, ChunksInTheWrongPlace) {
  expect_bytes_refused(with(16, 0x004E4942), " first GLB chunk is not JSON");
  expect_bytes_refused(with(bin_chunk() + 4, 0x4E4F534A), " GLB has a second JSON chunk");
  const std::string bin = test::chunk(std::string("BIN\0", 4), "abcd");
  const std::string chunks = test::chunk("JSON", R"({"asset":{"version":"2.0"}} )") + bin + bin;
  const auto size = static_cast<std::uint32_t>(12 + chunks.size());
  expect_bytes_refused("glTF" + test::little_endian(2) + test::little_endian(size) + chunks,
                       " GLB has a BIN chunk at place 3");
}

TEST_F(HostileContainer, AZeroByteBinChunkIsFine) {
  const std::string text = test::one_triangle().gltf("data:application/octet-stream;base64," +
                                                     test::base64(test::one_triangle().bin));
  std::string padded = text;
  padded.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string chunks = test::chunk("JSON", padded) + test::chunk(std::string("BIN\0", 4), "");
  const auto size = static_cast<std::uint32_t>(12 + chunks.size());
  folder.write("a.glb", "glTF" + test::little_endian(2) + test::little_endian(size) + chunks);
  expect_rendered("a.glb");
}

TEST_F(HostileContainer, Versions) {
  expect_bytes_refused(with(4, 1), " GLB version 1, only version 2");
  expect_bytes_refused(with(4, 3), " GLB version 3, only version 2");
  expect_set("/asset/version", "1.0", "/asset/version: glTF 1.0, only 2.0");
  expect_set("/asset/version", 1, "/asset/version: glTF 1.0, only 2.0");
  expect_set("/asset/version", "3.0", "/asset/version: glTF 3.0, only 2.0");
  expect_set("/asset/minVersion", "2.1", "/asset/minVersion: needs glTF 2.1");
  expect_set("/extensionsRequired", {"KHR_nonsense"},
             "/extensionsRequired/0: extension \"KHR_nonsense\" is required but not supported");
}

TEST_F(HostileContainer, TextThatIsNotJson) {
  expect_bytes_refused("{\"x\": \"\xff\xfe\"}", "1:8: not JSON", "UTF-8");
  expect_bytes_refused("{\"asset\": {\"version\": \"2.0\"}, \"x\": NaN}", "1:36: not JSON");
  expect_bytes_refused("{\"x\": 1e400}", "1:", "number overflow parsing '1e400'");
  expect_bytes_refused("{\"x\": 1, \"x\": 2}", "/: key \"x\" is there twice");
  expect_bytes_refused("\xef\xbb\xbf[]", "/: is array, must be an object");
}

TEST_F(HostileContainer, NestingWithoutEnd) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  const std::string objects = [] {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += "{\"a\":";
    return text + "1" + std::string(100'000, '}');
  }();
  expect_bytes_refused("{\"extras\": " + deep + "}", "/: nested deeper than the limit of 64");
  expect_bytes_refused("{\"extras\": " + objects + "}", "/: nested deeper than the limit of 64");
  expect_bytes_refused("{\"nodes\": " + deep + "}", "/nodes/0/0", "the limit of 64");
}

TEST_F(HostileContainer, WrongTypes) {
  for (const char* key : {"accessors", "bufferViews", "buffers", "images", "materials", "meshes",
                          "nodes", "samplers", "scenes", "textures"}) {
    const std::string pointer = std::string("/") + key;
    expect_set(pointer, nullptr, pointer + ": is null, must be an array");
    expect_set(pointer, json::array({7}), pointer + "/0: is number, must be an object");
  }
  expect_set("/asset", nullptr, "/asset: is null, must be an object");
  expect_set("/asset/version", 2.0, "/asset/version: is number, must be a string");
}

TEST_F(HostileContainer, TooManyElements) {
  std::string many = "{\"asset\":{\"version\":\"2.0\"},\"materials\":[{}";
  for (int i = 0; i < 300'000; ++i) many += ",{}";  // 0.9 MB
  expect_bytes_refused(many + "]}", "/materials: has 300001 elements, the limit is 50000");
  std::string numbers = "{\"asset\":{\"version\":\"2.0\"},\"x\":[0";
  for (int i = 0; i < 1'000'000; ++i) numbers += ",0";
  expect_bytes_refused(numbers + "]}", "/x: more than 1000000 elements");
}

}  // namespace
}  // namespace restframe
