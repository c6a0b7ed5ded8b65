// The preview integrator on rendered pictures: base colour times the cosine between ray and normal
// in the rest frame, plus emission; exact compositing; beaming.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "support/sphere_scene.h"

namespace restframe {
namespace {

using reference::MovingSphere;
using reference::SphereHit;

constexpr double kStart = 0.5;

// One sphere in the middle of the picture.
SphereScene sphere_scene(const Vec3& velocity, const std::string& material) {
  SphereScene scene;
  scene.start = kStart;
  reference::ObserverCamera& camera = scene.camera;
  camera.width = camera.height = 60;
  camera.position = {1, 2, 3};
  MovingSphere sphere;
  sphere.gamma_beta = reference::gamma_beta_from_beta(velocity);
  place_in_sight(sphere, camera, kStart, {0, 0, -1}, 5);
  scene.spheres = {sphere};
  const auto circle = outline(sphere, camera, kStart).value();
  aim(camera, reference::narrowed(circle.axis));
  camera.vertical_fov = 2.4 * static_cast<double>(circle.half_angle);
  scene.more = "[[material]]\nname = \"ball\"\n" + material;
  return scene;
}

// |cos| between the ray and the sphere's normal in the rest frame, where both the camera's event
// and the hit are points of one straight line.
double cosine_at(const MovingSphere& sphere, const reference::ObserverCamera& camera,
                 const SphereHit& hit) {
  const reference::Long4 event = camera_event(camera, kStart);
  const reference::Long3 from_center = event.x - reference::widened(sphere.center);
  const Vec3 eye = reference::narrowed(
      boosted(reference::widened(sphere.gamma_beta), {event.t - sphere.time, from_center}).x);
  return std::abs(glm::dot(glm::normalize(eye - hit.point), hit.normal));
}

Vec4f color_at(const ExrPicture& picture, int x, int y) {
  return {picture.at("R", x, y), picture.at("G", x, y), picture.at("B", x, y),
          picture.at("A", x, y)};
}

// The beauty must be lit * cos + unlit, times D^4 if so asked, at every pixel that surely hits.
void expect_shading(const SphereScene& scene, const Vec3f& lit, const Vec3f& unlit,
                    bool beaming = false) {
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  int checked = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto hit = nearest_hit(scene.spheres, scene.camera, kStart, pixel_center(x, y));
      if (!hit) continue;
      const double cosine = cosine_at(scene.spheres[0], scene.camera, *hit);
      // Near the outline the facets' depth moves the hit across them.
      if (cosine < 0.2) continue;
      ++checked;
      const double factor = beaming ? std::pow(hit->doppler, 4) : 1;
      const Vec3 expected = factor * (cosine * Vec3(lit) + Vec3(unlit));
      const Vec4f color = color_at(picture, x, y);
      ASSERT_LE(glm::length(Vec3(color) - expected), 3e-3 * factor) << x << ", " << y;
      ASSERT_EQ(color.w, 1);
    }
  }
  EXPECT_GT(checked, 1000);
}

const std::vector<Vec3> kVelocities = {{0, 0, 0}, {0, 0, 0.9}, {0.9, 0, 0}, {0.3, 0.2, -0.9}};

TEST(Shading, IsBaseColourTimesTheRestFramesCosine) {
  for (const Vec3& velocity : kVelocities) {
    expect_shading(sphere_scene(velocity, "base_color = [0.8, 0.5, 0.25]"), {0.8, 0.5, 0.25},
                   {0, 0, 0});
  }
}

TEST(Shading, AddsEmission) {
  expect_shading(sphere_scene(kVelocities[2],
                              "base_color = [0.5, 0.4, 0]\nemission = [0, 0.125, "
                              "0.25]\nemission_strength = 2"),
                 {0.5, 0.4, 0}, {0, 0.25, 0.5});
}

TEST(Shading, UnlitHasNoCosine) {
  expect_shading(sphere_scene(kVelocities[1], "base_color = [0.5, 0.4, 0]\nunlit = true"),
                 {0, 0, 0}, {0.5, 0.4, 0});
}

