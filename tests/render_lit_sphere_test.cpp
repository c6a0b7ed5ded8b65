// A diffuse sphere that a point light shines on, both moving: closed form 13 and Lambert's law at every
// pixel.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/path_scene.h"
#include "support/retarded_light.h"
#include "support/sphere_scene.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;
using reference::SphereHit;

constexpr double kStart = 0.3, kBase = 0.6, kIntensity = 25;

struct Motions {
  Vec3 sphere, light, camera;
};

const Vec3 kLight(2, 3, 1);

SphereScene scene_of(const Motions& motions, bool beaming) {
  SphereScene scene;
  scene.start = kStart;
  scene.fineness = 6;
  scene.layers = R"(["beauty"])";
  scene.camera.width = scene.camera.height = 70;
  scene.camera.position = {0.2, 0.5, 4};
  scene.camera.gamma_beta = reference::gamma_beta_from_beta(motions.camera);
  scene.spheres.resize(1);
  scene.spheres[0].gamma_beta = reference::gamma_beta_from_beta(motions.sphere);
  place_in_sight(scene.spheres[0], scene.camera, kStart, {0, 0, -1}, 4);
  const auto circle = outline(scene.spheres[0], scene.camera, kStart).value();
  aim(scene.camera, reference::narrowed(circle.axis));
  scene.camera.vertical_fov = 2.2 * static_cast<double>(circle.half_angle);
  scene.render = fmt::format("integrator = \"path\"\ndepth = 1\nbeaming = {}", beaming);
  scene.more = fmt::format(
      "[[light]]\ntype = \"point\"\nposition = {}\ntime = -4\nvelocity = {}\nintensity = {}\n{}",
      toml(kLight), toml(motions.light), kIntensity, diffuse_material("ball", kBase));
  return scene;
}

// Nothing where facets and the sphere that they stand for differ much: where light or sight graze.
std::optional<double> expected_radiance(const SphereScene& scene, const Motions& motions,
                                        const SphereHit& hit, const reference::FilmPoint& film,
                                        bool beaming) {
  const Long3 u = reference::widened(scene.spheres[0].gamma_beta);
  const auto sight = world_sight(scene.camera, direction_through(scene.camera, film));
  const Long4 eye = camera_event(scene.camera, kStart);
  const long double way = hit.distance * sight.frequency;
  const Long4 event{eye.t - way, eye.x + way * sight.direction};
  const reference::SeenLight light =
      seen({reference::widened(reference::gamma_beta_from_beta(motions.light)),
            reference::widened(kLight), -4, 0},
           event, u);
  const Long3 normal = reference::widened(hit.normal);
  const long double cosine = dot(normal, light.sight_at_surface);
  const long double towards_eye = -dot(normal, normalized(boosted(u, {-1, sight.direction}).x));
  if (cosine < 0.25L || towards_eye < 0.25L) return std::nullopt;
  const long double r = light.delay * light.at_surface;
  const long double d = light.at_surface / light.at_light * hit.doppler;
  const long double factor = beaming ? d * d * d * d : 1;
  return static_cast<double>(kBase / std::numbers::pi_v<long double> * kIntensity * factor *
                             cosine / (r * r));
}

void expect_lit(const Motions& motions, bool beaming) {
  const SphereScene scene = scene_of(motions, beaming);
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, scene_file(scene));
  int checked = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto hit = nearest_hit(scene.spheres, scene.camera, kStart, pixel_center(x, y));
      if (!hit) continue;
      const auto right = expected_radiance(scene, motions, *hit, pixel_center(x, y), beaming);
      if (!right) continue;
      ++checked;
      ASSERT_NEAR(static_cast<double>(picture.at("G", x, y)), *right, 6e-3 * *right)
          << x << ", " << y;
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(LitSphere, IsClosedForm13) {
  for (const bool beaming : {false, true}) {
    expect_lit({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, beaming);
    expect_lit({{0, 0, 0}, {-0.5, 0.3, 0.4}, {0, 0, 0}}, beaming);
    expect_lit({{0.3, 0.1, 0.4}, {0, 0, 0}, {0.2, -0.3, 0.1}}, beaming);
    expect_lit({{-0.2, 0.3, -0.5}, {0.4, 0, -0.3}, {0, 0.2, 0.5}}, beaming);
  }
}

}  // namespace
}  // namespace restframe
