#include "support/boosted_scene.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "physics/doppler.h"
#include "support/velocity_grid.h"

namespace restframe {
namespace {

double rotation_angle(const Mat3& r) {
  const double sine =
      glm::length(Vec3(r[1][2] - r[2][1], r[2][0] - r[0][2], r[0][1] - r[1][0])) / 2;
  return std::atan2(sine, (r[0][0] + r[1][1] + r[2][2] - 1) / 2);
}

double largest_entry(const Mat3& m) {
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(m[i / 3][i % 3]));
  return largest;
}

TEST(WignerRotation, PerpendicularVelocities) {
  // Perpendicular boosts of gamma_1 and gamma_2: cos = (gamma_1 + gamma_2) / (1 + gamma_1 gamma_2),
  // in the plane of the two.
  const Velocity a = Velocity::from_beta({0.9, 0, 0}), b = Velocity::from_beta({0, 0.9, 0});
  const Mat3 turn = wigner_rotation(a, b);
  EXPECT_NEAR(rotation_angle(turn) * 180 / std::numbers::pi, 42.9, 0.05);
  EXPECT_NEAR(glm::length(turn * Vec3(0, 0, 1) - Vec3(0, 0, 1)), 0, 1e-15);
  for (double gamma : {1.001, 2.0, 100.0}) {
    const Mat3 other = wigner_rotation(a, Velocity::from_gamma(gamma, {0, 0, 1}));
    const double expected = std::acos((gamma + a.gamma()) / (1 + gamma * a.gamma()));
    EXPECT_NEAR(rotation_angle(other), expected, 1e-12);
  }
}

TEST(WignerRotation, IsARotation) {
  for (const Velocity& v : velocity_grid(1000, 2)) {
    for (const Velocity& w :
         {Velocity::from_beta({0.3, -0.5, 0.2}), Velocity::from_gamma(20, {1, 1, 2})}) {
      const Mat3 turn = wigner_rotation(v, w);
      ASSERT_LE(largest_entry(turn * glm::transpose(turn) - Mat3(1)), 1e-9);
      ASSERT_NEAR(glm::determinant(turn), 1, 1e-9);
    }
  }
}

TEST(WignerRotation, NothingTurnsWithoutTwoDirections) {
  const Velocity v = Velocity::from_beta({0.3, 0.6, -0.6});
  EXPECT_LE(largest_entry(wigner_rotation(v, Velocity()) - Mat3(1)), 1e-15);
  EXPECT_LE(largest_entry(wigner_rotation(Velocity(), v) - Mat3(1)), 1e-15);
  const Velocity along = Velocity::from_gamma_beta(-3.0 * v.gamma_beta());
  EXPECT_LE(largest_entry(wigner_rotation(v, along) - Mat3(1)), 1e-15);
}

Scene example() {
  Scene scene;
  scene.camera.motion = Worldline{{0.5, {1, 2, 8}}, Velocity::from_beta({0.2, -0.4, 0.5})};
  scene.camera.aim = AimDirection{{0, 0.6, -0.8}};
  const auto add = [&scene](const Worldline& worldline) {
    Object object;
    object.worldline = worldline;
    object.clock = static_cast<double>(scene.objects.size());
    object.parts.push_back({0, Mat4(2.0)});
    scene.objects.push_back(object);
  };
  add({{0, {0, 0, 0}}, Velocity()});
  add({{1, {5, -1, -3}}, Velocity::from_beta({0, 0, 0.99})});
  add({{-7, {-2, 4, 1}}, Velocity::from_gamma(50, {-1, 0.3, 0.2})});
  add({{2, {3, 3, 3}}, Velocity::from_beta({1e-9, 0, 0})});
  return scene;
}

const std::vector<Velocity> kNewWorlds = {
    Velocity(), Velocity::from_beta({0.6, 0, 0}), Velocity::from_beta({-0.5, 0.7, 0.2}),
    Velocity::from_gamma(10, {1, 2, -2}), Velocity::from_beta({0, 0, 0.99})};

TEST(BoostedScene, KeepsIntervalsAndRelativeSpeeds) {
  const auto four_velocity = [](const Velocity& v) {
    return Displacement<in::World>{v.gamma(), v.gamma_beta()};
  };
  for (const Velocity& new_world : kNewWorlds) {
    const Scene old_scene = example(), new_scene = boosted(old_scene, new_world);
    const auto lines = [](const Scene& scene) {
      std::vector<Worldline> all = {std::get<Worldline>(scene.camera.motion)};
      for (const Object& object : scene.objects) all.push_back(object.worldline);
      return all;
    };
    const auto before = lines(old_scene), after = lines(new_scene);
    for (std::size_t i = 0; i < before.size(); ++i) {
      for (std::size_t j = 0; j < before.size(); ++j) {
        const auto d = before[i].reference - before[j].reference;
        const auto e = after[i].reference - after[j].reference;
        EXPECT_NEAR(minkowski_dot(d, d), minkowski_dot(e, e), 1e-9);
        const auto a = four_velocity(before[i].velocity), b = four_velocity(before[j].velocity);
        const auto c = four_velocity(after[i].velocity), f = four_velocity(after[j].velocity);
        EXPECT_NEAR(minkowski_dot(c, f) / minkowski_dot(a, b), 1, 1e-9);
        EXPECT_NEAR(minkowski_dot(e, c), minkowski_dot(d, a), 1e-9 * a.t);
      }
    }
  }
}

// A ray of the camera as an object sees it: origin and wave vector in the object's rest frame.
struct RestRay {
  Event<in::Rest> origin;
  WaveVector<in::Rest> k;
};
RestRay rest_ray(const Scene& scene, const Object& object, double tau, const Vec3& direction) {
  const Worldline& camera = std::get<Worldline>(scene.camera.motion);
  const Boost<in::World, in::Camera> world_from_camera(-camera.velocity);
  const AnchoredFrame<in::Rest> rest = object.worldline.rest_frame();
  return {rest(camera.at_proper_time(tau)),
          rest(world_from_camera(looking_along<in::Camera>(direction)))};
}

TEST(BoostedScene, RaysDifferByTheObjectsRotationAlone) {
  const Scene old_scene = example();
  for (const Velocity& new_world : kNewWorlds) {
    const Scene new_scene = boosted(old_scene, new_world);
    const Mat3 camera_turn =
        wigner_rotation(std::get<Worldline>(old_scene.camera.motion).velocity, new_world);
    EXPECT_LE(glm::length(std::get<AimDirection>(new_scene.camera.aim).direction -
                          camera_turn * Vec3(0, 0.6, -0.8)),
              1e-15);
    for (std::size_t i = 0; i < old_scene.objects.size(); ++i) {
      const Object &before = old_scene.objects[i], &after = new_scene.objects[i];
      EXPECT_EQ(after.clock, before.clock);
      const Mat3 turn(after.parts[0].object_from_mesh *
                      glm::inverse(before.parts[0].object_from_mesh));
      for (const Vec3& direction : random_directions(50, 11)) {
        const RestRay a = rest_ray(old_scene, before, 0.75, direction);
        const RestRay b = rest_ray(new_scene, after, 0.75, camera_turn * direction);
        ASSERT_NEAR(b.k.t / a.k.t, 1, 1e-11);
        ASSERT_LE(glm::length(b.k.x - turn * a.k.x), 1e-11 * -a.k.t);
        ASSERT_NEAR(b.origin.t, a.origin.t, 1e-9);
        ASSERT_LE(glm::length(b.origin.x - turn * a.origin.x), 1e-9);
      }
    }
  }
}

TEST(BoostedScene, BackAgainIsTheSame) {
  const Scene old_scene = example();
  for (const Velocity& new_world : kNewWorlds) {
    const Scene there_and_back = boosted(boosted(old_scene, new_world), -new_world);
    for (std::size_t i = 0; i < old_scene.objects.size(); ++i) {
      const Object &a = old_scene.objects[i], &b = there_and_back.objects[i];
      EXPECT_LE(glm::length(a.worldline.reference.x - b.worldline.reference.x), 1e-10);
      EXPECT_LE(
          largest_entry(Mat3(a.parts[0].object_from_mesh) - Mat3(b.parts[0].object_from_mesh)),
          1e-9);
    }
  }
}

TEST(BoostedScene, TheFrameClockStaysTheFramesOwn) {
  // Zero at the world's origin event, which both worlds share: the rest frame's time from there to
  // the object's reference event is the same in both descriptions.
  const Scene old_scene = example();
  for (const Velocity& new_world : kNewWorlds) {
    const Scene new_scene = boosted(old_scene, new_world);
    for (std::size_t i = 0; i < old_scene.objects.size(); ++i) {
      const auto time_at_reference = [](const Worldline& line) {
        return line.velocity.gamma() * line.reference.t -
               glm::dot(line.velocity.gamma_beta(), line.reference.x);
      };
      EXPECT_NEAR(time_at_reference(new_scene.objects[i].worldline),
                  time_at_reference(old_scene.objects[i].worldline), 1e-9);
    }
  }
}

TEST(BoostedScene, RefusesAPointToAimAt) {
  Scene scene = example();
  scene.camera.aim = AimPoint{{0, 0, 0}};
  EXPECT_THROW(boosted(scene, Velocity::from_beta({0.5, 0, 0})), std::invalid_argument);
}

}  // namespace
}  // namespace restframe
