// Figures 8 and 9 of the paper, and its row of spheres out of step: what finite light speed alone
// does, measured in the pictures of their scenes.

#include <gtest/gtest.h>

#include "support/animation.h"
#include "support/figure.h"
#include "support/shown_scene.h"
#include "support/sphere_scene.h"

namespace restframe {
namespace {

using reference::ObserverCamera;

// On a sphere of radius 2, seen from 5, the circle from which light takes d has the angle psi from
// the axis with cos(psi) = (d^2 + 5^2 - 2^2) / (2 d 5).
double ring_radius(double d, double focal_length) {
  const double cosine = (d * d + 21) / (10 * d);
  return focal_length * std::sqrt(1 - cosine * cosine) / cosine;
}

// Half the width in pixels of the run of one colour around the picture's middle.
double middle_run(const ExrPicture& picture) {
  const int y = picture.height / 2, middle = picture.width / 2;
  const auto yellow = [&](int x) { return picture.at("R", x, y) > picture.at("B", x, y); };
  int left = middle, right = middle;
  while (yellow(left - 1) == yellow(middle)) --left;
  while (yellow(right + 1) == yellow(middle)) ++right;
  return 0.5 * (right - left + 1);
}

TEST(Figure8, RingsExpandAsLightIsDelayed) {
  const std::string text = small(scene_text("fig08_ring"), 361, 361, R"(["beauty"])");
  const Scene scene = figure_scene(text);
  const ObserverCamera camera = figure_camera(scene);
  ASSERT_EQ(camera.position, Vec3(0, 0, 5));
  const double focal_length = 0.5 * 361 / std::tan(0.5 * camera.vertical_fov);
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double time = scene.animation.start + static_cast<double>(i) / scene.animation.rate;
    // The last change of which light has come from the nearest point, 3 away.
    const double change = std::floor(2 * (time - 3)) / 2;
    const double expected = ring_radius(time - change, focal_length);
    EXPECT_NEAR(middle_run(pictures[i]), expected, std::max(0.75, 0.02 * expected)) << i;
    EXPECT_EQ(pictures[i].at("R", 180, 180) > pictures[i].at("B", 180, 180),
              std::fmod(2 * std::abs(change), 2) == 0)
        << i;
  }
}

TEST(Figure8, EveryPixelHasTheColourOfItsClock) {
  const std::string text = small(scene_text("fig08_ring"), 120, 120, R"(["beauty"])");
  const Scene scene = figure_scene(text);
  const ObserverCamera camera = figure_camera(scene);
  const auto spheres = figure_spheres(scene, {2});
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  int checked = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double time = scene.animation.start + static_cast<double>(i) / scene.animation.rate;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) {
        const auto hit = nearest_hit(spheres, camera, time, pixel_center(x, y));
        // Facets are up to 3e-4 radii deep, and more along a grazing ray.
        if (!hit || std::abs(std::remainder(hit->clock, 0.5)) < 0.01) continue;
        if (glm::dot(hit->normal, Vec3(0, 0, 1)) < 0.45) continue;
        const double phase = hit->clock - std::floor(hit->clock);
        ASSERT_EQ(pictures[i].at("R", x, y) > pictures[i].at("B", x, y), phase < 0.5) << i;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 40000);
}

// Each small ball is as far from the observer as its light still has to go.
TEST(Figure9, LightArrivesFromTheMiddleFirst) {
  const std::string text = small(scene_text("fig09_ring_steps"), 960, 600, R"(["beauty", "id"])");
  const Scene scene = figure_scene(text);
  const ObserverCamera camera = figure_camera(scene);
  const double focal_length = 0.5 * 600 / std::tan(0.5 * camera.vertical_fov);
  const glm::dvec2 eye = film_offset(camera, Vec3(5, 0, 0) - camera.position);
  ASSERT_EQ(scene.objects.size(), 13U);
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  int checked = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double time = scene.animation.start + static_cast<double>(i) / scene.animation.rate;
    double previous = 0;
    for (int step = 0; step <= 5; ++step) {
      // From the middle of the sphere's near side to 60 degrees beside it.
      const Object& light = scene.objects.at(static_cast<std::size_t>(7 + step));
      const double to_go = glm::length(light.worldline.reference.x - Vec3(5, 0, 0)) - time;
      EXPECT_GT(to_go, previous);
      previous = std::max(0.0, to_go);
      if (to_go < 0.5) continue;
      const Spot spot = spot_of(pictures[i], 8 + step);
      const double measured = std::hypot(spot.x - eye.x, spot.y - eye.y) / focal_length * 4000;
      EXPECT_NEAR(measured, to_go, 0.02) << "picture " << i << ", " << light.name;
      ++checked;
    }
  }
  EXPECT_GE(checked, 14);
}

// Clocks that agree are seen to differ by the differences of their distances.
TEST(OutOfStep, ClocksAreSeenLaterTheFartherTheyAre) {
  const std::string text =
      small(scene_text("out_of_step"), 1280, 300, R"(["beauty", "time", "id"])");
  const Scene scene = figure_scene(text);
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  const std::size_t count = scene.objects.size();
  const Vec3 camera = figure_camera(scene).position;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const ExrPicture& picture = pictures[i];
    for (std::size_t k = 0; k < count; ++k) {
      const Spot spot = spot_of(picture, static_cast<int>(k) + 1);
      const int x = static_cast<int>(spot.x + 640), y = static_cast<int>(spot.y + 150);
      const double distance = glm::length(scene.objects[k].worldline.reference.x - camera);
      const double clock = static_cast<double>(picture.at("time_proper.V", x, y));
      EXPECT_NEAR(clock, 0.1 * static_cast<double>(i) - (distance - 0.1), 1e-3) << i << ' ' << k;
      const double phase = clock - std::floor(clock);
      if (phase > 0.02 && phase < 0.2) {
        EXPECT_GT(picture.at("R", x, y), 0.6F) << i << ' ' << k;
      }
      if (phase > 0.5 && phase < 0.98) {
        EXPECT_LT(picture.at("R", x, y), 0.1F) << i << ' ' << k;
      }
    }
  }
}

}  // namespace
}  // namespace restframe
