// Several spheres of different velocities and a moving camera in one picture: every hit is put
// through the light-cone equations, and compared with the analytic tracer.

#include <gtest/gtest.h>

#include "support/sphere_scene.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::MovingSphere;
using reference::SeenPoint;

constexpr int kFineness = 5;
constexpr double kStart = 2.5;

// The velocity of something seen along n (in the world) with this Doppler factor there: gamma (1 +
// v.n) = 1 / D, the rest of v across.
Vec3 gamma_beta_for(double gamma, double doppler, const Vec3& n, const Vec3& across) {
  const double along = 1 / doppler - gamma;
  const Vec3 side = glm::normalize(glm::cross(n, across));
  return along * n + std::sqrt(gamma * gamma - 1 - along * along) * side;
}

void add_sphere(SphereScene& scene, double gamma, double doppler, const Vec3& sight,
                double distance, double radius) {
  const auto n = reference::world_sight(scene.camera, reference::widened(glm::normalize(sight)));
  MovingSphere sphere;
  sphere.radius = radius;
  sphere.clock = 0.3 * static_cast<double>(scene.spheres.size());
  if (gamma > 1) {
    sphere.gamma_beta = gamma_beta_for(gamma, doppler, reference::narrowed(n.direction), {1, 2, 3});
  }
  place_in_sight(sphere, scene.camera, kStart, sight, distance);
  scene.spheres.push_back(sphere);
}

SphereScene crowd(double light_speed) {
  SphereScene scene;
  scene.start = kStart;
  scene.fineness = kFineness;
  scene.light_speed = light_speed;
  reference::ObserverCamera& camera = scene.camera;
  camera.position = {0.3, -0.2, 4};
  camera.time = -1.5;
  camera.gamma_beta = reference::gamma_beta_from_beta({0.2, -0.3, -0.4});
  camera.vertical_fov = 1.2;
  camera.width = 240;
  camera.height = 180;
  aim(camera, {0.1, -0.2, -1}, {0.2, 1, 0});
  add_sphere(scene, 1, 1, {-0.35, 0.1, -1}, 12, 2);
  add_sphere(scene, 1.2, 0.7, {0.1, -0.15, -1}, 30, 9);
  add_sphere(scene, 3, 2, {0.55, 0.1, -1}, 10, 0.8);
  add_sphere(scene, 20, 1.5, {0.2, -0.55, -1}, 9, 0.9);
  add_sphere(scene, 20, 0.06, {-0.2, -0.5, -1}, 6, 1.1);
  add_sphere(scene, 1000, 0.01, {0.25, 0.15, -1}, 14, 1.7);
  add_sphere(scene, 1000, 0.001, {-0.35, -0.1, -1}, 9, 1.5);
  return scene;
}

// How far a float in the file may be from the number that was rounded to it.
double rounding(double value) {
  return 0x1p-23 * std::abs(value);
}

// Of light from that direction of the camera's: the same for every point of the sphere that could
// send it.
double doppler_along(const Long3& sight, const MovingSphere& sphere,
                     const reference::ObserverCamera& camera) {
  const reference::WorldSight world = reference::world_sight(camera, sight);
  const Long3 u = reference::widened(sphere.gamma_beta);
  return static_cast<double>(
      1 / (world.frequency * reference::frequency_seen_from(u, world.direction)));
}

class LightCone : public testing::TestWithParam<double> {};

