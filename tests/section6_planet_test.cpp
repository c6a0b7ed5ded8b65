// Section 6 of the paper: a command over two light-hours and the answer, seen from home four hours
// later.

#include <gtest/gtest.h>

#include <numbers>

#include "support/shown_scene.h"

namespace restframe {
namespace {

using reference::Long3;

constexpr int planet = 1, probe = 2, lamp = 3;  // the scene's objects
const Long3 planet_place{0.04L, 0, -7200}, probe_place{-0.13L, -0.06L, -7200};
const Long3 spot_place{-2.2e-5L, 1.3e-5L, -1.000002L};

Vec3 mean_color(const ExrPicture& picture, int object) {
  const std::vector<ShownPixel> pixels = pixels_of(picture, object);
  EXPECT_FALSE(pixels.empty()) << "object " << object;
  Vec3 sum(0);
  for (const ShownPixel& pixel : pixels) sum += pixel.color;
  return sum / static_cast<double>(pixels.size());
}

// The scene's own pictures, at 1 minute, 16 minutes ... The command lasts half an hour.
TEST(OuterPlanet, AnswersFourHoursAfterTheCommand) {
  const auto pictures =
      shown("outer_planet", with_places(scene_text("outer_planet")), {"160x90", 1, 20});
  const double planet_before = mean_color(pictures[0], planet).y;
  for (int i = 0; i < 20; ++i) {
    const ExrPicture& picture = pictures[static_cast<std::size_t>(i)];
    const double minutes = 1 + 15 * i;
    const bool commands = minutes < 30;
    const bool answered = minutes >= 240 && minutes < 270;
    EXPECT_EQ(mean_color(picture, lamp).y > 0.9, commands) << minutes;
    EXPECT_EQ(mean_color(picture, probe).x > 0.9, answered) << minutes;
    EXPECT_EQ(mean_color(picture, planet).y > planet_before + 0.1, answered) << minutes;
  }
}

std::string in_the_dark(const std::string& start, const std::string& rate) {
  std::string text = with_places(scene_text("outer_planet"));
  text = replaced(text, "intensity = 1.2\n", "intensity = 0\n");
  text = replaced(text, "rate = 0.0011111111111111111 ", "rate = " + rate + " ");
  return replaced(text, "start = 60\n", "start = " + start + "\n");
}

// To a fiftieth of a second in four hours, pixel by pixel: the probe's near side shows the answer
// first.
TEST(OuterPlanet, TheAnswerComesWhenLightDoes) {
  const auto pictures = shown("outer_planet", in_the_dark("14399.98", "500"), {"320x180", 1, 12});
  int lit = 0, dark = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (const ShownPixel& pixel : pixels_of(pictures[i], probe)) {
      const long double time = 14399.98L + static_cast<long double>(i) / 500;
      const long double clock = time - reference::length(pixel.at + probe_place);
      if (std::abs(clock - 7200) < 1e-5L) continue;
      ASSERT_EQ(pixel.color.x > 0.5, clock > 7200) << static_cast<double>(clock);
      (clock > 7200 ? lit : dark) += 1;
    }
  }
  EXPECT_GT(lit, 50);
  EXPECT_GT(dark, 50);
}

// The command's light itself comes back from the planet, and is as bright there as a beam of a
// hundredth of a degree is.
TEST(OuterPlanet, TheEchoComesWhenLightDoes) {
  const auto pictures = shown("outer_planet", in_the_dark("14398.84", "50"), {"320x180", 1, 9});
  int lit = 0, dark = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (const ShownPixel& pixel : pixels_of(pictures[i], planet)) {
      const long double time = 14398.84L + static_cast<long double>(i) / 50;
      const Long3 at = pixel.at + planet_place;
      const Long3 way = at - spot_place;
      const long double distance = reference::length(way);
      const long double clock = time - reference::length(at) - distance;
      const long double cosine = -reference::dot(way, pixel.normal) / distance;
      if (std::abs(clock) < 1e-5L || cosine < 0.1L) continue;
      const double full =
          static_cast<double>(2.5e8L * cosine / (distance * distance)) * 0.4 / std::numbers::pi;
      ASSERT_NEAR(pixel.color.y, clock > 0 ? full : 0, 0.01 * full) << static_cast<double>(clock);
      (clock > 0 ? lit : dark) += 1;
    }
  }
  EXPECT_GT(lit, 500);
  EXPECT_GT(dark, 500);
}

}  // namespace
}  // namespace restframe
