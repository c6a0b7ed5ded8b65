// Environments from files: what the camera sees of them, and what they light.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/sky_map.h"
#include "support/boosted_scene.h"
#include "support/exr_writer.h"
#include "support/loaded_scene.h"
#include "support/picture_statistics.h"

namespace restframe {
namespace {

using reference::Long3;

constexpr double pi = std::numbers::pi;

// One object is needed: far away, tiny.
const std::string kSpeck =
    "[[object]]\nsphere = {radius = 1e-6, fineness = 0}\nposition = [1e6, 2e6, 3e6]\n";

std::string sky(const std::string& keys) {
  return "[[light]]\ntype = \"environment\"\nfile = \"sky.exr\"\n" + keys + "\n";
}

// Over the whole sky as closed form 10 has it, for a file of one value.
TEST(SkyFile, OfOneValueBeamsAsClosedForm10) {
  const std::string map = sky_exr(8, 4, [](int, int) { return Vec3f(2); });
  const double beta = 0.7;
  double sum = 0, solid_angle = 0;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    for (const double sign : {1.0, -1.0}) {
      reference::ObserverCamera camera;
      camera.gamma_beta = reference::gamma_beta_from_beta(beta * glm::normalize(Vec3(1, 2, -1)));
      camera.width = camera.height = 24;
      camera.vertical_fov = pi / 2;
      aim(camera, sign * axis, Vec3(axis.z, axis.x, axis.y));
      const Scene scene =
          loaded_scene(camera_text(camera, "samples = 1\nbeaming = true") + kSpeck + sky(""),
                       {{"sky.exr", map}});
      const PixelMeans means = pixel_means(scene, 2);
      for (int i = 0; i < 24 * 24; ++i) {
        const int x = i % 24, y = i / 24;
        const double px = (x + 0.5) / 12 - 1, py = (y + 0.5) / 12 - 1;
        const double weight = std::pow(1 + px * px + py * py, -1.5);
        sum += weight * means.mean[static_cast<std::size_t>(i)];
        solid_angle += weight;
      }
    }
  }
  const double expected = 2 * (1 + beta * beta / 3) / (1 - beta * beta);
  EXPECT_NEAR(sum / solid_angle, expected, 0.01 * expected);
}

// Each of these directions sees its own pixel's colour in the middle of the picture.
Vec3f seen_along(const Vec3& direction, const std::string& keys) {
  const std::string map = sky_exr(
      16, 8, [](int x, int y) { return Vec3f(static_cast<float>(x), static_cast<float>(y), 1); });
  reference::ObserverCamera camera;
  camera.width = camera.height = 1;
  camera.vertical_fov = 1e-3;
  aim(camera, direction, glm::normalize(Vec3(0.1, 0.3, 0.2)));
  const Scene scene =
      loaded_scene(camera_text(camera, "samples = 1") + kSpeck + sky(keys), {{"sky.exr", map}});
  const PixelMeans means = pixel_means(scene, 2, LightSearch::both, "RGB");
  return {static_cast<float>(means.mean[0]), static_cast<float>(means.mean[1]),
          static_cast<float>(means.mean[2])};
}

void expect_pixel(const Vec3f& seen, double x, double y) {
  EXPECT_NEAR(seen.x, x, 0.02);
  EXPECT_NEAR(seen.y, y, 0.02);
}

TEST(SkyFile, IsSeenWhereTheManualSays) {
  const double part = pi / 16;  // of a pixel's half width, in longitude; of latitude likewise
  const Vec3 middle(std::cos(part) * std::cos(part), std::sin(-part),
                    std::cos(part) * std::sin(part));
  expect_pixel(seen_along(middle, ""), 8, 4);  // half a pixel to the right of +X and below it
  const auto turned = [&](double quarter) {
    const double angle = quarter * pi / 2 + part;
    return Vec3(std::cos(part) * std::cos(angle), std::sin(-part),
                std::cos(part) * std::sin(angle));
  };
  expect_pixel(seen_along(turned(1), ""), 12, 4);  // towards +Z: right
  expect_pixel(seen_along(turned(-1), ""), 4, 4);  // towards -Z: left
  expect_pixel(seen_along(turned(-2), ""), 0, 4);
  // Turned by 90 degrees about y: what was along +X lies along -Z.
  expect_pixel(seen_along(turned(-1), "rotation = [0, 90, 0]"), 8, 4);
  // About z by 90: what was along +X lies along +Y.
  const Vec3 up(-middle.y, middle.x, middle.z);
  expect_pixel(seen_along(up, "rotation = [0, 0, 90]"), 8, 4);
}

// A white floor under a sky with a sun of one pixel, at rest and moving: the sum over the map, seen
// from the floor.
struct SunnyFloor {
  SkyMap map;
  Scene scene;
};

SunnyFloor sunny_floor(const Vec3& sky_velocity, double roughness) {
  const auto radiance = [](int x, int y) {
    return x == 21 && y == 5 ? Vec3f(400) : Vec3f(0.2F + 0.05F * static_cast<float>(y));
  };
  SunnyFloor sunny;
  sunny.map = {"", 32, 16, {}};
  for (int i = 0; i < 32 * 16; ++i) sunny.map.pixels.push_back(radiance(i % 32, i / 32));
  reference::ObserverCamera camera;
  camera.position = {0, 3, 0};
  camera.width = 4;
  camera.height = 3;
  camera.vertical_fov = 0.2;
  aim(camera, {0, -1, 0}, {0, 0, -1});
  sunny.scene = loaded_scene(
      camera_text(camera, "samples = 64\ndepth = 1\nbeaming = true") +
          "[[object]]\nname = \"floor\"\nasset = \"floor.obj\"\nmaterial = \"floor\"\n" +
          diffuse_material("floor", 0.6) + sky("velocity = " + toml(sky_velocity)),
      {{"floor.obj", quad_obj({0, 0, 0}, {4, 0, 0}, {0, 0, -4})},
       {"sky.exr", sky_exr(32, 16, radiance)}});
  material_of(sunny.scene, "floor").roughness.value = static_cast<float>(roughness);
  return sunny;
}

double floor_radiance(const SkyMap& map, const Vec3& sky_velocity) {
  const Long3 u = reference::widened(reference::gamma_beta_from_beta(sky_velocity));
  constexpr int rows = 800, columns = 1600;
  double sum = 0;
  for (int i = 0; i < rows; ++i) {
    const double theta = pi / 2 * (i + 0.5) / rows;
    for (int j = 0; j < columns; ++j) {
      const double phi = 2 * pi * (j + 0.5) / columns;
      const Vec3 e(std::sin(theta) * std::cos(phi), std::cos(theta),
                   std::sin(theta) * std::sin(phi));
      const auto d = static_cast<double>(1 / frequency_seen_from(u, reference::widened(e)));
      const Vec3 there = reference::narrowed(normalized(boosted(u, {-1, reference::widened(e)}).x));
      const double radiance = static_cast<double>(radiance_at(map, sky_place(map, there)).y);
      sum += radiance * d * d * d * d * std::cos(theta) * std::sin(theta);
    }
  }
  return 0.6 / pi * sum * (pi / 2 / rows) * (2 * pi / columns);
}

TEST(SkyFile, LightsAFloor) {
  for (const Vec3& velocity : {Vec3(0, 0, 0), Vec3(0.4, 0, 0.2), Vec3(0, -0.8, 0)}) {
    SCOPED_TRACE(velocity.y);
    const SunnyFloor sunny = sunny_floor(velocity, 1);
    const double expected = floor_radiance(sunny.map, velocity);
    for (const LightSearch search : {LightSearch::both, LightSearch::by_choice}) {
      const PixelMeans means = pixel_means(sunny.scene, 24, search);
      expect_mean(means, expected, 2e-3);
      // The sun is found: noise is far below that of chance.
      for (const double error : means.error) EXPECT_LT(error, 0.02 * expected);
    }
    expect_mean(pixel_means(sunny.scene, 40, LightSearch::by_chance), expected, 2e-3);
  }
}

// A map that moves and is turned, a lamp and two reflecting bodies of different velocities that light
// each other, boosted with their camera: statistically the same pictures (closed form 11).
const std::string kMutual = R"toml(
[camera]
position = [0.4, 0.7, 4]
time = 0.5
velocity = [0.2, -0.1, -0.3]
direction = [0, -0.1, -1]
up = [0.1, 1, 0]
fov = 50
[animation]
start = 0.7
[output]
layers = ["beauty"]
preview = false
[render]
resolution = [24, 18]
samples = 8
depth = 4
integrator = "path"
beaming = true
[[object]]
name = "left"
sphere = {radius = 1, fineness = 4}
position = [-1.1, 0.2, -0.4]
velocity = [0.2, 0.1, 0.3]
material = "red"
[[object]]
name = "right"
sphere = {radius = 1, fineness = 4}
position = [1.2, 0, -0.2]
velocity = [-0.3, 0.2, 0]
material = "lamp"
[[material]]
name = "red"
base_color = [0.8, 0.7, 0.6]
metallic = 0
roughness = 0.6
emission = [0.1, 0.2, 0.1]
[[material]]
name = "lamp"
base_color = [0.5, 0.6, 0.7]
metallic = 0.4
roughness = 0.4
emission = {formula = "0.5 + 0.5 * sin(4 * t)", from = [1, 2, 1], to = [2, 3, 4]}
[[light]]
type = "environment"
file = "sky.exr"
velocity = [0.4, 0.2, 0]
rotation = [20, 30, 40]
intensity = 0.3
)toml";

TEST(MutualLight, IsTheSameInEveryWorld) {
  const Scene scene = loaded_scene(kMutual, {{"sky.exr", sky_exr(16, 8, [](int x, int y) {
                                                return x == 3 && y == 2 ? Vec3f(40) : Vec3f(0.5F);
                                              })}});
  const PixelMeans here = block_means(scene, 24, 2);
  for (const double mean : here.mean) EXPECT_GT(mean, 0.01);
  for (const Velocity& world :
       {Velocity::from_beta({0.6, 0, 0}), Velocity::from_beta({-0.5, 0.6, 0.4}),
        Velocity::from_gamma(30, {1, 2, -2})}) {
    SCOPED_TRACE(world.gamma());
    expect_equal_means(block_means(boosted(scene, world), 24, 2), here);
  }
}

}  // namespace
}  // namespace restframe
