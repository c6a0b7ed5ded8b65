// `restframe render --contact-sheet`: where each picture is, and that its light is kept.

#include "app/contact_sheet.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "app/picture_files.h"
#include "film/png_preview.h"
#include "importers/importers.h"
#include "support/exr_reader.h"
#include "support/program_errors.h"
#include "support/scene_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Image read_png(const fs::path& file) {
  const std::string content = bytes_of(file);
  return decode_image(std::vector<std::uint8_t>(content.begin(), content.end()), file.string(), {});
}

// IEC 61966-2-1.
double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

// Mean linear light of a part of an image.
Vec3 mean_light(const Image& image, int left, int top, int width, int height) {
  Vec3 sum(0);
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) {
      for (int i = 0; i < 3; ++i) {
        sum[i] +=
            linear(image.rgba[static_cast<std::size_t>(4 * (y * image.width + x) + i)] / 255.0);
      }
    }
  }
  return sum / (1.0 * width * height);
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance, const std::string& what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << what << ", component " << i;
}

TEST(SheetLayout, FitsAnySizeAndNumber) {
  for (const int count : {1, 2, 3, 7, 15, 100, 399, 400}) {
    for (const auto& [width, height] : {std::pair{1280, 720},
                                        {640, 360},
                                        {64, 48},
                                        {1, 1},
                                        {720, 1280},
                                        {32768, 1},
                                        {1, 32768},
                                        {32768, 32768}}) {
      const std::string what = fmt::format("{} of {} x {}", count, width, height);
      const SheetLayout layout = sheet_layout(static_cast<std::size_t>(count), width, height);
      EXPECT_LE(layout.width(), 1600) << what;
      EXPECT_GE(layout.columns * layout.rows, count) << what;
      EXPECT_LT(layout.columns * (layout.rows - 1), count) << what;
      EXPECT_TRUE(layout.cell_width >= 1 && layout.cell_width <= width) << what;
      EXPECT_TRUE(layout.cell_height >= 1 && layout.cell_height <= height) << what;
      // The picture's shape, to the rounding of a pixel.
      const double scale = 1.0 * layout.cell_width / width;
      if (layout.cell_width > 1 && layout.cell_height > 1) {
        EXPECT_NEAR(layout.cell_height, scale * height, 1 + 0.5 * height / width) << what;
      }
    }
  }
}

TEST(SheetLayout, CellsDoNotTouch) {
  const SheetLayout layout = sheet_layout(15, 64, 48);
  for (std::size_t a = 0; a < 15; ++a) {
    EXPECT_TRUE(layout.cell_x(a) > 0 && layout.cell_x(a) + layout.cell_width < layout.width());
    EXPECT_TRUE(layout.cell_y(a) > 0 && layout.cell_y(a) + layout.cell_height < layout.height());
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_TRUE(std::abs(layout.cell_x(a) - layout.cell_x(b)) > layout.cell_width ||
                  std::abs(layout.cell_y(a) - layout.cell_y(b)) > layout.cell_height);
    }
  }
}

TEST(EvenlyChosen, HasBothEndsAndNoGapLongerThanNeeded) {
  EXPECT_THAT(evenly_chosen(3, 400), testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(evenly_chosen(5, 3), testing::ElementsAre(0, 2, 4));
  for (const std::size_t count : {400UL, 401UL, 799UL, 12345UL, 1000000UL}) {
    const auto chosen = evenly_chosen(count, 400);
    ASSERT_EQ(chosen.size(), 400U);
    EXPECT_EQ(chosen.front(), 0U);
    EXPECT_EQ(chosen.back(), count - 1);
    const double step = static_cast<double>(count - 1) / 399;
    for (std::size_t i = 0; i < 400; ++i) {
      EXPECT_NEAR(static_cast<double>(chosen[i]), static_cast<double>(i) * step, 0.5 + 1e-6);
    }
  }
}

// Noise is where a scaling that skips pixels, or averages encoded values, goes wrong.
TEST(ContactSheet, KeepsTheLightOfNoise) {
  const TemporaryFolder folder;
  std::mt19937 random(7);
  std::vector<fs::path> pngs;
  std::vector<Vec3> light;
  constexpr int width = 501, height = 163;
  for (int i = 0; i < 7; ++i) {
    std::vector<std::uint8_t> rgb(3 * width * height);
    for (std::uint8_t& byte : rgb)
      byte = static_cast<std::uint8_t>(random() % 4 == 0 ? 255 : 20 * i);
    pngs.push_back(folder.path() / fmt::format("{}.png", i));
    write_png(pngs.back(), width, height, rgb);
    light.push_back(mean_light(read_png(pngs.back()), 0, 0, width, height));
  }
  write_contact_sheet(folder.path() / "sheet.png", pngs, width, height);
  const Image sheet = read_png(folder.path() / "sheet.png");
  const SheetLayout layout = sheet_layout(7, width, height);
  EXPECT_EQ(sheet.width, layout.width());
  EXPECT_EQ(sheet.height, layout.height());
  for (std::size_t i = 0; i < 7; ++i) {
    expect_near(mean_light(sheet, layout.cell_x(i), layout.cell_y(i), layout.cell_width,
                           layout.cell_height),
                light[i], 2e-4, pngs[i].string());
  }
}

constexpr const char* kScene = R"(
[camera]
position = [0, 0, 4]
[animation]
rate = 1
pictures = 12
[render]
resolution = [480, 270]
samples = 1
[output]
path = "p.##.exr"
[[object]]
sphere = {radius = 1, fineness = 2}
position = [-1, 0, 0]
velocity = [0.3, 0, 0]
[[material]]
name = "ball"
base_color = "orange"
)";

