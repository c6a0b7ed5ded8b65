// Furnaces: where everything has one radiance, each pixel must have it. Each is tested by its z-score.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/exr_writer.h"
#include "support/loaded_scene.h"
#include "support/picture_statistics.h"

namespace restframe {
namespace {

using reference::Long3;

constexpr double pi = std::numbers::pi;

reference::ObserverCamera small_camera(const Vec3& velocity = {0, 0, 0}) {
  reference::ObserverCamera camera;
  camera.position = {0.3, 0.2, 3};
  camera.gamma_beta = reference::gamma_beta_from_beta(velocity);
  camera.width = 12;
  camera.height = 9;
  camera.vertical_fov = 0.9;
  return camera;
}

std::string glowing(const std::string& name, double grey, const std::string& emission) {
  return diffuse_material(name, grey) + emission + "\n";
}

// A room that emits 1.5 and reflects `grey`, and a block in it that does likewise. Flat: where normals
// are interpolated a little light is lost.
Scene closed(const Vec3& room, const Vec3& block, const Vec3& camera, double grey, int depth,
             const std::string& render_keys) {
  const std::string emission = "emission = [1.5, 1.5, 1.5]";
  Scene scene = loaded_scene(
      camera_text(small_camera(camera),
                  fmt::format("samples = 32\ndepth = {}\n{}", depth, render_keys)) +
          fmt::format(
              "[[object]]\nname = \"room\"\nasset = \"room.obj\"\nvelocity = {}\nmaterial = "
              "\"room\"\n[[object]]\nname = \"block\"\nasset = \"block.obj\"\nvelocity = {}\n"
              "time = -3\nmaterial = \"glow\"\n",
              toml(room), toml(block)) +
          glowing("room", grey, emission) + glowing("glow", grey, emission),
      {{"room.obj", box_obj({-30, -25, -40}, {35, 40, 30})},
       {"block.obj", box_obj({-0.8, -0.7, -1}, {0.9, 0.6, 0.5})}});
  material_of(scene, "room").double_sided = true;
  return scene;
}

// Each surface met adds 1.5 times what the ones before have left, up to the depth.
double closed_radiance(double grey, int depth) {
  return 1.5 * (1 - std::pow(grey, depth + 1)) / (1 - grey);
}

TEST(ClosedFurnace, AtRestIsTheSeries) {
  for (const auto& [grey, depth] : {std::pair{0.5, 3}, {0.8, 1}, {0.5, 12}, {0.9, 20}}) {
    SCOPED_TRACE(grey);
    const Scene scene = closed({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, grey, depth, "");
    expect_mean(pixel_means(scene, 24), closed_radiance(grey, depth), 2e-4);
  }
}

// Without beaming radiance is a number that velocities leave alone.
TEST(ClosedFurnace, OfMovingThingsIsTheSeriesWithoutBeaming) {
  const Scene scene = closed({0, 0, 0}, {0.2, 0.1, 0.7}, {0.3, 0, -0.3}, 0.5, 4, "");
  expect_mean(pixel_means(scene, 24), closed_radiance(0.5, 4), 5e-4);
}

// All moves together past the camera: D^4 of each pixel's sight.
TEST(ClosedFurnace, InMotionBeamsAsOne) {
  const Vec3 velocity(0.3, 0.1, -0.6);
  Scene scene = closed(velocity, velocity, {0.1, 0, 0.2}, 0.6, 5, "beaming = true");
  reference::ObserverCamera camera = small_camera({0.1, 0, 0.2});
  scene.camera.vertical_fov = camera.vertical_fov = 0.05;
  const Long3 u = reference::widened(reference::gamma_beta_from_beta(velocity));
  std::vector<double> expected;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto sight = world_sight(camera, direction_through(camera, {x + 0.5, y + 0.5}));
      const auto d =
          static_cast<double>(1 / (sight.frequency * frequency_seen_from(u, sight.direction)));
      expected.push_back(closed_radiance(0.6, 5) * d * d * d * d);
    }
  }
  expect_means(pixel_means(scene, 24), expected, 4e-3);
}

// A floor that moves through a sky of radiance 1, with its camera: what it reflects is its own
// integral of D^4, by a sum over the hemisphere.
double reflected(const Vec3& beta, const Vec3& normal, double grey) {
  const Vec3 u = reference::gamma_beta_from_beta(beta);
  const double gamma = std::sqrt(1 + glm::dot(u, u));
  constexpr int rows = 800, columns = 1600;
  double sum = 0;
  for (int i = 0; i < rows; ++i) {
    const double z = (2 * i + 1.0) / rows - 1, r = std::sqrt(1 - z * z);
    for (int j = 0; j < columns; ++j) {
      const double phi = 2 * pi * (j + 0.5) / columns;
      const Vec3 e(r * std::cos(phi), r * std::sin(phi), z);
      const double cosine = glm::dot(e, normal);
      if (cosine <= 0) continue;
      // The sky moves with -beta here.
      const double d = 1 / (gamma - glm::dot(u, e));
      sum += cosine * d * d * d * d;
    }
  }
  return grey / pi * sum * 4 * pi / (rows * columns);
}

Scene open(const Vec3& velocity, const std::string& sky, const std::string& file) {
  const reference::ObserverCamera camera = small_camera(velocity);
  std::vector<AssetFile> files = {{"floor.obj", quad_obj({0, 0, 0}, {40, 0, 0}, {0, 40, 0})}};
  if (!file.empty()) files.push_back({"sky.exr", file});
  return loaded_scene(
      camera_text(camera, "samples = 16\ndepth = 3\nbeaming = true") +
          fmt::format(
              "[[object]]\nname = \"floor\"\nasset = \"floor.obj\"\nvelocity = {}\nmaterial "
              "= \"floor\"\n[[light]]\ntype = \"environment\"\n{}\n",
              toml(velocity), sky) +
          diffuse_material("floor", 0.8),
      files);
}

// The sky is one radiance, stated or as a map of it.
TEST(OpenFurnace, OfAMovingFloorIsItsIntegralOfBeaming) {
  const std::string map = sky_exr(8, 4, [](int, int) { return Vec3f(1); });
  for (const Vec3& velocity : {Vec3(0, 0, 0), Vec3(0, 0, 0.6), Vec3(0.5, 0.3, -0.6)}) {
    SCOPED_TRACE(velocity.z);
    const double expected = reflected(velocity, {0, 0, 1}, 0.8);
    expect_mean(pixel_means(open(velocity, "", ""), 24), expected, 1e-3);
    expect_mean(pixel_means(open(velocity, "file = \"sky.exr\"", map), 24), expected, 1e-3);
  }
  EXPECT_NEAR(reflected({0, 0, 0}, {0, 0, 1}, 0.8), 0.8, 1e-4);
}

}  // namespace
}  // namespace restframe
