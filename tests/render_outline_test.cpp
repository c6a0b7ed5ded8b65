// Closed form 5 on rendered pictures: a sphere's outline is an exact circle on the sky, however
// fast it moves.

#include <gtest/gtest.h>

#include "support/sphere_scene.h"

namespace restframe {
namespace {

using reference::angle_outside;
using reference::Outline;

constexpr int kFineness = 5;
constexpr double kStart = 1.25;

struct Motion {
  double gamma;
  Vec3 direction;        // of the sphere's velocity
  Vec3 sight;            // where the camera sees it
  Vec3 camera{0, 0, 0};  // velocity, in fractions of c
};

const std::vector<Motion> kMotions = {
    {1, {1, 0, 0}, {0, 0, -1}},
    {1.02, {1, 0.3, 0}, {0.2, 0.1, -1}},
    {1.25, {0, 0, 1}, {0, 0, -1}},
    {2, {0, 1, 0}, {1, 0, 0}},
    {2, {1, 0, 0.2}, {0, 0, -1}, {0.3, 0.2, -0.5}},
    {7.1, {0, 0, 1}, {0.1, 0, -1}},
    {7.1, {0, 0, -1}, {0, 0, -1}},
    {7.1, {1, 0, 0}, {0, 0, -1}, {0, 0, -0.9}},
    {22, {0.2, -0.1, 1}, {0, 0, -1}},
    {22, {-1, 0.3, 0.2}, {0.5, -1, 0.3}, {0.6, -0.4, 0.2}},
    {1000, {0, 0, 1}, {0, 0, -1}},
    {1000, {0.05, 0.02, 1}, {0, 0.1, -1}, {-0.2, 0.1, 0.6}},
    {1000, {1, 0, 0}, {0, 0, -1}},
    {1000, {0.3, 0.2, -1}, {0, 0, -1}, {0, 0.7, 0}},
};

// The camera looks at the outline's middle and the circle fills three quarters of the height.
SphereScene scene_of(const Motion& motion) {
  SphereScene scene;
  scene.start = kStart;
  scene.fineness = kFineness;
  scene.layers = R"(["Z", "id"])";
  reference::ObserverCamera& camera = scene.camera;
  camera.position = {3, -2, 8};
  camera.time = -4;
  camera.gamma_beta = reference::gamma_beta_from_beta(motion.camera);
  camera.width = 160;
  camera.height = 120;
  reference::MovingSphere sphere;
  sphere.gamma_beta = reference::gamma_beta_from_gamma(motion.gamma, motion.direction);
  sphere.radius = 0.5;
  // Nearer, the camera would be inside it, or it would cover most of the sky: at gamma = 1000 all
  // but a small circle of directions belong to what lies straight behind.
  double distance = 1;
  std::optional<Outline> seen;
  while (!seen || seen->half_angle > 0.5L) {
    place_in_sight(sphere, camera, kStart, motion.sight, distance *= 2);
    seen = outline(sphere, camera, kStart);
  }
  scene.spheres = {sphere};
  const Outline circle = *seen;
  aim(camera, reference::narrowed(circle.axis), {0.1, 0.9, 0.4});
  camera.vertical_fov = 2 * std::atan(std::tan(static_cast<double>(circle.half_angle)) / 0.75);
  return scene;
}

// A mesh within the sphere that holds a smaller sphere: its outline runs between their circles.
TEST(RenderedOutline, IsTheExactCircle) {
  for (std::size_t i = 0; i < kMotions.size(); ++i) {
    SCOPED_TRACE("motion " + std::to_string(i));
    const SphereScene scene = scene_of(kMotions[i]);
    const reference::ObserverCamera& camera = scene.camera;
    const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
    const Outline outer = outline(scene.spheres[0], camera, kStart).value();
    const Outline inner = outline(inscribed(scene.spheres, kFineness)[0], camera, kStart).value();
    // Embree's floats: a thousandth of a pixel.
    const double slack = 1e-3 * camera.vertical_fov / camera.height;
    int inside = 0, outside = 0, wrong = 0;
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const bool hit = picture.at("id_object.V", x, y) == 1;
        EXPECT_EQ(hit, std::isfinite(picture.at("Z", x, y)));
        const bool must_hit = angle_outside(inner, camera, pixel_center(x, y)) < -slack;
        const bool must_miss = angle_outside(outer, camera, pixel_center(x, y)) > slack;
        inside += must_hit;
        outside += must_miss;
        wrong += (must_hit && !hit) || (must_miss && hit);
      }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(inside, 5000);
    EXPECT_GT(outside, 5000);
    EXPECT_GT(inside + outside, 160 * 120 - 40);
  }
}

}  // namespace
}  // namespace restframe
