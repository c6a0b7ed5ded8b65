// Section 6 of the paper: materials whose colour and transparency change gradually, or as another
// program's results say. What scenes/gradual_color, transparency and data_driven show.

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "support/analytic_spheres.h"
#include "support/shown_scene.h"

namespace restframe {
namespace {

using reference::Long3;

constexpr double pi = std::numbers::pi;

double linear_of(int srgb) {
  const double v = srgb / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

struct ColorKey {
  double time;
  int r, g, b;  // sRGB
};

// The keys of scenes/gradual_color: midnightblue, deepskyblue, gold, crimson, midnightblue.
Vec3 of_keys(double clock) {
  const std::vector<ColorKey> keys = {{0, 25, 25, 112},
                                      {0.8, 0, 191, 255},
                                      {1.1, 255, 215, 0},
                                      {1.5, 220, 20, 60},
                                      {2, 25, 25, 112}};
  const double at = clock - 2 * std::floor(clock / 2);
  std::size_t i = 1;
  while (keys[i].time < at) ++i;
  const double f = (at - keys[i - 1].time) / (keys[i].time - keys[i - 1].time);
  const auto mixed = [&](int from, int to) {
    return (1 - f) * linear_of(from) + f * linear_of(to);
  };
  return {mixed(keys[i - 1].r, keys[i].r), mixed(keys[i - 1].g, keys[i].g),
          mixed(keys[i - 1].b, keys[i].b)};
}

Vec3 of_formula(double clock) {
  const auto wave = [&](double shift) { return 0.5 + 0.5 * std::cos(pi * clock + shift); };
  return {wave(0), wave(-2 * pi / 3), wave(2 * pi / 3)};
}

Vec3 color_at(const ExrPicture& picture, int x, int y) {
  return pixel_at(picture, x, y).color;
}

// All 17 exposures of six spheres: in the middle of each the colour that its clock says, which runs
// twice as fast for the one that comes at 0.6c, half as fast for the one that goes.
TEST(GradualColor, IsThatOfEachClock) {
  const ExrPicture picture =
      shown("gradual_color", with_places(scene_text("gradual_color")), {"480x240", 16, 1})[0];
  const double rows[] = {2.5, 1.6, 0.7, -0.7, -1.6, -2.5};
  const double betas[] = {0.6, 0, -0.6, 0.6, 0, -0.6};
  reference::ObserverCamera camera;
  camera.vertical_fov = 0.974 * pi / 180;
  camera.width = 480;
  camera.height = 240;
  for (int exposure = 0; exposure < 17; ++exposure) {
    const double time = 0.25 * exposure;
    const double yaw = std::atan(0.015) * (1 - time / 2);
    reference::aim(camera, {std::sin(yaw), 0, -std::cos(yaw)});
    for (int row = 0; row < 6; ++row) {
      reference::MovingSphere sphere;
      sphere.gamma_beta = reference::gamma_beta_from_beta({0, 0, betas[row]});
      sphere.center = {0, rows[row], -400};
      sphere.time = -400;
      sphere.radius = 0.3;
      const auto seen = reference::seen_point(sphere, {0, 0, 0.3}, camera, time);
      ASSERT_TRUE(seen.film);
      const int x = static_cast<int>(seen.film->x), y = static_cast<int>(seen.film->y);
      const double doppler = std::sqrt((1 + betas[row]) / (1 - betas[row]));
      EXPECT_NEAR(seen.clock, doppler * time + 0.3, 0.03);  // its front is 0.3 nearer
      const Vec3 expected = row < 3 ? of_keys(seen.clock) : of_formula(seen.clock);
      const Vec3 found = color_at(picture, x, y);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c], expected[c], 0.012)
            << "row " << row << ", exposure " << exposure << ", channel " << c;
      }
    }
  }
}

// scenes/transparency: the balls at rest, whose clocks are the world's time.
struct Ball {
  Long3 center;
};
const std::vector<Ball> balls = {
    {{-6, 0.8L, 0}}, {{-2.6L, 1.9L, 0}}, {{0.8L, 3, 0}}, {{4.2L, 4.1L, 0}}};
constexpr long double ball_radius = 0.8L;

long double clear_part(long double clock) {
  return 0.5L - 0.5L * std::cos(std::numbers::pi_v<long double> * clock / 2);
}

// What the balls leave of the sun's light on its way to an event on the floor, which passes a ball
// earlier; nothing where it grazes one.
std::optional<long double> left_of_sun(const Long3& at, long double time) {
  const Long3 to_sun = reference::normalized({-0.25L, 1, -0.45L});
  long double left = 1;
  for (const Ball& ball : balls) {
    const Long3 to_center = ball.center - at;
    const long double middle = reference::dot(to_center, to_sun);
    const long double aside = reference::length(to_center - middle * to_sun);
    if (std::abs(aside - ball_radius) < 0.01L) return std::nullopt;
    if (aside > ball_radius) continue;
    const long double half = std::sqrt(ball_radius * ball_radius - aside * aside);
    left *= clear_part(time - middle - half) * clear_part(time - middle + half);
  }
  return left;
}

