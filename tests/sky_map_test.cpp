// Environments from OpenEXR files: where their pixels lie in the sky, and what bad files get.

#include "scene/sky_map.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/exr_writer.h"
#include "support/velocity_grid.h"

namespace restframe {
namespace {

using ::testing::HasSubstr;

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

Warnings ignored;

SkyMap decode(const std::string& text, Warnings& warnings = ignored,
              const ImportLimits& limits = {}) {
  return decode_sky_map(bytes_of(text), "sky.exr", limits, warnings);
}

std::string fault(const std::string& text, const ImportLimits& limits = {}) {
  try {
    decode(text, ignored, limits);
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().size(), 1U);
    return error.faults()[0];
  }
  return "none";
}

Vec3f ramp(int x, int y) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y)};
}

TEST(SkyMap, IsReadInEveryLosslessCompression) {
  for (const Compression compression : {Compression::none, Compression::rle, Compression::zips,
                                        Compression::zip, Compression::piz}) {
    const SkyMap map = decode(sky_exr(9, 5, ramp, compression));
    ASSERT_EQ(map.width, 9);
    ASSERT_EQ(map.height, 5);
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 9; ++x)
        EXPECT_EQ(map.pixels[static_cast<std::size_t>(y * 9 + x)], ramp(x, y));
    }
  }
}

TEST(SkyMap, MayHaveHalfsAndOtherChannels) {
  const std::vector<float> one = {1, 2}, two = {3, 4}, three = {5, 6}, alpha = {0, 0};
  const SkyMap map = decode(exr_bytes(
      {2, 1, {{"A", alpha}, {"B", three}, {"G", two}, {"R", one}}, Compression::zip, true}));
  EXPECT_EQ(map.pixels[0], Vec3f(1, 3, 5));
  EXPECT_EQ(map.pixels[1], Vec3f(2, 4, 6));
}

TEST(SkyMap, MayHaveLuminanceAlone) {
  const SkyMap map = decode(exr_bytes({2, 1, {{"Y", {1.5F, 2.5F}}}}));
  EXPECT_EQ(map.pixels[0], Vec3f(1.5F));
  EXPECT_EQ(map.pixels[1], Vec3f(2.5F));
}

TEST(SkyMap, TakesNegativeValuesForDark) {
  Warnings warnings;
  const SkyMap map =
      decode(sky_exr(2, 1, [](int x, int) { return Vec3f(1, x == 0 ? -0.5F : 2, 3); }), warnings);
  EXPECT_EQ(map.pixels[0], Vec3f(1, 0, 3));
  EXPECT_EQ(map.pixels[1], Vec3f(1, 2, 3));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("1 pixels are negative"));
}

// The middle column looks along +X; the zenith is +Y; to the right of +X is +Z.
TEST(SkyMap, LiesInTheSkyAsDocumented) {
  SkyMap map{"", 8, 4, std::vector<Vec3f>(32)};
  const auto expect = [&](const Vec3& direction, double x, double y) {
    const SkyPlace place = sky_place(map, direction);
    EXPECT_NEAR(place.x, x, 1e-12) << direction.x << ' ' << direction.y << ' ' << direction.z;
    EXPECT_NEAR(place.y, y, 1e-12);
  };
  expect({1, 0, 0}, 4, 2);
  expect({0, 0, 1}, 6, 2);
  expect({0, 0, -1}, 2, 2);
  expect({0, 1, 0}, 4, 0);
  expect({0, -1, 0}, 4, 4);
  expect(glm::normalize(Vec3(1, 1, 0)), 4, 1);
}

TEST(SkyMap, DirectionsAndPlacesAreInverse) {
  const SkyMap map{"", 16, 8, std::vector<Vec3f>(128)};
  for (const Vec3& direction : direction_grid(200)) {
    const Vec3 there = sky_direction(map, sky_place(map, direction));
    EXPECT_LT(glm::length(there - direction), 1e-14);
  }
}

TEST(SkyMap, IsBilinearAroundTheSeamAndHeldAtThePoles) {
  SkyMap map{"", 4, 2, {}};
  for (int i = 0; i < 8; ++i) map.pixels.emplace_back(static_cast<float>(i));
  EXPECT_EQ(radiance_at(map, {0.5, 0.5}).x, 0.0F);
  EXPECT_EQ(radiance_at(map, {1, 0.5}).x, 0.5F);
  EXPECT_EQ(radiance_at(map, {0, 0.5}).x, 1.5F);  // between 0 and 3
  EXPECT_EQ(radiance_at(map, {4, 0.5}).x, 1.5F);
  EXPECT_EQ(radiance_at(map, {2.5, 0}).x, 2.0F);
  EXPECT_EQ(radiance_at(map, {2.5, 2}).x, 6.0F);
  EXPECT_EQ(radiance_at(map, {2, 1}).x, 3.5F);
}

TEST(BadSkyMap, IsNotAnExr) {
  EXPECT_THAT(fault(""), HasSubstr("ends within its header"));
  EXPECT_THAT(fault("not an EXR at all"), HasSubstr("file expected, this is none"));
}

