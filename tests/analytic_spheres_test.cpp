#include "support/analytic_spheres.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "physics/doppler.h"
#include "physics/worldline.h"
#include "support/boosted_scene.h"
#include "support/velocity_grid.h"

namespace restframe::reference {
namespace {

const FilmPoint kCenter{640, 360};

double along_axis(double beta) {
  return beta / std::sqrt((1 - beta) * (1 + beta));
}

ObserverCamera moving_camera() {
  ObserverCamera camera;
  camera.position = {0.3, -0.2, 4};
  camera.time = -1.5;
  camera.gamma_beta = gamma_beta_from_beta({0.2, -0.3, -0.6});
  camera.vertical_fov = 2.2;
  aim(camera, {0.1, -0.2, -1}, {0.2, 1, 0});
  return camera;
}
constexpr double kNow = 2.5;

// Spheres of many velocities, each put where its centre is seen in the picture.
std::vector<MovingSphere> seen_spheres(const ObserverCamera& camera, double greatest_gamma) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform;
  std::vector<MovingSphere> spheres;
  const Long4 event = camera_event(camera, kNow);
  for (const Velocity& velocity : velocity_grid(greatest_gamma, 1)) {
    const FilmPoint film{1280 * uniform(generator), 720 * uniform(generator)};
    const WorldSight sight = world_sight(camera, direction_through(camera, film));
    const double path = 3 + 20 * uniform(generator);
    MovingSphere sphere;
    sphere.gamma_beta = velocity.gamma_beta();
    sphere.center = narrowed(event.x + path * sight.direction);
    sphere.time = static_cast<double>(event.t - path);
    sphere.clock = 10 * uniform(generator);
    sphere.radius = 0.2 + uniform(generator);
    spheres.push_back(sphere);
  }
  return spheres;
}

std::vector<FilmPoint> film_grid(int columns, int rows) {
  std::vector<FilmPoint> grid;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      grid.push_back({1280 * (x + 0.37) / columns, 720 * (y + 0.61) / rows});
    }
  }
  return grid;
}

// Film points inside the sphere's outline.
std::vector<FilmPoint> film_points_on(const MovingSphere& sphere, const ObserverCamera& camera) {
  const std::optional<Outline> circle = outline(sphere, camera, kNow);
  std::vector<FilmPoint> points;
  if (!circle) return points;
  for (const Vec3& offset : random_directions(12, 4)) {
    const Long3 towards =
        circle->axis + (0.9L * std::sin(std::min(circle->half_angle, 1.0L))) * widened(offset);
    const std::optional<FilmPoint> film = film_point(camera, towards);
    if (film && angle_outside(*circle, camera, *film) < 0) points.push_back(*film);
  }
  return points;
}

TEST(ObserverCamera, FilmConventions) {
  ObserverCamera camera;
  camera.vertical_fov = std::numbers::pi / 2;
  EXPECT_LE(length(direction_through(camera, kCenter) - Long3{0, 0, -1}), 1e-18L);
  EXPECT_LE(length(direction_through(camera, {640, 0}) - normalized({0, 1, -1})), 1e-15L);
  EXPECT_LE(length(direction_through(camera, {1280, 360}) - normalized({16, 0, -9})), 1e-15L);
  EXPECT_FALSE(film_point(camera, {0.1L, 0, 1}));
  for (const FilmPoint& film : film_grid(7, 5)) {
    const FilmPoint back =
        film_point(moving_camera(), direction_through(moving_camera(), film)).value();
    EXPECT_NEAR(back.x, film.x, 1e-10);
    EXPECT_NEAR(back.y, film.y, 1e-10);
  }
}

TEST(ObserverCamera, SightsThereAndBack) {
  for (const Velocity& velocity : velocity_grid(1000, 2)) {
    ObserverCamera camera;
    camera.gamma_beta = velocity.gamma_beta();
    for (const Vec3& direction : random_directions(10, 9)) {
      const WorldSight sight = world_sight(camera, widened(direction));
      EXPECT_LE(length(camera_sight(camera, sight.direction) - normalized(widened(direction))),
                1e-12L);
    }
  }
}

TEST(NearestHit, OfASphereAtRest) {
  const MovingSphere sphere{.center = {0, 0, -10}, .time = 3, .clock = 5, .radius = 1};
  const SphereHit hit = nearest_hit({sphere}, ObserverCamera{}, 20, kCenter).value();
  EXPECT_EQ(hit.point, Vec3(0, 0, 1));
  EXPECT_EQ(hit.normal, Vec3(0, 0, 1));
  EXPECT_DOUBLE_EQ(hit.distance, 9);
  EXPECT_DOUBLE_EQ(hit.world_time, 11);
  EXPECT_DOUBLE_EQ(hit.clock, 5 + 11 - 3);
  EXPECT_DOUBLE_EQ(hit.doppler, 1);
  EXPECT_FALSE(nearest_hit({sphere}, ObserverCamera{}, 20, {640, 100}));
}