TEST_P(LightCone, HoldsForEveryHit) {
  const SphereScene scene = crowd(GetParam());
  const double c = scene.light_speed;
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  const auto [proper_origin, world_origin] = time_origins(picture);
  std::vector<int> hits(scene.spheres.size());
  int inwards = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto value = [&](const char* channel) { return double{picture.at(channel, x, y)}; };
      const int id = static_cast<int>(value("id_object.V"));
      if (id == 0) continue;
      ++hits[static_cast<std::size_t>(id - 1)];
      const MovingSphere& sphere = scene.spheres[static_cast<std::size_t>(id - 1)];
      const Vec3 point = Vec3(value("P.X"), value("P.Y"), value("P.Z")) / c;
      const SeenPoint seen = seen_point(sphere, point, scene.camera, kStart);
      ASSERT_TRUE(seen.film);
      // P is a float: where it moves by an ulp, the distance moves by up to D times that.
      const double tolerance =
          1e-6 * (1 + seen.distance) + rounding(sphere.radius) * std::max(1.0, seen.doppler) * 3;
      ASSERT_NEAR(value("Z") / c, seen.distance, tolerance);
      const double proper = value("time_proper.V"), world = value("time_world.V");
      ASSERT_NEAR(proper + proper_origin, seen.clock, tolerance + rounding(proper));
      ASSERT_NEAR(world + world_origin, seen.world_time, 2 * tolerance + rounding(world));
      ASSERT_NEAR(value("doppler.D"), seen.doppler, tolerance);
      const Long3 sight = reference::direction_through(scene.camera, pixel_center(x, y));
      ASSERT_NEAR(value("doppler.D") / doppler_along(sight, sphere, scene.camera), 1, 3e-7);
      const Vec3 center = reference::narrowed(sight);
      ASSERT_LE(glm::length(seen.direction - center) * seen.distance, tolerance);
      // Normals and places of a ball's vertices are parallel, so they stay so between them, but for
      // the weights, which are Embree's floats.
      const Vec3 normal(value("N.X"), value("N.Y"), value("N.Z"));
      ASSERT_LE(glm::length(glm::cross(normal, glm::normalize(point))), 1e-4);
      ASSERT_NEAR(glm::length(normal), 1, 1e-6);
      // Facets of the outline may be seen a little past the sphere's own horizon.
      inwards += glm::dot(normal, point) < 0;
      ASSERT_EQ(value("id_material.V"), picture.at("id_material.V", x, y));
      ASSERT_GE(value("id_material.V"), 1);
    }
  }
  EXPECT_LE(inwards, 10);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_GT(hits[i], 200) << "sphere " << i + 1;
}

TEST_P(LightCone, TheSphereThatIsSeenIsTheAnalyticTracers) {
  const SphereScene scene = crowd(GetParam());
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  const std::vector<MovingSphere> inner = inscribed(scene.spheres, kFineness);
  int open = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto film = pixel_center(x, y);
      const auto a = nearest_hit(scene.spheres, scene.camera, kStart, film);
      const auto b = nearest_hit(inner, scene.camera, kStart, film);
      const int expected = a ? a->sphere + 1 : 0;
      if (expected != (b ? b->sphere + 1 : 0)) {
        ++open;  // within the facets' error of an edge
      } else {
        ASSERT_EQ(picture.at("id_object.V", x, y), static_cast<float>(expected))
            << "pixel " << x << ", " << y;
      }
    }
  }
  EXPECT_LT(open, 60);
}

TEST_P(LightCone, WhereNothingIsHitAllButZAreZero) {
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(crowd(GetParam())));
  int empty = 0;
  for (std::size_t i = 0; i < picture.channel("Z").size(); ++i) {
    for (const auto& [name, values] : picture.channels) {
      ASSERT_TRUE(name == "Z" || std::isfinite(values[i])) << name;
    }
    if (picture.channel("id_object.V")[i] != 0) {
      ASSERT_GT(picture.channel("Z")[i], 0);
      ASSERT_TRUE(std::isfinite(picture.channel("Z")[i]));
      ASSERT_EQ(picture.channel("A")[i], 1);
      continue;
    }
    ++empty;
    ASSERT_EQ(picture.channel("Z")[i], std::numeric_limits<float>::infinity());
    for (const auto& [name, values] : picture.channels) {
      ASSERT_TRUE(name == "Z" || values[i] == 0) << name;
    }
  }
  EXPECT_GT(empty, 1000);
}

INSTANTIATE_TEST_SUITE_P(LightSpeeds, LightCone, testing::Values(1.0, 2.5));

}  // namespace
}  // namespace restframe