TEST(Transparency, ShadowsFollowAsLateAsLightDoes) {
  std::string text =
      replaced(scene_text("transparency"), "emission = [0.03, 0.012, 0]", "emission = [0, 0, 0]");
  const auto pictures = shown("transparency", with_places(text), {"320x160", 1, 9});
  const Long3 camera{0, 10, 15};
  const double sunlit =
      0.21 * 3 / pi * static_cast<double>(reference::normalized({-0.25L, 1, -0.45L}).y);
  int in_shadow = 0, dark = 0, half_dark = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (const ShownPixel& pixel : pixels_of(pictures[i], 1)) {
      const int column = static_cast<int>(std::floor(pixel.at.x)) + 16;
      const int row = static_cast<int>(std::floor(pixel.at.z)) + 12;
      if ((row + column) % 2 != 0) continue;  // a dark tile
      const long double time =
          18 + 0.5L * static_cast<long double>(i) - reference::length(pixel.at - camera);
      const auto left = left_of_sun(pixel.at, time);
      if (!left) continue;
      const double expected = sunlit * static_cast<double>(*left);
      ASSERT_NEAR(pixel.color.y, expected, 0.01 * expected + 2e-3 * sunlit)
          << "picture " << i << " at " << static_cast<double>(pixel.at.x) << " "
          << static_cast<double>(pixel.at.z);
      in_shadow += *left < 0.99L;
      dark += *left < 0.05L;
      half_dark += *left > 0.2L && *left < 0.8L;
    }
  }
  EXPECT_GT(in_shadow, 1000);
  EXPECT_GT(dark, 100);
  EXPECT_GT(half_dark, 100);
}

// The balls themselves: of their samples, as many stop light as their opacity says at their clock.
// The camera looks closely at the highest, from where it sees black sky behind its upper part.
TEST(Transparency, BallsAreAsClearAsTheirClocksSay) {
  const std::string text = replaced(
      replaced(scene_text("transparency"), "look_at = [0.2, 2, 0.6]", "look_at = [4.2, 4.72, 0.2]"),
      "fov = 31", "fov = 0.2");
  const auto pictures = shown("transparency", with_places(text), {"8x4", 400, 9});
  reference::ObserverCamera camera;
  camera.position = {0, 10, 15};
  camera.vertical_fov = 0.2 * pi / 180;
  camera.width = 8;
  camera.height = 4;
  reference::aim(camera, Vec3(4.2, 4.72, 0.2) - Vec3(0, 10, 15));
  const Long3 eye = reference::widened(camera.position);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    double stopped = 0, expected = 0;
    for (int pixel = 0; pixel < 32; ++pixel) {
      const int x = pixel % 8, y = pixel / 8;
      const Long3 sight = reference::direction_through(camera, {x + 0.5, y + 0.5});
      const long double along = reference::dot(balls[3].center - eye, sight);
      const long double aside = reference::length(balls[3].center - eye - along * sight);
      ASSERT_LT(aside, 0.75L);
      const long double way = along - std::sqrt(ball_radius * ball_radius - aside * aside);
      const long double clear = clear_part(18 + 0.5L * static_cast<long double>(i) - way);
      expected += 1 - static_cast<double>(clear);
      stopped += pictures[i].at("A", x, y);
    }
    EXPECT_NEAR(stopped / 32, expected / 32, 0.02);  // 12800 samples: four standard deviations
  }
}

using Table = std::map<std::string, std::vector<double>>;

// Columns of scenes/data_driven/run.csv.
Table read_table() {
  std::ifstream stream(folder_of_scene("data_driven") / "run.csv");
  Table table;
  std::vector<std::string> names;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::size_t column = 0;
    const bool header = names.empty();
    for (std::string field; std::getline(fields, field, ','); ++column) {
      if (header) {
        names.push_back(field);
      } else {
        table[names[column]].push_back(std::stod(field));
      }
    }
  }
  return table;
}

double interpolated(const Table& table, const std::string& column, double time) {
  const std::vector<double>& t = table.at("t");
  const std::vector<double>& v = table.at(column);
  if (time <= t.front()) return v.front();
  if (time >= t.back()) return v.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), time) - t.begin());
  return v[i - 1] + (v[i] - v[i - 1]) * (time - t[i - 1]) / (t[i] - t[i - 1]);
}

TEST(DataDriven, ColoursAreThoseOfTheTableAtEachClock) {
  const Table table = read_table();
  ASSERT_GT(table.at("t").size(), 200U);
  const auto pictures =
      shown("data_driven", with_places(scene_text("data_driven")), {"320x180", 1, 9});
  int of_balls = 0, of_rods = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (const ShownPixel& pixel : pixels_of(pictures[i], 1)) {
      const Long3& p = pixel.at;
      const double time =
          12 + static_cast<double>(i) - static_cast<double>(reference::length(p - Long3{0, 0, 4}));
      const Long3 center{0.6L * std::round(p.x / 0.6L), 0.6L * std::round(p.y / 0.6L), 0};
      const Long3 from_center = p - center;
      const long double radius = reference::length(from_center);
      const long double from_rod =
          std::min(std::hypot(from_center.x, p.z), std::hypot(from_center.y, p.z));
      const bool ball = radius < 0.2202L;
      if (ball ? from_rod < 0.06L : radius < 0.23L) continue;  // where they meet
      const double value = interpolated(table, ball ? "B" : "heat", time);
      const Vec3 from = ball ? Vec3(0.01, 0.04, 0.5) : Vec3(0.01, 0.01, 0.02);
      const Vec3 to = ball ? Vec3(1, 0.6, 0.02) : Vec3(0.8, 0.02, 0.005);
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(pixel.color[c], from[c] + value * (to[c] - from[c]), 1e-3)
            << "picture " << i << ", clock " << time << (ball ? ", ball" : ", rod");
      }
      (ball ? of_balls : of_rods) += 1;
    }
  }
  EXPECT_GT(of_balls, 100000);
  EXPECT_GT(of_rods, 1000);
}

}  // namespace
}  // namespace restframe
