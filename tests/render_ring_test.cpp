// Figure 8 of the paper: on a large sphere at rest that changes its colour everywhere at once, the
// change is seen as a ring that runs outwards, since light from farther points left earlier.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "support/animation.h"

namespace restframe {
namespace {

constexpr int kSize = 201, kPictures = 8;
constexpr double kRadius = 5, kDistance = 7, kHalfPeriod = 1, kStart = 20.05, kRate = 5;
constexpr double kFov = 100;

// The pixel's distance from the middle, in pixels, to the direction's angle from the axis and back.
double film_scale() {
  return 0.5 * kSize / std::tan(0.5 * kFov * std::numbers::pi / 180);
}

// The distance d of what is seen at an angle psi from the axis: d^2 - 2 d L cos(psi) + L^2 - R^2 =
// 0; negative where the sphere is missed.
double distance_at(double pixels) {
  const double cosine = 1 / std::hypot(1.0, pixels / film_scale());
  const double discriminant = kRadius * kRadius - kDistance * kDistance * (1 - cosine * cosine);
  return discriminant < 0 ? -1 : kDistance * cosine - std::sqrt(discriminant);
}

// The radius in pixels of the circle from which light takes `d`.
double ring_radius(double d) {
  const double cosine = (d * d + kDistance * kDistance - kRadius * kRadius) / (2 * d * kDistance);
  return film_scale() * std::sqrt(1 - cosine * cosine) / cosine;
}

std::string scene_text() {
  return fmt::format(R"(
[camera]
position = [0, 0, {}]
direction = [0, 0, -1]
fov = {}
[animation]
start = {}
rate = {}
pictures = {}
[render]
resolution = [{}, {}]
samples = 1
[output]
layers = ["beauty"]
preview = false
[[object]]
sphere = {{radius = {}, fineness = 7}}
[[material]]
name = "ball"
unlit = true
base_color = {{period = {}, intervals = [[0, {}, "yellow"], [{}, {}, "blue"]]}}
)",
                     kDistance, kFov, kStart, kRate, kPictures, kSize, kSize, kRadius,
                     2 * kHalfPeriod, kHalfPeriod, kHalfPeriod, 2 * kHalfPeriod);
}

// In pixels from the middle, along the picture's horizontal and vertical through it: halfway
// between the last pixel before a change of colour and the first after it.
std::vector<double> changes(const ExrPicture& picture, int step_x, int step_y) {
  const int middle = kSize / 2;
  const auto yellow = [&](int i) {
    return picture.at("R", middle + i * step_x, middle + i * step_y) > 0.5F;
  };
  std::vector<double> found;
  for (int i = 1; i <= middle && distance_at(i) > 0; ++i) {
    if (yellow(i) != yellow(i - 1)) found.push_back(i - 0.5);
  }
  return found;
}

std::vector<double> expected_changes(double time) {
  std::vector<double> radii;
  const double nearest = kDistance - kRadius;
  const double farthest = std::sqrt(kDistance * kDistance - kRadius * kRadius);
  for (double n = std::floor((time - nearest) / kHalfPeriod); time - n * kHalfPeriod < farthest;
       --n) {
    radii.push_back(ring_radius(time - n * kHalfPeriod));
  }
  return radii;
}

bool is_near(double radius, const std::vector<double>& radii) {
  return std::any_of(radii.begin(), radii.end(),
                     [radius](double r) { return std::abs(r - radius) <= 0.52; });
}

TEST(Rings, RunOutwardsAsLightIsDelayed) {
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, scene_text(), kPictures);
  const double rim = film_scale() * std::tan(std::asin(kRadius / kDistance));
  int rings = 0;
  for (int i = 0; i < kPictures; ++i) {
    const double time = kStart + i / kRate;
    SCOPED_TRACE(time);
    const std::vector<double> expected = expected_changes(time);
    for (const auto& [x, y] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const std::vector<double> found = changes(pictures[static_cast<std::size_t>(i)], x, y);
      for (const double radius : found) EXPECT_TRUE(is_near(radius, expected)) << radius;
      for (const double radius : expected) {
        if (radius < 1 || radius > rim - 1) continue;
        EXPECT_TRUE(is_near(radius, found)) << radius;
        ++rings;
      }
    }
  }
  EXPECT_GE(rings, 4 * 2 * kPictures);
}

// Every pixel, not only those along four lines.
TEST(Rings, HaveTheColourOfTheirDelayEverywhere) {
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, scene_text(), kPictures);
  int checked = 0, wrong = 0;
  for (int i = 0; i < kPictures; ++i) {
    const double time = kStart + i / kRate;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const double d = distance_at(std::hypot(x - kSize / 2, y - kSize / 2));
        const double phase = (time - d) / kHalfPeriod;
        // A facet is up to 7e-5 radii deep, and more along a grazing ray.
        if (d < 0 || std::abs(phase - std::round(phase)) < 0.01) continue;
        ++checked;
        const bool yellow = static_cast<int>(std::floor(phase)) % 2 == 0;
        wrong += yellow != (pictures[static_cast<std::size_t>(i)].at("R", x, y) > 0.5F);
      }
    }
  }
  EXPECT_GT(checked, 100000);
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace restframe
