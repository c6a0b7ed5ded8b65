// Texture sampling and image decoding.

#include "scene/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/gltf_builder.h"

namespace restframe {
namespace {

// Texels of a row with these red values, 8 bits each; green, blue 0, alpha as given.
Image row_of(const std::vector<std::uint8_t>& reds, std::uint8_t alpha = 255) {
  Image image;
  image.width = static_cast<int>(reds.size());
  image.height = 1;
  for (const std::uint8_t red : reds) {
    for (const std::uint8_t channel : {red, std::uint8_t{0}, std::uint8_t{0}, alpha}) {
      image.rgba.push_back(channel);
    }
  }
  return image;
}

Texture data_texture(TextureFilter filter, Wrap wrap) {
  Texture texture;
  texture.srgb = false;
  texture.filter = filter;
  texture.wrap_u = texture.wrap_v = wrap;
  return texture;
}

float red_at(const Texture& texture, const Image& image, float u, float v = 0.5F) {
  return 255 * sample_texture(texture, image, {u, v}).x;
}

TEST(Texture, NearestTakesTheTexelThatHoldsThePoint) {
  const Image image = row_of({10, 20, 30, 40});
  const Texture texture = data_texture(TextureFilter::nearest, Wrap::repeat);
  EXPECT_FLOAT_EQ(red_at(texture, image, 0.01F), 10);
  EXPECT_FLOAT_EQ(red_at(texture, image, 0.26F), 20);
  EXPECT_FLOAT_EQ(red_at(texture, image, 0.99F), 40);
}

TEST(Texture, WrapsAsGltfSays) {
  const Image image = row_of({10, 20, 30, 40});
  const auto at = [&](Wrap wrap, float u) {
    return red_at(data_texture(TextureFilter::nearest, wrap), image, u);
  };
  EXPECT_FLOAT_EQ(at(Wrap::repeat, 1.1F), 10);
  EXPECT_FLOAT_EQ(at(Wrap::repeat, -0.1F), 40);
  EXPECT_FLOAT_EQ(at(Wrap::mirrored_repeat, 1.1F), 40);
  EXPECT_FLOAT_EQ(at(Wrap::mirrored_repeat, -0.3F), 20);
  EXPECT_FLOAT_EQ(at(Wrap::mirrored_repeat, 2.3F), 20);
  EXPECT_FLOAT_EQ(at(Wrap::clamp, 7), 40);
  EXPECT_FLOAT_EQ(at(Wrap::clamp, -7), 10);
}

TEST(Texture, LinearBlendsBetweenTexelCentres) {
  const Image image = row_of({0, 100, 200, 40});
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp}) {
    const Texture texture = data_texture(TextureFilter::linear, wrap);
    EXPECT_NEAR(red_at(texture, image, 0.125F), 0, 1e-3);
    EXPECT_NEAR(red_at(texture, image, 0.25F), 50, 1e-3);
    EXPECT_NEAR(red_at(texture, image, 0.4375F), 125, 1e-3);
  }
  // Half a texel past the last centre: half of the last, half of what follows it.
  EXPECT_NEAR(red_at(data_texture(TextureFilter::linear, Wrap::repeat), image, 1), 20, 1e-3);
  EXPECT_NEAR(red_at(data_texture(TextureFilter::linear, Wrap::clamp), image, 1), 40, 1e-3);
  EXPECT_NEAR(red_at(data_texture(TextureFilter::linear, Wrap::mirrored_repeat), image, 1), 40,
              1e-3);
}

TEST(Texture, RowZeroIsAtTheTop) {
  Image image = row_of({10, 20});
  image.width = 1;
  image.height = 2;
  const Texture texture = data_texture(TextureFilter::nearest, Wrap::clamp);
  EXPECT_FLOAT_EQ(red_at(texture, image, 0.5F, 0.1F), 10);
  EXPECT_FLOAT_EQ(red_at(texture, image, 0.5F, 0.9F), 20);
}

TEST(Texture, ColoursAreSrgbAndAlphaIsLinear) {
  Texture texture = data_texture(TextureFilter::nearest, Wrap::repeat);
  texture.srgb = true;
  const Vec4f color = sample_texture(texture, row_of({188}, 128), {0.5F, 0.5F});
  EXPECT_NEAR(color.x, std::pow((188.0 / 255 + 0.055) / 1.055, 2.4), 1e-6);
  EXPECT_FLOAT_EQ(color.w, 128.0F / 255);
  EXPECT_NEAR(sample_texture(texture, row_of({5}), {0.5F, 0.5F}).x, 5.0 / 255 / 12.92, 1e-7);
}

TEST(Texture, AnyCoordinateIsSafe) {
  const Image image = row_of({10, 20, 30});
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const TextureFilter filter : {TextureFilter::linear, TextureFilter::nearest}) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp}) {
      for (const float u : {infinity, -infinity, std::nanf(""), 3e38F, -3e38F, 1e9F, -1e-30F, 1.0F,
                            0.99999994F, 2.0F, -1.0F, 0.0F}) {
        const float red = red_at(data_texture(filter, wrap), image, u, u);
        EXPECT_GE(red, 9.99F);
        EXPECT_LE(red, 30.01F);
      }
    }
  }
}

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

std::string fault_of(const std::string& bytes, const ImportLimits& limits = {}) {
  try {
    decode_image(bytes_of(bytes), "x.png", limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DecodeImage, ReadsPngRowsFromTheTop) {
  const std::string pixels("\1\2\3\4\5\6\7\10\11\12\13\14\15\16\17\20", 16);
  const Image image = decode_image(bytes_of(test::png(2, 2, pixels)), "x.png", {});
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.rgba, bytes_of(pixels));
}

TEST(DecodeImage, RefusesWhatItMustNotDecode) {
  EXPECT_EQ(fault_of("GIF89a......"), "x.png: image is neither PNG nor JPEG but GIF");
  EXPECT_EQ(fault_of("BM" + std::string(100, 'x')), "x.png: image is neither PNG nor JPEG but BMP");
  EXPECT_EQ(fault_of("RIFF1234WEBPVP8 "), "x.png: image is neither PNG nor JPEG but WebP");
  EXPECT_EQ(fault_of("nothing known"), "x.png: image is neither PNG nor JPEG");
  EXPECT_NE(fault_of("").find("neither PNG nor JPEG"), std::string::npos);
  EXPECT_NE(
      fault_of(test::png_header(16000, 16000)).find("16000 x 16000 pixels, the limit is 64000000"),
      std::string::npos);
  EXPECT_NE(fault_of(test::png_header(4, 4)).find("can not be decoded"), std::string::npos);
  const std::string whole = test::png(8, 8, std::string(256, 'x'));
  EXPECT_EQ(fault_of(whole), "");
  EXPECT_NE(fault_of(whole.substr(0, 90)).find("can not be decoded"), std::string::npos);
  ImportLimits limits;
  limits.image_pixels = 63;
  EXPECT_NE(fault_of(whole, limits).find("the limit is 63 pixels"), std::string::npos);
}

}  // namespace
}  // namespace restframe