TEST(NearestHit, SeesTheInsideFromWithin) {
  const SphereHit hit = nearest_hit({{.radius = 2}}, ObserverCamera{}, 0, kCenter).value();
  EXPECT_EQ(hit.point, Vec3(0, 0, -2));
  EXPECT_DOUBLE_EQ(hit.distance, 2);
}

TEST(NearestHit, OfASphereThatComesHeadOn) {
  // Its front, radius/gamma before the centre, is at L now and was seen at d: d - beta d = L.
  for (double beta : {0.6, 0.9, 0.99, -0.9}) {
    const double gamma = 1 / std::sqrt((1 - beta) * (1 + beta));
    const MovingSphere sphere{.gamma_beta = {0, 0, along_axis(beta)}, .center = {0, 0, -10}};
    const double d = (10 - 1 / gamma) / (1 - beta);
    const SphereHit hit = nearest_hit({sphere}, ObserverCamera{}, 0, kCenter).value();
    EXPECT_NEAR(hit.distance, d, 1e-12 * d);
    EXPECT_NEAR(hit.world_time, -d, 1e-12 * d);
    EXPECT_LE(glm::length(hit.point - Vec3(0, 0, 1)), 1e-12);
    EXPECT_NEAR(hit.doppler, std::sqrt((1 + beta) / (1 - beta)), 1e-12);
    // In the rest frame the centre's clock shows 0 at the reference event; the front's, moving
    // ahead, shows gamma (t - beta z) with z relative to it.
    EXPECT_NEAR(hit.clock, gamma * (-d - beta * (10 - d)), 1e-11 * d);
  }
}

TEST(NearestHit, OfASphereThatTheCameraFliesTo) {
  // The same as if it came, but for the world's distance: 9 at the event of seeing, D times that
  // for the camera, which sees the sphere where it was.
  ObserverCamera camera;
  camera.gamma_beta = {0, 0, -along_axis(0.99)};
  const SphereHit hit = nearest_hit({{.center = {0, 0, -10}}}, camera, 0, kCenter).value();
  const double D = std::sqrt(1.99 / 0.01);
  EXPECT_NEAR(hit.doppler, D, 1e-12);
  EXPECT_NEAR(hit.distance, 9 * D, 1e-10);
  EXPECT_NEAR(hit.world_time, -9, 1e-14);
}

TEST(NearestHit, IsContinuousAtRest) {
  const ObserverCamera camera = moving_camera();
  for (const Vec3& direction : random_directions(5, 8)) {
    MovingSphere still{.center = {0.5, -1, -4}};
    MovingSphere slow = still;
    slow.gamma_beta = 1e-12 * direction;
    for (const FilmPoint& film : film_points_on(still, camera)) {
      const SphereHit a = nearest_hit({still}, camera, kNow, film).value();
      const SphereHit b = nearest_hit({slow}, camera, kNow, film).value();
      EXPECT_LE(glm::length(a.point - b.point), 1e-9);
      EXPECT_NEAR(a.clock, b.clock, 1e-9);
      EXPECT_NEAR(a.doppler, b.doppler, 1e-11);
    }
  }
}

TEST(NearestHit, LiesOnTheSphereAndOnThePastLightCone) {
  const ObserverCamera camera = moving_camera();
  const Long4 event = camera_event(camera, kNow);
  for (const MovingSphere& sphere : seen_spheres(camera, 1000)) {
    const Long3 u = widened(sphere.gamma_beta);
    for (const FilmPoint& film : film_points_on(sphere, camera)) {
      const SphereHit hit = nearest_hit({sphere}, camera, kNow, film).value();
      EXPECT_NEAR(glm::length(hit.point), sphere.radius, 1e-10);
      const Long4 from_reference =
          boosted(-1.0L * u, {hit.clock - sphere.clock, widened(hit.point)});
      const double scale = 1e-12 * static_cast<double>(gamma_of(u)) * (1 + std::abs(hit.clock));
      EXPECT_NEAR(static_cast<double>(sphere.time + from_reference.t), hit.world_time, scale);
      const Long3 place = widened(sphere.center) + from_reference.x;
      EXPECT_NEAR(static_cast<double>(length(place - event.x)),
                  static_cast<double>(event.t) - hit.world_time, scale);
    }
  }
}