// Cut off anywhere: never a crash, always one line.
TEST(BadSkyMap, IsCutOff) {
  for (const Compression compression : {Compression::none, Compression::zip, Compression::piz}) {
    const std::string whole = sky_exr(13, 40, ramp, compression);
    for (std::size_t size = 0; size < whole.size(); size += 7) {
      const std::string said = fault(whole.substr(0, size));
      EXPECT_THAT(said, HasSubstr("sky.exr: EXR")) << size << " of " << whole.size();
      EXPECT_EQ(said.find('\n'), std::string::npos);
    }
  }
}

TEST(BadSkyMap, IsOfAKindThatIsNotRead) {
  const std::string whole = sky_exr(2, 2, ramp);
  const auto with_flag = [&](int byte, int bit) {
    std::string changed = whole;
    changed[static_cast<std::size_t>(byte)] =
        static_cast<char>(changed[static_cast<std::size_t>(byte)] | (1 << bit));
    return changed;
  };
  EXPECT_THAT(fault(with_flag(5, 1)), HasSubstr("in tiles"));
  EXPECT_THAT(fault(with_flag(5, 3)), HasSubstr("of deep pixels"));
  EXPECT_THAT(fault(with_flag(5, 4)), HasSubstr("of many parts"));
  EXPECT_THAT(fault(with_flag(4, 0)), HasSubstr("is of version 3, must be 2"));
  EXPECT_THAT(fault(with_flag(6, 5)), HasSubstr("unknown flags"));
}

// The value of an attribute begins after its name, type and size.
std::string with_value(std::string exr, const std::string& name, const std::string& type,
                       const std::string& value, std::size_t offset = 0) {
  const std::string beginning = name + '\0' + type + '\0';
  const std::size_t at = exr.find(beginning);
  EXPECT_NE(at, exr.npos);
  return exr.replace(at + beginning.size() + 4 + offset, value.size(), value);
}

std::string number(std::int32_t value) {
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

TEST(BadSkyMap, IsCompressedAsB44) {
  for (const char kind : {'\x6', '\x7'}) {
    EXPECT_THAT(fault(with_value(sky_exr(2, 2, ramp), "compression", "compression", {kind})),
                HasSubstr("compressed as B44"));
  }
  EXPECT_THAT(fault(with_value(sky_exr(2, 2, ramp), "compression", "compression", "\x0a")),
              HasSubstr("unknown way 10"));
}

TEST(BadSkyMap, LiesAboutItsSize) {
  const auto sized = [](std::int32_t x, std::int32_t y) {
    const std::string edge = number(0) + number(0) + number(x - 1) + number(y - 1);
    return with_value(with_value(sky_exr(2, 2, ramp), "dataWindow", "box2i", edge), "displayWindow",
                      "box2i", edge);
  };
  EXPECT_THAT(fault(sized(16'000, 16'000)),
              HasSubstr("16000 x 16000 pixels, the limit is 64000000"));
  EXPECT_THAT(fault(sized(0, 5)), HasSubstr("empty window"));
  EXPECT_THAT(fault(sized(2'000'000'000, 1)), HasSubstr("edge at 1999999999"));
  EXPECT_THAT(fault(sized(2, 60)), HasSubstr("EXR"));
  EXPECT_THAT(fault(sized(16'000'000, 4)), HasSubstr("EXR"));
  ImportLimits limits;
  limits.total_bytes = 50;
  EXPECT_THAT(fault(sky_exr(2, 2, ramp), limits), HasSubstr("the limit is 50; --max-bytes"));
}

TEST(BadSkyMap, IsPartOfAPicture) {
  EXPECT_THAT(fault(exr_bytes({2, 1, {{"Y", {1, 2}}}, Compression::zip, false, 1, 0})),
              HasSubstr("data window is not its display window"));
}

TEST(BadSkyMap, LacksChannels) {
  EXPECT_THAT(fault(exr_bytes({1, 1, {{"R", {1}}, {"B", {1}}}})), HasSubstr("no channel G"));
  EXPECT_THAT(fault(exr_bytes({1, 1, {{"Z", {1}}}})),
              HasSubstr("no channel R, needs R, G, B or Y"));
}

TEST(BadSkyMap, IsSubsampled) {
  const std::string twice = number(2);
  EXPECT_THAT(
      fault(with_value(exr_bytes({2, 2, {{"Y", {1, 2, 3, 4}}}}), "channels", "chlist", twice, 10)),
      HasSubstr("subsampled channel Y"));
}

TEST(BadSkyMap, HasPixelsThatAreNoRadiance) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(), 1e21F, -1e21F}) {
    EXPECT_THAT(
        fault(sky_exr(3, 2, [&](int x, int y) { return Vec3f(1, x == 2 && y == 1 ? bad : 1, 1); })),
        HasSubstr("sky.exr: pixel (2, 1) is [1, "));
  }
}

}  // namespace
}  // namespace restframe