class ContactSheetOfAScene : public testing::Test, public SceneFolder {
 protected:
  ContactSheetOfAScene() : SceneFolder(kScene) {}
};

Vec3 mean_light(const ExrPicture& picture) {
  Vec3 sum(0);
  const char* names[] = {"R", "G", "B"};
  for (int i = 0; i < 3; ++i) {
    for (const float value : picture.channel(names[i])) sum[i] += std::clamp(value, 0.0F, 1.0F);
  }
  return sum / (1.0 * picture.width * picture.height);
}

TEST_F(ContactSheetOfAScene, EachCellHasItsPicturesLight) {
  const RunResult result = render({"--contact-sheet", "looks/sheet.png"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("looks/sheet.png: 12 of 12 pictures\n"));
  const Image sheet = read_png(path("looks/sheet.png"));
  // Four columns: 4 x 395 + 5 gaps of 4; three rows of 222.
  EXPECT_EQ(sheet.width, 1600);
  EXPECT_EQ(sheet.height, 3 * 222 + 4 * 4);
  double largest = 0;
  for (int i = 0; i < 12; ++i) {
    const Vec3 expected = mean_light(read_exr(path(fmt::format("p.{:02}.exr", i))));
    largest = std::max(largest, expected.x);
    expect_near(mean_light(sheet, 4 + i % 4 * 399, 4 + i / 4 * 226, 395, 222), expected, 5e-4,
                fmt::format("picture {}", i));
  }
  EXPECT_GT(largest, 0.05);
  // Between and around them nothing shows.
  for (const int x : {1, 401, 800, 1598}) {
    expect_near(mean_light(sheet, x, 0, 1, sheet.height), mean_light(sheet, 0, 0, 1, 1), 1e-12,
                fmt::format("column {}", x));
  }
}

TEST_F(ContactSheetOfAScene, IsTheSameForAResumedAnimation) {
  ASSERT_EQ(render({"--contact-sheet", "a.png"}).exit_code, 0);
  for (const char* name : {"p.03.exr", "p.07.exr", "p.07.png", "p.08.png"}) fs::remove(path(name));
  fs::resize_file(path("p.09.png"), 500);
  ASSERT_EQ(render({"--contact-sheet", "b.png", "--threads", "1"}).exit_code, 0);
  EXPECT_TRUE(content("a.png") == content("b.png"));
  ASSERT_EQ(render({"--contact-sheet", "part.png", "--pictures", "3-4", "--quiet"}).exit_code, 0);
  EXPECT_EQ(read_png(path("part.png")).width, 2 * 480 + 3 * 4);
}

TEST_F(ContactSheetOfAScene, WhatCanNotBeMadeIsSaid) {
  const auto fails = [&](const std::vector<std::string>& options, int code, const char* part) {
    expect_error(render(options), code, {part});
  };
  fails({"--contact-sheet", "sheet.jpg"}, 2, "must end in .png");
  fails(
      {"--contact-sheet", "../" + path("p.05.png").parent_path().filename().string() + "/p.05.png"},
      2, "preview of a picture");
  fails({"--contact-sheet", "scene.toml/sheet.png"}, 3, "scene.toml/sheet.png");
  EXPECT_FALSE(exists("p.00.exr"));
}

TEST_F(ContactSheetOfAScene, ShowsPicturesAsTheyWereAskedFor) {
  const auto sheet = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all = {"--contact-sheet", "s.png", "--pictures", "0-1"};
    all.insert(all.end(), options.begin(), options.end());
    EXPECT_EQ(render(all).exit_code, 0);
    return content("s.png");
  };
  const std::string plain = sheet({});
  EXPECT_FALSE(sheet({"--view", "filmic", "--exposure", "-4"}) == plain);
  EXPECT_TRUE(sheet({}) == plain);
  write_png(path("p.01.png"), 2, 2, std::vector<std::uint8_t>(12));
  EXPECT_TRUE(sheet({}) == plain);
}

}  // namespace
}  // namespace restframe
