// Figure 7 of the paper: spheres that blink once a second of their own clock, counted from
// animations. Closed forms 7 and 8: a clock of period T is seen with period T/D.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <numbers>

#include "support/animation.h"

namespace restframe {
namespace {

struct Film {
  double rate = 100;  // pictures a second of the camera's clock
  int pictures = 120;
  int width = 1;        // pixels, in one row
  double pixel = 1e-4;  // radians
};

std::string blinking_sphere(const std::string& motion, const std::string& camera,
                            const Film& film) {
  return fmt::format(R"(
[camera]
position = [0, 0, 0]
fov = {}
{}
[animation]
rate = {}
pictures = {}
[render]
resolution = [{}, 1]
samples = 1
[output]
layers = ["beauty", "doppler", "id"]
preview = false
[[object]]
{}
[[material]]
name = "ball"
unlit = true
base_color = {{period = 1.0, intervals = [[0.0, 0.5, "yellow"], [0.5, 1.0, "blue"]]}}
)",
                     film.pixel * 180 / std::numbers::pi, camera, film.rate, film.pictures,
                     film.width, motion);
}

// The middle of the pixels that see the sphere.
int sphere_pixel(const ExrPicture& picture) {
  int first = -1, last = -1;
  for (int x = 0; x < picture.width; ++x) {
    if (picture.at("id_object.V", x, 0) == 0) continue;
    if (first < 0) first = x;
    last = x;
  }
  EXPECT_GE(first, 0) << "the sphere is not seen";
  return std::max(0, (first + last) / 2);
}

// Half the number of changes between yellow and blue.
double count_blinks(const std::vector<ExrPicture>& pictures) {
  int changes = 0;
  bool was_yellow = false;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int x = sphere_pixel(pictures[i]);
    const bool yellow = pictures[i].at("R", x, 0) > 0.5F;
    EXPECT_NE(yellow, pictures[i].at("B", x, 0) > 0.5F) << "picture " << i;
    changes += i > 0 && yellow != was_yellow;
    was_yellow = yellow;
  }
  return 0.5 * changes;
}

// Blinks a second, within one blink of the whole film.
void expect_rate(const std::string& motion, const std::string& camera, const Film& film,
                 double expected) {
  const std::string scene = blinking_sphere(motion, camera, film);
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, scene, film.pictures);
  const double seconds = (film.pictures - 1) / film.rate;
  EXPECT_NEAR(count_blinks(pictures), expected * seconds, 1);
  for (const ExrPicture& picture : {pictures.front(), pictures.back()}) {
    EXPECT_NEAR(picture.at("doppler.D", sphere_pixel(picture), 0), expected, 0.003 * expected);
  }
}

const std::string kLarge = "sphere = {radius = 20, fineness = 4}\n";
const std::string kForwards = "direction = [0, 0, -1]";

TEST(Blinking, ApproachingAt099) {
  expect_rate(kLarge + "position = [0, 0, -100]\nvelocity = [0, 0, 0.99]", kForwards, {}, 14.1067);
}

TEST(Blinking, ApproachingAt09) {
  expect_rate(kLarge + "position = [0, 0, -100]\nvelocity = [0, 0, 0.9]", kForwards, {40, 100},
              4.3589);
}

TEST(Blinking, RecedingAt09) {
  expect_rate(kLarge + "position = [0, 0, -100]\nvelocity = [0, 0, -0.9]", kForwards, {4, 80},
              1 / 4.3589);
}

// It passes so far off that it stays sideways all the time: time dilation alone. A small one, since
// its clock's pace is that of one of its points, not that of one direction.
TEST(Blinking, SidewaysAt06) {
  expect_rate(
      "sphere = {radius = 0.05, fineness = 4}\nposition = [0, 0, -1000]\ntime = "
      "-995\nvelocity = [0.6, 0, 0]",
      kForwards, {10, 100, 801, 1e-5}, 0.8);
}

TEST(Blinking, SidewaysAt099) {
  expect_rate(
      "sphere = {radius = 0.2, fineness = 4}\nposition = [0, 0, -10000]\ntime = "
      "-9985\nvelocity = [0.99, 0, 0]",
      kForwards, {3, 90, 1801, 2e-6}, std::sqrt(1 - 0.99 * 0.99));
}

// The same as if the sphere came: only the relative velocity counts.
TEST(Blinking, SeenByACameraThatFliesAt099) {
  expect_rate(kLarge + "position = [0, 0, -400]", kForwards + "\nvelocity = [0, 0, -0.99]", {},
              14.1067);
}

}  // namespace
}  // namespace restframe
