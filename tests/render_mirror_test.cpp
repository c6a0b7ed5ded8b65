// Closed form 9 on pictures: a lamp in a mirror that moves along its normal, its place, its shifted
// light and its clock.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/path_scene.h"
#include "support/retarded_light.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;

constexpr double kRadius = 0.12;
const Vec3 kCamera(0, 0, 4), kLamp(0.9, -0.6, 6);
constexpr int kSize = 80;

// What the camera sees in the mirror z = beta t when its clock shows `time`.
struct Reflection {
  Long3 sight;              // unit, from the camera
  long double shift = 1;    // frequency seen over emitted
  long double emitted = 0;  // world time of the light's emission
};

// In the mirror's rest frame the lamp's image is its mirror image: in the world it moves at
// 2 beta / (1 + beta^2), and closed form 1 says where it is seen. Closed form 9 must hold of that.
Reflection reflection(double beta, double time) {
  const long double b = beta, speed = 2 * b / (1 + b * b);
  const long double z = -kLamp.z * (1 - b * b) / (1 + b * b);  // the image at time 0
  const long double gamma = (1 + b * b) / (1 - b * b);
  const reference::MovingLight image{{0, 0, gamma * speed}, {kLamp.x, kLamp.y, z}, 0, 0};
  const reference::SeenLight seen =
      reference::seen(image, {time, reference::widened(kCamera)}, {0, 0, 0});
  const long double s = (kCamera.z - b * time) / (-seen.sight.z - b);  // to the mirror
  const Long3 met = reference::widened(kCamera) + s * seen.sight;
  const Long3 way = met - reference::widened(kLamp);
  const long double cos_i = way.z / length(way), cos_r = -seen.sight.z;
  const long double shift = (1 - 2 * b * cos_i + b * b) / (1 - b * b);
  EXPECT_NEAR(static_cast<double>(cos_r),
              static_cast<double>(-((1 + b * b) * cos_i - 2 * b) / (1 - 2 * b * cos_i + b * b)),
              1e-12);
  return {seen.sight, shift, time - s - length(way)};
}

// The lamp's light: its clock plus 30 in red, 1 in green.
std::string scene_text(double beta, const reference::ObserverCamera& camera,
                       const std::string& mirror) {
  return camera_text(camera, "samples = 32\nbeaming = true\ndepth = 1") +
         fmt::format(R"(
[animation]
rate = 2
pictures = 3
[[object]]
name = "mirror"
asset = "{}"
velocity = [0, 0, {}]
material = "silver"
[[object]]
name = "lamp"
sphere = {{radius = {}, fineness = 3}}
position = {}
material = "lamp"
[[material]]
name = "silver"
base_color = "white"
metallic = 1
roughness = 0
[[material]]
name = "lamp"
base_color = "black"
unlit = true
emission = {{formula = ["t + 30", "1", "1"]}}
)",
                     mirror, beta, kRadius, toml(kLamp));
}

struct Spot {
  double red = 0, green = 0, x = 0, y = 0, lit = 0;
};

Spot spot_in(const ExrPicture& picture) {
  Spot spot;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double green = static_cast<double>(picture.at("G", x, y));
      spot.red += static_cast<double>(picture.at("R", x, y));
      spot.green += green;
      spot.x += green * (x + 0.5);
      spot.y += green * (y + 0.5);
    }
  }
  spot.x /= spot.green;
  spot.y /= spot.green;
  return spot;
}

// Turned to where the reflection is at the second picture, so that it fills some pixels.
reference::ObserverCamera camera_for(double beta) {
  reference::ObserverCamera camera;
  camera.position = kCamera;
  camera.width = camera.height = kSize;
  const Long3 first = reflection(beta, 0).sight, last = reflection(beta, 1).sight;
  const long double spread = angle_between(first, last);
  aim(camera, reference::narrowed(normalized(first + last)));
  camera.vertical_fov = std::max(0.12, 3.0 * static_cast<double>(spread));
  return camera;
}

void expect_reflection(double beta, const AssetFile& mirror) {
  const reference::ObserverCamera camera = camera_for(beta);
  const auto pictures = path_pictures(scene_text(beta, camera, mirror.name), {mirror}, 3);
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(fmt::format("beta {} picture {}", beta, i));
    const Reflection expected = reflection(beta, 0.5 * i);
    const auto film = film_point(camera, expected.sight);
    ASSERT_TRUE(film);
    const Spot spot = spot_in(pictures[static_cast<std::size_t>(i)]);
    ASSERT_GT(spot.green, 0);
    EXPECT_NEAR(spot.x, film->x, 0.25);
    EXPECT_NEAR(spot.y, film->y, 0.25);
    // Seen of a sphere is, on the average over its disc, what is two thirds of its radius before
    // its centre.
    EXPECT_NEAR(spot.red / spot.green - 30, static_cast<double>(expected.emitted) + kRadius * 2 / 3,
                0.01);
    const auto& green = pictures[static_cast<std::size_t>(i)].channel("G");
    const double brightest = static_cast<double>(*std::max_element(green.begin(), green.end()));
    const double shift = static_cast<double>(expected.shift);
    if (std::count_if(green.begin(), green.end(), [](float g) { return g > 0; }) > 20) {
      EXPECT_NEAR(brightest, std::pow(shift, 4), 0.02 * std::pow(shift, 4));
    }
  }
}

const AssetFile kQuad = {"mirror.obj", quad_obj({0, 0, 0}, {40, 0, 0}, {0, 40, 0})};

TEST(MovingMirror, ReflectsByClosedForm9) {
  for (const double beta : {0.0, 0.3, 0.6, -0.3, -0.6}) expect_reflection(beta, kQuad);
}

TEST(MovingMirror, ReflectsByClosedForm9Fast) {
  for (const double beta : {0.7, -0.8}) expect_reflection(beta, kQuad);
}

// The clock's rate in the mirror is the shift: closed form 8 with D = nu' / nu.
TEST(MovingMirror, ShowsClocksAtTheShiftedRate) {
  for (const double beta : {0.5, -0.5, 0.8}) {
    constexpr double h = 1e-4;
    const long double rate =
        (reflection(beta, 0.5 + h).emitted - reflection(beta, 0.5 - h).emitted) / (2 * h);
    EXPECT_NEAR(static_cast<double>(rate / reflection(beta, 0.5).shift), 1, 1e-6) << beta;
  }
}

}  // namespace
}  // namespace restframe