TEST(NearestHit, IsTheNearestOfAll) {
  const ObserverCamera camera = moving_camera();
  const std::vector<MovingSphere> spheres = seen_spheres(camera, 1000);
  int hits = 0;
  for (const FilmPoint& film : film_grid(24, 14)) {
    std::optional<SphereHit> expected;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      std::optional<SphereHit> hit = nearest_hit({spheres[i]}, camera, kNow, film);
      if (!hit || (expected && expected->distance <= hit->distance)) continue;
      expected = hit;
      expected->sphere = static_cast<int>(i);
    }
    const std::optional<SphereHit> got = nearest_hit(spheres, camera, kNow, film);
    ASSERT_EQ(got.has_value(), expected.has_value());
    if (!got) continue;
    ++hits;
    EXPECT_EQ(got->sphere, expected->sphere);
    EXPECT_EQ(got->distance, expected->distance);
  }
  EXPECT_GT(hits, 100);
}

TEST(SeenPoint, UndoesNearestHit) {
  const ObserverCamera camera = moving_camera();
  int checked = 0;
  for (const MovingSphere& sphere : seen_spheres(camera, 1000)) {
    const double gamma = static_cast<double>(gamma_of(widened(sphere.gamma_beta)));
    for (const FilmPoint& film : film_points_on(sphere, camera)) {
      const SphereHit hit = nearest_hit({sphere}, camera, kNow, film).value();
      const SeenPoint seen = seen_point(sphere, hit.point, camera, kNow);
      ASSERT_TRUE(seen.film);
      // The hit's point has double's digits, and the view of an approaching sphere stretches depth.
      const double tolerance = 1e-12 * gamma;
      EXPECT_NEAR(seen.film->x, film.x, 1280 * tolerance);
      EXPECT_NEAR(seen.film->y, film.y, 1280 * tolerance);
      EXPECT_NEAR(seen.clock, hit.clock, tolerance * (1 + std::abs(hit.clock)));
      EXPECT_NEAR(seen.world_time, hit.world_time, tolerance * (1 + std::abs(hit.world_time)));
      EXPECT_NEAR(seen.distance, hit.distance, tolerance * (1 + hit.distance));
      EXPECT_NEAR(seen.doppler / hit.doppler, 1, tolerance * gamma);
      EXPECT_TRUE(seen.faces_camera);
      EXPECT_FALSE(seen_point(sphere, -hit.point, camera, kNow).faces_camera);
      ++checked;
    }
  }
  EXPECT_GT(checked, 1000);
}

TEST(Outline, OfASphereAtRest) {
  const Outline circle = outline({.center = {0, 0, -10}, .radius = 2}, ObserverCamera{}, 0).value();
  EXPECT_NEAR(static_cast<double>(circle.half_angle), std::asin(0.2), 1e-15);
  EXPECT_NEAR(static_cast<double>(length(circle.axis - Long3{0, 0, -1})), 0, 1e-15);
  EXPECT_NEAR(angle_outside(circle, ObserverCamera{}, kCenter), -std::asin(0.2), 1e-15);
  EXPECT_FALSE(outline({.center = {0, 0, -1}, .radius = 2}, ObserverCamera{}, 0));
}

TEST(Outline, IsAberratedForAMovingCamera) {
  // Straight ahead, tan(alpha'/2) = sqrt((1-beta)/(1+beta)) tan(alpha/2).
  ObserverCamera camera;
  camera.gamma_beta = {0, 0, -along_axis(0.8)};
  const Outline circle = outline({.center = {0, 0, -10}, .radius = 6}, camera, 0).value();
  EXPECT_NEAR(std::tan(static_cast<double>(circle.half_angle) / 2),
              std::tan(std::asin(0.6) / 2) / 3, 1e-15);
}

