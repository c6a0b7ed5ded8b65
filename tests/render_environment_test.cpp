// An environment of radiance 1: beaming over the whole sky (closed form 10), and furnaces, in which
// whatever absorbs nothing is as bright as what is behind it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/path_scene.h"

namespace restframe {
namespace {

using reference::Long3;

// One object is needed: far away, tiny.
const std::string kSpeck =
    "[[object]]\nsphere = {radius = 1e-6, fineness = 0}\nposition = [1e6, 2e6, 3e6]\n";

std::string environment(const Vec3& velocity) {
  return fmt::format("[[light]]\ntype = \"environment\"\nvelocity = {}\n", toml(velocity));
}

// Weighted by solid angle.
struct SkyMean {
  double sum = 0, solid_angle = 0;
};

// One face of a cube around the camera; every pixel is checked.
void add_face(const reference::ObserverCamera& camera, const Vec3& sky_velocity, SkyMean& mean) {
  const ExrPicture picture = path_pictures(
      camera_text(camera, "samples = 1\nbeaming = true") + kSpeck + environment(sky_velocity),
      {})[0];
  const Long3 u = reference::widened(reference::gamma_beta_from_beta(sky_velocity));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto sight = world_sight(camera, direction_through(camera, {x + 0.5, y + 0.5}));
      const long double d = 1 / (sight.frequency * frequency_seen_from(u, sight.direction));
      const double right = static_cast<double>(d * d * d * d);
      const double value = static_cast<double>(picture.at("G", x, y));
      EXPECT_NEAR(value, right, 1e-5 * right);
      const double px = (x + 0.5) * 2 / picture.width - 1, py = (y + 0.5) * 2 / picture.width - 1;
      const double solid_angle = std::pow(1 + px * px + py * py, -1.5);
      mean.sum += solid_angle * value;
      mean.solid_angle += solid_angle;
    }
  }
}

double mean_over_sky(const Vec3& camera_velocity, const Vec3& sky_velocity) {
  SkyMean mean;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    for (const double sign : {1.0, -1.0}) {
      reference::ObserverCamera camera;
      camera.gamma_beta = reference::gamma_beta_from_beta(camera_velocity);
      camera.width = camera.height = 24;
      camera.vertical_fov = std::numbers::pi / 2;
      aim(camera, sign * axis, Vec3(axis.z, axis.x, axis.y));
      add_face(camera, sky_velocity, mean);
    }
  }
  return mean.sum / mean.solid_angle;
}

TEST(Environment, BeamsAsClosedForm10) {
  for (const double beta : {0.0, 0.6, 0.8}) {
    const double mean = (1 + beta * beta / 3) / (1 - beta * beta);
    EXPECT_NEAR(mean_over_sky(beta * glm::normalize(Vec3(0.3, -1, 0.5)), {0, 0, 0}), mean,
                0.01 * mean);
  }
}

// Of the camera's velocity and the sky's only their difference matters.
TEST(Environment, MayMove) {
  EXPECT_NEAR(mean_over_sky({0, 0.6, 0}, {0, 0.6, 0}), 1, 1e-5);
  const double mean = (1 + 0.36 / 3) / 0.64;
  EXPECT_NEAR(mean_over_sky({0, 0, 0}, {0.6, 0, 0}), mean, 0.01 * mean);
}

struct Furnace {
  double mean = 0, least = 1e9, largest = 0;
};

// A sphere that fills most of the picture, in a furnace of radiance 1 that rests in the world.
Furnace furnace(const Vec3& velocity, const std::string& material, int depth) {
  reference::ObserverCamera camera;
  camera.position = {0, 0, 3};
  camera.width = camera.height = 30;
  camera.vertical_fov = 0.5;
  const std::string text =
      camera_text(camera, fmt::format("samples = 64\ndepth = {}", depth)) +
      fmt::format(
          "[[object]]\nname = \"ball\"\nsphere = {{radius = 1, fineness = 6}}\nvelocity = "
          "{}\ntime = -2\nmaterial = \"ball\"\n[[material]]\nname = \"ball\"\nbase_color = "
          "\"white\"\n{}\n",
          toml(velocity), material) +
      environment({0, 0, 0});
  const ExrPicture picture = path_pictures(text, {})[0];
  Furnace result;
  int count = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at("id_object.V", x, y) != 1) continue;
      const double value = static_cast<double>(picture.at("G", x, y));
      result.mean += value;
      result.least = std::min(result.least, value);
      result.largest = std::max(result.largest, value);
      ++count;
    }
  }
  EXPECT_GT(count, 300);
  result.mean /= count;
  return result;
}

const std::vector<Vec3> kVelocities = {{0, 0, 0}, {0, 0, 0.5}, {0.05, 0, -0.9}};

// Each path of a convex white sphere ends in the environment with weight 1, but for a few that graze
// facets from below.
TEST(Furnace, WhiteDiffuseSphereVanishes) {
  for (const Vec3& velocity : kVelocities) {
    const Furnace f = furnace(velocity, "metallic = 0\nior = 1", 8);
    EXPECT_NEAR(f.mean, 1, 2e-3) << velocity.z;
    EXPECT_GT(f.least, 0.9);
    EXPECT_LE(f.largest, 1.001);
  }
}

TEST(Furnace, WhiteMirrorVanishes) {
  for (const Vec3& velocity : kVelocities) {
    const Furnace f = furnace(velocity, "roughness = 0", 8);
    EXPECT_NEAR(f.mean, 1, 1e-3) << velocity.z;
    EXPECT_LE(f.largest, 1.001);
  }
}

TEST(Furnace, ClearGlassVanishes) {
  for (const Vec3& velocity : kVelocities) {
    const Furnace f =
        furnace(velocity, "metallic = 0\nroughness = 0\ntransmission = 1\nior = 1.5", 64);
    EXPECT_NEAR(f.mean, 1, 5e-3) << velocity.z;
  }
}

// White below a gloss: nothing is gained, and only rough gloss loses a little, between its facets.
TEST(Furnace, GlossOverWhiteGainsNothing) {
  for (const double roughness : {0.0, 0.4, 1.0}) {
    const Furnace f = furnace({0, 0, 0}, fmt::format("metallic = 0\nroughness = {}", roughness), 8);
    EXPECT_LE(f.mean, 1.002) << roughness;
    EXPECT_GT(f.mean, 0.95) << roughness;
  }
}

}  // namespace
}  // namespace restframe
