// Images of strangers: bombs, ranges outside of their buffer, broken and missing ones.

#include "support/hostile_gltf.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::HostileGltf;

class HostileImage : public HostileGltf {
 protected:
  // The triangle's base colour is this image; `bytes` are in bufferView 2.
  static Break textured(const std::string& bytes, const json& image) {
    return [=](GltfBuilder& b) {
      b.add_view(bytes.data(), bytes.size());
      b.add("images", image);
      b.add("textures", {{"source", 0}});
      b.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
      b.json["meshes"][0]["primitives"][0]["material"] = 0;
    };
  }
  void expect_image_refused(const std::string& bytes, const json& image, const std::string& begin,
                            const std::string& part = "") const {
    expect_broken(textured(bytes, image), begin, part);
  }

  json in_view = {{"bufferView", 2}, {"mimeType", "image/png"}};
  std::string good = test::png(2, 2, std::string(16, 'x'));
};

TEST_F(HostileImage, Bombs) {
  const std::string begin = "/images/0: image of ";
  expect_image_refused(test::png_header(16000, 16000), in_view, begin + "16000 x 16000 pixels",
                       "the limit is 64000000 pixels");
  expect_image_refused(test::png_header(0x7FFFFFFF, 0x7FFFFFFF), in_view, "/images/0: image ");
  expect_image_refused(test::png_header(0, 5), in_view, "/images/0: image ");
  const std::string jpeg(
      "\xff\xd8\xff\xc0\x00\x11\x08\xff\xff\xff\xff\x03\x01\x22\x00\x02\x11"
      "\x01\x03\x11\x01",
      21);
  expect_image_refused(jpeg, in_view, begin + "65535 x 65535 pixels");
}

TEST_F(HostileImage, RangesOutsideTheBuffer) {
  const auto damaged_view = [&](const char* key, std::uint64_t value) {
    return [=, this](GltfBuilder& b) {
      textured(good, in_view)(b);
      b.json["bufferViews"][2][key] = value;
    };
  };
  expect_broken(damaged_view("byteLength", 1'000'000), "/bufferViews/2: ends at byte");
  expect_broken(damaged_view("byteOffset", 1'000'000), "/bufferViews/2: ends at byte");
  expect_broken(damaged_view("byteOffset", ~0ULL - 8), "/bufferViews/2/byteOffset: is ");
  expect_image_refused(good, {{"bufferView", 3}, {"mimeType", "image/png"}},
                       "/images/0/bufferView: is 3");
}

TEST_F(HostileImage, CorruptOnes) {
  expect_image_refused(good.substr(0, 60), in_view, "/images/0: image can not be decoded");
  std::string damaged = good;
  damaged[45] = static_cast<char>(damaged[45] ^ 0x55);
  expect_image_refused(damaged, in_view, "/images/0: image is a PNG damaged: the checksum of its ");
  // A table of 16 x 255 codes, where 256 can be.
  const std::string table =
      std::string("\xff\xd8\xff\xc4\x10\x03\x00", 7) + std::string(16, '\xff');
  expect_image_refused(table + std::string(4080, 'x'), in_view,
                       "/images/0: image can not be decoded: a Huffman table of more than 256");
}

TEST_F(HostileImage, MissingOnes) {
  expect_image_refused(good, {{"uri", "gone.png"}},
                       "/images/0/uri: can not find file \"gone.png\"");
  expect_image_refused(good, {{"uri", "../a.png"}},
                       "/images/0/uri: ", "leads out of the asset's folder");
  expect_image_refused(good, json::object(), "/images/0: must have either a uri or a bufferView");
}

TEST_F(HostileImage, AnotherFormatUnderAPngsName) {
  folder.write("a.png", "GIF89a and so on");
  expect_image_refused(good, {{"uri", "a.png"}}, "/images/0: image is neither PNG nor JPEG");
  expect_image_refused("BM......", in_view, "/images/0: image is neither PNG nor JPEG");
}

}  // namespace
}  // namespace restframe