TEST(Outline, BoundsTheHits) {
  const ObserverCamera camera = moving_camera();
  int inside = 0;
  for (const MovingSphere& sphere : seen_spheres(camera, 1000)) {
    const std::optional<Outline> circle = outline(sphere, camera, kNow);
    if (!circle) continue;
    for (int i = 0; i < 40; ++i) {
      const long double azimuth = i, factor = i % 2 == 0 ? 1 - 1e-9L : 1 + 1e-9L;
      const Long3 helper = std::abs(circle->axis.x) < 0.5L ? Long3{1, 0, 0} : Long3{0, 1, 0};
      const Long3 a = normalized(cross(circle->axis, helper)), b = cross(circle->axis, a);
      const long double angle = factor * circle->half_angle;
      const Long3 sight = std::cos(angle) * circle->axis +
                          std::sin(angle) * (std::cos(azimuth) * a + std::sin(azimuth) * b);
      const std::optional<FilmPoint> film = film_point(camera, sight);
      // Far outside the picture, pixels in double no longer tell the two sides apart.
      if (!film || std::abs(film->x) > 5000 || std::abs(film->y) > 5000) continue;
      const double expected = static_cast<double>((factor - 1) * circle->half_angle);
      EXPECT_NEAR(angle_outside(*circle, camera, *film), expected, 1e-13);
      if (std::abs(expected) < 1e-12) continue;
      EXPECT_EQ(nearest_hit({sphere}, camera, kNow, *film).has_value(), expected < 0);
      inside += expected < 0;
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(AnalyticSpheres, AreTheSameFromAnotherWorldFrame) {
  const ObserverCamera camera = moving_camera();
  const Velocity new_world = Velocity::from_beta({-0.4, 0.6, 0.3});
  const Long3 w = widened(new_world.gamma_beta());
  const auto move = [&w](Vec3& gamma_beta, double& t, Vec3& x) {
    const Long3 u = widened(gamma_beta);
    const Long4 event = boosted(w, {t, widened(x)});
    gamma_beta = narrowed(boosted(w, {gamma_of(u), u}).x);
    t = static_cast<double>(event.t);
    x = narrowed(event.x);
  };
  ObserverCamera other_camera = camera;
  move(other_camera.gamma_beta, other_camera.time, other_camera.position);
  const Mat3 turn = wigner_rotation(Velocity::from_gamma_beta(camera.gamma_beta), new_world);
  for (Vec3* axis : {&other_camera.right, &other_camera.up, &other_camera.back})
    *axis = turn * *axis;
  for (const MovingSphere& sphere : seen_spheres(camera, 20)) {
    MovingSphere other = sphere;
    move(other.gamma_beta, other.time, other.center);
    const Mat3 sphere_turn =
        wigner_rotation(Velocity::from_gamma_beta(sphere.gamma_beta), new_world);
    for (const FilmPoint& film : film_points_on(sphere, camera)) {
      const SphereHit a = nearest_hit({sphere}, camera, kNow, film).value();
      const std::optional<SphereHit> b = nearest_hit({other}, other_camera, kNow, film);
      ASSERT_TRUE(b);
      EXPECT_LE(glm::length(sphere_turn * a.point - b->point), 1e-8);
      EXPECT_NEAR(a.clock, b->clock, 1e-8);
      EXPECT_NEAR(a.distance, b->distance, 1e-8);
      EXPECT_NEAR(a.doppler / b->doppler, 1, 1e-10);
    }
  }
}

// The program's own physics against this reference: camera to world to rest frame.
TEST(AnalyticSpheres, AgreeWithTheProgramsPhysics) {
  const ObserverCamera camera = moving_camera();
  const Velocity camera_velocity = Velocity::from_gamma_beta(camera.gamma_beta);
  const Event<in::World> event =
      Worldline{{camera.time, camera.position}, camera_velocity}.at_proper_time(kNow);
  for (const MovingSphere& sphere : seen_spheres(camera, 1000)) {
    const Velocity velocity = Velocity::from_gamma_beta(sphere.gamma_beta);
    const Worldline line{{sphere.time, sphere.center}, velocity};
    for (const FilmPoint& film : film_points_on(sphere, camera)) {
      const SphereHit hit = nearest_hit({sphere}, camera, kNow, film).value();
      const Vec3 direction = narrowed(direction_through(camera, film));
      const AnchoredFrame<in::Rest> rest = line.rest_frame();
      const WaveVector<in::Rest> k = rest(
          Boost<in::World, in::Camera>(-camera_velocity)(looking_along<in::Camera>(direction)));
      const double gamma = velocity.gamma();
      EXPECT_NEAR(doppler_factor(k) / hit.doppler, 1, 1e-14 * gamma);
      const Event<in::Rest> seen = point_on_ray(rest(event), k, hit.distance);
      const double tolerance = 1e-13 * gamma * (1 + hit.distance * -k.t);
      EXPECT_LE(glm::length(seen.x - hit.point), tolerance);
      EXPECT_NEAR(seen.t, hit.clock - sphere.clock, tolerance);
      EXPECT_NEAR(seen_event(rest, event, hit.point).t, hit.clock - sphere.clock, tolerance);
    }
  }
}

}  // namespace
}  // namespace restframe::reference
