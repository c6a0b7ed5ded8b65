// Journeys of observers, from rendered pictures: the twin paradox by counting blinks, keys and
// rides by what the headers and layers hold.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "support/animation.h"

namespace restframe {
namespace {

// A clock at rest that blinks five times a second; the camera sees it in its one pixel.
std::string blinking_clock(const std::string& camera, double rate, int pictures) {
  return fmt::format(R"(
[camera]
{}
[animation]
rate = {}
pictures = {}
[render]
resolution = [1, 1]
samples = 1
[output]
layers = ["beauty", "time"]
preview = false
[[object]]
name = "clock"
sphere = {{radius = 0.5, fineness = 3}}
[[material]]
name = "ball"
unlit = true
base_color = {{period = 0.2, intervals = [[0.0, 0.1, "yellow"], [0.1, 0.2, "blue"]]}}
)",
                     camera, rate, pictures);
}

double count_blinks(const std::vector<ExrPicture>& pictures) {
  int changes = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_GT(pictures[i].at("A", 0, 0), 0) << "picture " << i;
    const auto is_yellow = [&](std::size_t p) { return pictures[p].at("R", 0, 0) > 0.5F; };
    changes += i > 0 && is_yellow(i) != is_yellow(i - 1);
  }
  return 0.5 * changes;
}

// Out and back in 4 s of the traveller's clock, at 1 c a second: 4 sinh(1) = 4.70 s at home. The
// light of as many blinks arrives on the way.
TEST(Journey, TheTravellingTwinSeesEveryBlinkOfTheClockAtHome) {
  const std::string camera = R"(position = [0, 0, 2]
track = "clock"
fov = 1
[[camera.leg]]
duration = 1
acceleration = [0, 0, 1]
[[camera.leg]]
duration = 2
acceleration = [0, 0, -1]
[[camera.leg]]
duration = 1
acceleration = [0, 0, 1]
)";
  const int pictures = 241;
  const auto all =
      rendered_animation(RESTFRAME_PROGRAM, blinking_clock(camera, 60, pictures), pictures);
  const double at_home = 4 * std::sinh(1.0);
  EXPECT_NEAR(count_blinks(all), at_home / 0.2, 1);
  EXPECT_GT(at_home / 0.2, 4 / 0.2 + 3) << "the journey tells both clocks apart";
  EXPECT_NEAR(all.back().at("time_proper.V", 0, 0) - all.front().at("time_proper.V", 0, 0), at_home,
              1e-5);
}

// The same journey at a steady speed by keys: 0.75 light-seconds out in 1 s of the camera's clock,
// and back; 1.25 s each way at home.
TEST(Journey, LikewiseByKeys) {
  const std::string camera = R"(track = "clock"
fov = 1
time = 10
[[camera.key]]
time = 0
position = [0, 0, 2]
[[camera.key]]
time = 1
position = [0, 0, 2.75]
[[camera.key]]
time = 2
position = [0, 0, 2]
)";
  const auto all = rendered_animation(RESTFRAME_PROGRAM, blinking_clock(camera, 60, 121), 121);
  EXPECT_NEAR(count_blinks(all), 2.5 / 0.2, 1);
  // Seen through 1.5 light-seconds, from where the sphere's surface is.
  EXPECT_NEAR(all.front().at("time_world.V", 0, 0), 10 - 1.5, 0.01);
  EXPECT_NEAR(all[60].at("time_world.V", 0, 0), 10 + 1.25 - 2.25, 0.01);
  EXPECT_NEAR(all.back().at("time_world.V", 0, 0), 10 + 2.5 - 1.5, 0.01);
  EXPECT_EQ(all[30].attributes.at("cameraVelocity"), "0 0 0.6");
  EXPECT_EQ(all[90].attributes.at("cameraVelocity"), "0 0 -0.6");
}

// Whoever rides a ship sees it at rest, however fast it is: frequencies as emitted, and its clock as
// the camera's own, less the light's way.
TEST(Journey, ARiderSeesItsShipAtRest) {
  const std::string scene = R"(
[camera]
on = "ship"
position = [0, 4, 0]
direction = [0, -1, 0]
up = [0, 0, 1]
fov = 20
[animation]
start = 7
[render]
resolution = [3, 3]
samples = 1
[output]
layers = ["beauty", "time", "doppler", "Z", "P"]
preview = false
[[object]]
name = "ship"
sphere = {fineness = 5}
position = [3, 1, 2]
time = 5
clock = 2.5
rotation = [90, 0, 0]
gamma = 100
direction = [1, 2, 2]
)";
  const ExrPicture picture = rendered_animation(RESTFRAME_PROGRAM, scene, 1)[0];
  EXPECT_NEAR(picture.at("doppler.D", 1, 1), 1, 1e-6);
  EXPECT_NEAR(picture.at("Z", 1, 1), 3, 0.005);
  EXPECT_NEAR(picture.at("time_proper.V", 1, 1), 7 - picture.at("Z", 1, 1), 1e-5);
  // The asset's y axis, turned to z.
  EXPECT_NEAR(picture.at("P.Z", 1, 1), 1, 0.005);
  EXPECT_NEAR(picture.at("P.X", 1, 1), 0, 1e-5);
}

}  // namespace
}  // namespace restframe
