// The images of a glTF file: decoded side by side, each once, within limits; the same faults on
// every run.

#include <gtest/gtest.h>

#include "scene/parallel.h"
#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

std::string gray_image(int size, int value) {
  std::string pixels;
  for (int i = 0; i < size * size; ++i) pixels += std::string(3, static_cast<char>(value)) + '\xff';
  return test::png(size, size, pixels);
}

// A triangle, and a material for each image in its colour.
GltfBuilder with_images(const std::vector<std::string>& files) {
  GltfBuilder builder = test::one_triangle();
  for (const std::string& file : files) {
    const int view = builder.add_view(file.data(), file.size());
    const int image = builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    const int texture = builder.add("textures", {{"source", image}});
    builder.add("materials",
                {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  }
  return builder;
}

class GltfImages : public test::GltfReading {};

TEST_F(GltfImages, AreEachTheirOwnOnAnyNumberOfThreads) {
  std::vector<std::string> files;
  for (int i = 0; i < 60; ++i) files.push_back(gray_image(1 + i % 7, i));
  const GltfBuilder builder = with_images(files);
  for (const int threads : {1, 4}) {
    set_thread_count(threads);
    const Asset asset = load(builder);
    ASSERT_EQ(asset.images.size(), 60U);
    for (int i = 0; i < 60; ++i) {
      const Image& image = asset.images[static_cast<std::size_t>(i)];
      EXPECT_EQ(image.width, 1 + i % 7);
      EXPECT_EQ(image.rgba.at(0), i);
      EXPECT_EQ(image.name, "image_" + std::to_string(i));
    }
  }
  set_thread_count(0);
}

// In runs where all together would be more than a single image may be.
TEST_F(GltfImages, AreReadWhereOneIsAsLargeAsTheLimit) {
  const GltfBuilder builder =
      with_images({gray_image(4, 1), gray_image(3, 2), gray_image(2, 3), gray_image(4, 4)});
  ImportLimits limits;
  limits.image_pixels = 16;
  const Asset asset = load_gltf(folder_.write("a.glb", builder.glb()), limits, warnings_);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(asset.images[static_cast<std::size_t>(i)].rgba[0], i + 1);
}

TEST_F(GltfImages, OfTheFirstBadOneIsSpoken) {
  const std::string cut = gray_image(5, 5).substr(0, 100), good = gray_image(5, 5);
  const GltfBuilder builder = with_images({good, cut, good, "GIF89a", cut, "BM"});
  for (int run = 0; run < 5; ++run) {
    test::expect_fault(test::fault_of_bytes(builder.glb()),
                       "/images/3: image is neither PNG nor JPEG but GIF");
    test::expect_fault(test::fault_of_bytes(with_images({good, cut, good, cut}).glb()),
                       "/images/1: image can not be decoded: ");
  }
}

// In the file's order, even if materials name them in another.
TEST_F(GltfImages, GoByTheirOwnOrder) {
  GltfBuilder builder = with_images({"GIF89a", "BM"});
  std::swap(builder.json["materials"][0], builder.json["materials"][1]);
  test::expect_fault(test::fault_of_bytes(builder.glb()), "/images/0: ");
}

// A hundred of 10 x 10 pixels, 400 bytes each, that share their bytes in the file.
TEST_F(GltfImages, AllTogetherHaveALimit) {
  GltfBuilder builder = with_images(std::vector<std::string>(100, gray_image(10, 1)));
  json& views = builder.json["bufferViews"];
  for (json& image : builder.json["images"])
    views[image["bufferView"].get<std::size_t>()] = views[2];
  builder.bin.resize(1000);
  ImportLimits limits;
  limits.total_bytes = 40'000;
  EXPECT_EQ(test::fault_of_bytes(builder.glb(), limits), "");
  limits.total_bytes = 30'000;
  test::expect_fault(test::fault_of_bytes(builder.glb(), limits),
                     "/images/75: the images up to this one are larger than 30000 bytes, the "
                     "limit; --max-bytes raises it");
}

TEST_F(GltfImages, AreWhatTheirBytesSay) {
  GltfBuilder builder = with_images({test::flat_jpeg({9}), gray_image(1, 8)});
  EXPECT_EQ(load(builder).images.at(0).rgba.at(0), 9);
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_TRUE(
      warned(":/images/0/mimeType: is \"image/png\", but the image is JPEG and read as that"));
  folder_.write("picture.jpg", gray_image(1, 7));
  builder.json["images"][1] = {{"uri", "picture.jpg"}};
  EXPECT_EQ(load(builder).images.at(1).rgba.at(0), 7);
}

// Many exporters write an image for each texture, all of the same file.
TEST_F(GltfImages, OfTheSameBytesAreDecodedOnce) {
  GltfBuilder builder = with_images({gray_image(1, 1), gray_image(1, 2), gray_image(1, 3)});
  json& images = builder.json["images"];
  folder_.write("picture.png", gray_image(1, 7));
  images[0] = {{"uri", "picture.png"}};
  images[2] = {{"uri", "picture.png"}, {"mimeType", "image/jpeg"}};
  images.push_back(images[1]);
  builder.json["textures"][1]["source"] = 3;
  const Asset asset = load(builder);
  ASSERT_EQ(asset.images.size(), 2U);
  EXPECT_EQ(asset.images[0].rgba.at(0), 7);
  EXPECT_EQ(asset.images[1].rgba.at(0), 2);
  const int expected[] = {0, 1, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const int texture = asset.materials.at(i).base_color_texture.texture;
    EXPECT_EQ(asset.textures.at(static_cast<std::size_t>(texture)).image, expected[i]);
  }
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_TRUE(warned(":/images/2/mimeType: is \"image/jpeg\", but the image is PNG"));
}

}  // namespace
}  // namespace restframe
