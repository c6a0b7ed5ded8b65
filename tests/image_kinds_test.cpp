// The kinds of PNG and JPEG that people have: each is read right, or refused.

#include <gtest/gtest.h>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/image_files.h"

namespace restframe {
namespace {

using test::flat_jpeg;
using test::PngColor;

using Pixels = std::vector<std::uint8_t>;

Pixels pixels_of(const std::string& file) {
  return decode_image(Pixels(file.begin(), file.end()), "x", {}).rgba;
}

std::string fault_of(const std::string& file) {
  try {
    pixels_of(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Png, OfSixteenBitsAreRead) {
  const std::string rgba("\x12\x34\x56\x78\x9a\xbc\xff\xff", 8);
  EXPECT_EQ(pixels_of(test::png_of(1, 1, 16, PngColor::rgba, {rgba})),
            (Pixels{0x12, 0x56, 0x9a, 0xff}));
  EXPECT_EQ(pixels_of(test::png_of(1, 1, 16, PngColor::grey, {rgba.substr(2, 2)})),
            (Pixels{0x56, 0x56, 0x56, 255}));
  EXPECT_EQ(pixels_of(test::png_of(1, 1, 16, PngColor::rgb, {rgba.substr(0, 6)})),
            (Pixels{0x12, 0x56, 0x9a, 255}));
}

TEST(Png, OfGreyAreRead) {
  EXPECT_EQ(pixels_of(test::png_of(2, 1, 8, PngColor::grey, {"\x07\x80"})),
            (Pixels{7, 7, 7, 255, 128, 128, 128, 255}));
  EXPECT_EQ(pixels_of(test::png_of(1, 1, 8, PngColor::grey_alpha, {"\x07\x80"})),
            (Pixels{7, 7, 7, 128}));
  // Fewer bits stand for fractions of white: 2 of 3 of four grey values.
  EXPECT_EQ(pixels_of(test::png_of(4, 1, 2, PngColor::grey, {"\x1b"})),
            (Pixels{0, 0, 0, 255, 85, 85, 85, 255, 170, 170, 170, 255, 255, 255, 255, 255}));
  EXPECT_EQ(pixels_of(test::png_of(2, 1, 1, PngColor::grey, {"\x40"})),
            (Pixels{0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(Png, OfPalettesAreReadWithTheirAlpha) {
  const std::string palette = test::png_chunk("PLTE", "\x01\x02\x03\x0a\x0b\x0c");
  EXPECT_EQ(pixels_of(test::png_of(2, 1, 8, PngColor::palette, {std::string("\1\0", 2)}, palette)),
            (Pixels{10, 11, 12, 255, 1, 2, 3, 255}));
  const std::string alpha = palette + test::png_chunk("tRNS", "\x40");
  EXPECT_EQ(pixels_of(test::png_of(2, 1, 4, PngColor::palette, {"\x10"}, alpha)),
            (Pixels{10, 11, 12, 255, 1, 2, 3, 64}));
  EXPECT_EQ(fault_of(test::png_of(1, 1, 8, PngColor::palette, {std::string("\0", 1)})),
            "x: image can not be decoded: unknown image type");
}

TEST(Png, WithOneTransparentColourAreRead) {
  const std::string key = test::png_chunk("tRNS", std::string("\0\x07", 2));
  EXPECT_EQ(pixels_of(test::png_of(2, 1, 8, PngColor::grey, {"\x07\x08"}, key)),
            (Pixels{7, 7, 7, 0, 8, 8, 8, 255}));
}

TEST(Png, ThatIsDamagedIsRefused) {
  std::string file = test::png(3, 3, std::string(36, 'x'));
  file[60] ^= 1;
  EXPECT_EQ(fault_of(file),
            "x: image is a PNG damaged: the checksum of its \"IDAT\" chunk is wrong");
  std::string remark = test::png_chunk("tEXt", "Comment");
  remark.back() ^= 1;  // which is no reason
  EXPECT_EQ(fault_of(test::png_of(1, 1, 8, PngColor::grey, {"x"}, remark)), "");
}

void expect_flat(const std::string& file, int red, int green, int blue) {
  const Pixels pixels = pixels_of(file);
  ASSERT_EQ(pixels.size(), 4 * 64U);
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    EXPECT_NEAR(pixels[i], red, 1);
    EXPECT_NEAR(pixels[i + 1], green, 1);
    EXPECT_NEAR(pixels[i + 2], blue, 1);
    EXPECT_EQ(pixels[i + 3], 255);
  }
}

TEST(Jpeg, OfGreyAndYCbCrAreRead) {
  expect_flat(flat_jpeg({77}), 77, 77, 77);
  expect_flat(flat_jpeg({200, 128, 128}), 200, 200, 200);
  // ITU-T T.871: R = Y + 1.402 (Cr - 128), G = Y - 0.344136 (Cb - 128) - 0.714136 (Cr - 128),
  // B = Y + 1.772 (Cb - 128).
  expect_flat(flat_jpeg({120, 100, 150}), 151, 114, 70);
}

TEST(Jpeg, ThatIsProgressiveIsRead) {
  test::JpegKind kind;
  kind.progressive = true;
  expect_flat(flat_jpeg({120, 100, 150}, kind), 151, 114, 70);
}

TEST(Jpeg, OfRgbAsAdobeMarksItIsRead) {
  test::JpegKind kind;
  kind.adobe_transform = 0;
  expect_flat(flat_jpeg({10, 20, 30}, kind), 10, 20, 30);
}

// Adobe writes 255 less each ink; what the inks leave multiplies with what black leaves.
TEST(Jpeg, OfInksAsAdobeMarksThemIsRead) {
  test::JpegKind kind;
  kind.adobe_transform = 0;
  expect_flat(flat_jpeg({200, 100, 50, 255}, kind), 200, 100, 50);
  expect_flat(flat_jpeg({200, 100, 50, 128}, kind), 100, 50, 25);
}

TEST(Jpeg, OfFourUnknownChannelsIsRefused) {
  EXPECT_EQ(fault_of(flat_jpeg({1, 2, 3, 4})),
            "x: image is a JPEG of four channels whose meaning it does not say; save it as RGB");
}

TEST(Jpeg, ThatIsCutOffIsRefused) {
  const std::string whole = flat_jpeg({120, 100, 150});
  EXPECT_EQ(fault_of(whole), "");
  EXPECT_EQ(fault_of(whole.substr(0, whole.size() - 2)),
            "x: image is a JPEG cut off: it has no end-of-image marker");
  for (std::size_t length = 3; length < whole.size(); ++length) {
    EXPECT_NE(fault_of(whole.substr(0, length)), "") << length;
  }
}

}  // namespace
}  // namespace restframe