TEST(Shading, BeamingMultipliesByTheFourthPowerOfD) {
  for (const Vec3& velocity : {Vec3(0.3, 0.1, 0.8), Vec3(0, 0, -0.9), Vec3(0.99, 0, 0)}) {
    SphereScene scene = sphere_scene(velocity, "base_color = [0.8, 0.5, 0.25]");
    scene.render = "beaming = true";
    expect_shading(scene, {0.8, 0.5, 0.25}, {0, 0, 0}, true);
  }
}

// A small sphere before a large one, whose opacities differ; the far sides are back faces, which a
// single-sided material does not show.
TEST(Shading, CompositesFrontToBackExactly) {
  constexpr double front = 0.25, behind = 0.6;
  SphereScene scene = sphere_scene({0, 0, 0.6}, "unlit = true\nbase_color = [1, 0, 0]\n");
  scene.spheres.push_back(scene.spheres[0]);
  scene.spheres[1].radius = 0.15;
  scene.spheres[1].gamma_beta = reference::gamma_beta_from_beta({0.2, 0.5, 0});
  place_in_sight(scene.spheres[1], scene.camera, kStart, {0, 0, -1}, 1.5);
  scene.more += fmt::format(
      "object = \"sphere_1\"\nopacity = {}\n[[material]]\nname = \"ball\"\nobject = "
      "\"sphere_2\"\nunlit = true\nbase_color = [0, 1, 0]\nopacity = {}\n",
      behind, front);
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  const auto inner = inscribed(scene.spheres, scene.fineness);
  std::map<int, int> checked;
  const auto is_hit = [&](const std::vector<MovingSphere>& spheres, std::size_t i, int x, int y) {
    return nearest_hit({spheres[i]}, scene.camera, kStart, pixel_center(x, y)).has_value();
  };
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const bool red = is_hit(scene.spheres, 0, x, y), green = is_hit(scene.spheres, 1, x, y);
      if (red != is_hit(inner, 0, x, y) || green != is_hit(inner, 1, x, y)) continue;
      ++checked[red + 2 * green];
      const double b = red ? behind : 0, f = green ? front : 0;
      const Vec4f color = color_at(picture, x, y);
      ASSERT_NEAR(color.x, (1 - f) * b, 1e-3) << x << ", " << y;
      ASSERT_NEAR(color.y, f, 1e-3) << x << ", " << y;
      ASSERT_NEAR(color.w, 1 - (1 - f) * (1 - b), 1e-3) << x << ", " << y;
    }
  }
  EXPECT_GT(checked[1], 300);
  EXPECT_GT(checked[3], 300);
}

// Data layers show the first surface that the stochastic test keeps: each with its own probability.
TEST(Shading, DataOfTransparentSurfacesAreKeptByChance) {
  SphereScene scene = sphere_scene({0, 0, 0}, "opacity = 0.3\n");
  scene.camera.vertical_fov /= 4;  // the sphere fills the picture
  scene.camera.width = scene.camera.height = 200;
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  double kept = 0;
  for (const float id : picture.channel("id_object.V")) kept += id == 1;
  // 40,000 trials: a standard deviation of 0.0023.
  EXPECT_NEAR(kept / (200 * 200), 0.3, 5 * 0.0023);
}

// Opacity over the clock: 1 in the first half of each second, 0 in the second half.
TEST(Shading, OpacityMayChangeOverTheClock) {
  const SphereScene scene = sphere_scene(
      {0, 0, 0},
      "opacity = {period = 0.2, intervals = [[0, 0.1, 1.0], [0.1, 0.2, 0.0]]}\nunlit = true\n"
      "base_color = \"white\"");
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  int seen = 0, unseen = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto hit = nearest_hit(scene.spheres, scene.camera, kStart, pixel_center(x, y));
      if (!hit || cosine_at(scene.spheres[0], scene.camera, *hit) < 0.2) continue;
      const double phase = hit->clock / 0.2 - std::floor(hit->clock / 0.2);
      if (std::min({phase, std::abs(phase - 0.5), 1 - phase}) < 0.02) continue;
      ++(phase < 0.5 ? seen : unseen);
      ASSERT_EQ(picture.at("A", x, y), phase < 0.5 ? 1 : 0);
    }
  }
  EXPECT_GT(seen, 200);
  EXPECT_GT(unseen, 200);
}

}  // namespace
}  // namespace restframe
