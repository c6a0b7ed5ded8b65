// The same scene a million light-seconds away and a million seconds later gives the same picture.

#include <gtest/gtest.h>

#include "support/sphere_scene.h"

namespace restframe {
namespace {

using reference::MovingSphere;

constexpr double kFar = 1e6;

// Blinks of 0.1 to 0.5 s, so that every sphere shows edges between colours.
constexpr const char* kBlink = R"(
[[material]]
name = "ball"
unlit = true
base_color = {period = 0.5, intervals = [[0.0, 0.1, "yellow"], [0.1, 0.25, "blue"], [0.25, 0.5, "red"]]}
)";

void add_sphere(SphereScene& scene, double gamma, const Vec3& direction, const Vec3& sight,
                double distance, double radius) {
  MovingSphere sphere;
  sphere.radius = radius;
  sphere.clock = 0.1 * static_cast<double>(scene.spheres.size());
  sphere.gamma_beta = reference::gamma_beta_from_gamma(gamma, direction);
  place_in_sight(sphere, scene.camera, scene.start, sight, distance);
  scene.spheres.push_back(sphere);
}

SphereScene near_scene(const Vec3& camera_velocity) {
  SphereScene scene;
  scene.start = 0.75;
  reference::ObserverCamera& camera = scene.camera;
  camera.width = 160;
  camera.height = 120;
  camera.position = {0.3, -0.2, 0.7};
  camera.gamma_beta = reference::gamma_beta_from_beta(camera_velocity);
  add_sphere(scene, 1, {0, 0, 1}, {-0.3, 0.25, -1}, 6, 1);
  add_sphere(scene, 2.3, {0, 0.6, 0.8}, {0.4, 0.25, -1}, 8, 1.5);
  add_sphere(scene, 7.1, {1, 0, -0.1}, {0.3, -0.3, -1}, 5, 1);
  add_sphere(scene, 1000, {0, 0, -1}, {-0.4, -0.3, -1}, 5, 1.2);
  add_sphere(scene, 1000, {1, 0.2, 0.3}, {0, 0, -1}, 40, 0.5);
  scene.more = kBlink;
  return scene;
}

// Written elsewhere and elsewhen; `later` also lets the camera's clock run that long, which takes a
// moving camera along.
SphereScene moved(SphereScene scene, const Vec3& by, double time, double later) {
  reference::ObserverCamera& camera = scene.camera;
  const reference::Long4 before = camera_event(camera, 0), after = camera_event(camera, later);
  const Vec3 carried = reference::narrowed(after.x - before.x);
  for (MovingSphere& sphere : scene.spheres) {
    sphere.center += by + carried;
    sphere.time += time + static_cast<double>(after.t - before.t);
  }
  camera.position += by;
  camera.time += time;
  scene.start += later;
  return scene;
}

// The pixel or one beside it shows something else than its neighbours: an edge is near.
bool on_an_edge(const ExrPicture& picture, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int nx = std::clamp(x + dx, 0, picture.width - 1);
      const int ny = std::clamp(y + dy, 0, picture.height - 1);
      for (const char* name : {"id_object.V", "R", "G", "B"}) {
        if (picture.at(name, x, y) != picture.at(name, nx, ny)) return true;
      }
    }
  }
  return false;
}

// `delay`: how much later the world's time is in the second picture.
void expect_same(const ExrPicture& a, const ExrPicture& b, double delay) {
  const auto [proper_a, world_a] = time_origins(a);
  const auto [proper_b, world_b] = time_origins(b);
  int hits = 0, different = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      bool same = true;
      for (const char* name : {"id_object.V", "R", "G", "B", "A"}) {
        same = same && a.at(name, x, y) == b.at(name, x, y);
      }
      different += !same;
      EXPECT_TRUE(same || on_an_edge(a, x, y)) << x << ", " << y;
      if (!same || a.at("id_object.V", x, y) == 0) continue;
      ++hits;
      const double distance = a.at("Z", x, y);
      const double tolerance = 2e-5 * (1 + distance);
      ASSERT_NEAR(b.at("Z", x, y), distance, tolerance);
      ASSERT_NEAR(b.at("time_world.V", x, y) + world_b - delay,
                  a.at("time_world.V", x, y) + world_a, tolerance);
      ASSERT_NEAR(b.at("time_proper.V", x, y) + proper_b, a.at("time_proper.V", x, y) + proper_a,
                  tolerance);
      ASSERT_NEAR(b.at("doppler.D", x, y) / a.at("doppler.D", x, y), 1, 1e-6);
    }
  }
  EXPECT_GT(hits, a.width * a.height / 5);
  EXPECT_LE(different, std::max(1, a.width * a.height / 10000));
}

void expect_same_when_moved(const Vec3& camera_velocity, const Vec3& by, double time,
                            double later) {
  const SphereScene scene = near_scene(camera_velocity);
  const SphereScene far = moved(scene, by, time, later);
  const double gamma = std::hypot(1.0, glm::length(scene.camera.gamma_beta));
  expect_same(rendered(RESTFRAME_PROGRAM, scene_file(scene)),
              rendered(RESTFRAME_PROGRAM, scene_file(far)), time + gamma * later);
}

TEST(FarAway, AMillionLightSecondsAway) {
  expect_same_when_moved({0, 0, 0}, {kFar, 0, 0}, 0, 0);
}

TEST(FarAway, AMillionSecondsLater) {
  expect_same_when_moved({0, 0, 0}, {0, 0, 0}, kFar, 0);
}

TEST(FarAway, BothWithAMovingCamera) {
  expect_same_when_moved({0.3, -0.1, -0.5}, {kFar, -kFar, 0.5 * kFar}, kFar, 0);
}

TEST(FarAway, TheCamerasClockRunsForAMillionSeconds) {
  expect_same_when_moved({0, 0, 0}, {0, 0, 0}, 0, kFar);
  expect_same_when_moved({0.3, -0.1, -0.5}, {0, 0, 0}, 0, kFar);
}

// Colours must still change within a hundredth of a second: their edges are found again.
TEST(FarAway, TheTimeChannelsKeepBlinkPhases) {
  const SphereScene scene = moved(near_scene({0, 0, 0}), {kFar, 0, 0}, kFar, 0);
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  const auto [proper, world] = time_origins(picture);
  EXPECT_EQ(world, std::floor(world));
  EXPECT_GT(world, kFar - 1000);
  int checked = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at("id_object.V", x, y) == 0) continue;
      const double phase = std::fmod(picture.at("time_proper.V", x, y) + proper + 1000, 0.5);
      const auto far_from = [&](double edge) { return std::abs(phase - edge) > 1e-4; };
      if (!(far_from(0) && far_from(0.1) && far_from(0.25) && far_from(0.5))) continue;
      ++checked;
      ASSERT_EQ(picture.at("B", x, y) > 0.5F, phase > 0.1 && phase < 0.25);
      ASSERT_EQ(picture.at("G", x, y) > 0.5F, phase < 0.1);
    }
  }
  EXPECT_GT(checked, 3000);
}

}  // namespace
}  // namespace restframe
