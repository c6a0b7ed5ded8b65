#include "scene/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "scene/color_names.h"
#include "scene/suggest.h"
#include "support/expect_near.h"

namespace restframe {
namespace {

TEST(Color, NamesThatThePaperUsesInAnyCase) {
  EXPECT_EQ(color_from_text("Yellow"), Vec3f(1, 1, 0));
  EXPECT_EQ(color_from_text("BLUE"), Vec3f(0, 0, 1));
  EXPECT_EQ(color_from_text("red"), Vec3f(1, 0, 0));
}

TEST(Color, NamesAreDecodedFromSrgb) {
  // 128/255 in sRGB: ((0.50196 + 0.055) / 1.055)^2.4 = 0.215861
  expect_near(color_from_text("gray").value(), Vec3f(0.215861F), 1e-6F);
  expect_near(color_from_text("green").value(), Vec3f(0, 0.215861F, 0), 1e-6F);
  // rebeccapurple is #663399: 0x66 = 0.4 -> 0.132868, 0x33 = 0.2 -> 0.0331048, 0x99 = 0.6 ->
  // 0.318547
  expect_near(color_from_text("rebeccapurple").value(), Vec3f(0.132868F, 0.0331048F, 0.318547F),
              1e-6F);
}

TEST(Color, HexOfThreeAndSixDigits) {
  expect_near(color_from_text("#639").value(), color_from_text("rebeccapurple").value(), 0);
  expect_near(color_from_text("#663399").value(), color_from_text("rebeccapurple").value(), 0);
  EXPECT_EQ(color_from_text("#Ff0000"), Vec3f(1, 0, 0));
  EXPECT_EQ(color_from_text("#fff"), Vec3f(1));
}

TEST(Color, OtherTextsAreNone) {
  for (const char* bad : {"", "#", "#ff", "#ffff", "#fffff", "#fffffff", "#ggg", "#-12", "# ff",
                          "#0x1", "yelow", "yellow ", "blu"}) {
    EXPECT_EQ(color_from_text(bad), std::nullopt) << bad;
  }
}

TEST(Color, TableIsSortedAndWithoutDoubles) {
  std::set<std::string_view> names;
  for (const NamedColor& color : color_names) {
    EXPECT_TRUE(names.empty() || *names.rbegin() < color.name) << color.name;
    names.insert(color.name);
  }
  EXPECT_EQ(names.size(), 148U);
}

TEST(Color, NearestName) {
  EXPECT_EQ(nearest_color_name("yelow"), "yellow");
  EXPECT_EQ(nearest_color_name("Bleu"), "blue");
  EXPECT_EQ(nearest_color_name("darkslatgrey"), "darkslategrey");
}

TEST(Srgb, RoundTrips) {
  for (int i = -50; i <= 300; ++i) {
    const float x = static_cast<float>(i) / 200;
    expect_near(srgb_from_linear(linear_from_srgb(Vec3f(x))), Vec3f(x), 1e-6F);
  }
}

TEST(Srgb, KnownValues) {
  expect_near(linear_from_srgb(Vec3f(0, 0.04F, 1)), Vec3f(0, 0.04F / 12.92F, 1), 1e-7F);
  expect_near(srgb_from_linear(Vec3f(0.5F)), Vec3f(0.735357F), 1e-6F);
}

TEST(Suggest, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("fov", "fvo"), 1);
  EXPECT_EQ(edit_distance("ca", "abc"), 3);
}

TEST(Suggest, FindsTheNearest) {
  const std::vector<std::string> keys = {"position", "velocity", "rotation"};
  EXPECT_EQ(nearest("positon", keys), "position");
  EXPECT_EQ(nearest("rotaton", keys), "rotation");
  EXPECT_EQ(nearest("velosity", keys), "velocity");
  EXPECT_EQ(nearest("x", {}), "");
  EXPECT_EQ(nearest(std::string(5'000'000, 'v'), keys), "velocity");
}

}  // namespace
}  // namespace restframe
