// The camera's pose and its rays, against the reference camera and textbook formulas in long double.

#include "scene/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scene/error.h"
#include "support/long_vectors.h"
#include "support/velocity_grid.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::widened;

Camera looking_at(const Vec3& position, const Velocity& velocity, const Vec3& point) {
  Camera camera;
  camera.motion = Worldline{{2.5, position}, velocity};
  camera.aim = AimPoint{point};
  return camera;
}

// Where a camera that moves with u = gamma beta sees what is seen along `direction` in the world:
// the 4-vector of its light, boosted.
Long3 aberrated_sight(const Vec3& gamma_beta, const Vec3& direction) {
  const Long3 unit = reference::normalized(widened(direction));
  return reference::normalized(reference::boosted(widened(gamma_beta), {-1, unit}).x);
}

Vec3 forward(const CameraPose& pose) {
  return -pose.axes[2];
}

void expect_right_handed(const Mat3& axes) {
  const Mat3 product = glm::transpose(axes) * axes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 1e-14);
  }
  EXPECT_NEAR(glm::determinant(axes), 1, 1e-14);
}

TEST(CameraPose, LooksAlongItsDirectionAtRest) {
  Camera camera;
  camera.aim = AimDirection{{0, 0, -1}};
  const CameraPose pose = pose_at(camera, 0);
  EXPECT_EQ(pose.axes, Mat3(1));
  EXPECT_TRUE(pose.world_from_camera.is_identity());
}

TEST(CameraPose, TheDirectionIsInItsOwnAxesHoweverItMoves) {
  for (const Velocity& velocity : velocity_grid()) {
    Camera camera;
    std::get<Worldline>(camera.motion).velocity = velocity;
    camera.aim = AimDirection{glm::normalize(Vec3(1, 2, -3))};
    camera.up = {0.1, 5, 0.3};
    const CameraPose pose = pose_at(camera, 0);
    expect_right_handed(pose.axes);
    EXPECT_LT(glm::length(forward(pose) - glm::normalize(Vec3(1, 2, -3))), 1e-15);
    EXPECT_NEAR(glm::dot(pose.axes[0], camera.up), 0, 1e-14);
    EXPECT_GT(glm::dot(pose.axes[1], camera.up), 0);
  }
}

TEST(CameraPose, TheEventIsWhereItsClockShowsTheTime) {
  const Vec3 position(1, -2, 3);
  const CameraPose pose =
      pose_at(looking_at(position, Velocity::from_beta({0, 0, -0.6}), Vec3(9, 9, 9)), 4.0);
  EXPECT_DOUBLE_EQ(pose.event.t, 2.5 + 4.0 * 1.25);
  EXPECT_LT(glm::length(pose.event.x - (position + Vec3(0, 0, -0.6 * 1.25 * 4.0))), 1e-14);
}

TEST(CameraPose, APointIsAimedAtWhereItIsSeen) {
  const Vec3 point(-3, 0.5, 7);
  for (const Velocity& velocity : velocity_grid(1000)) {
    for (const double tau : {0.0, 1.25}) {
      const CameraPose pose = pose_at(looking_at({1, 2, 3}, velocity, point), tau);
      expect_right_handed(pose.axes);
      const Long3 seen = aberrated_sight(velocity.gamma_beta(), point - pose.event.x);
      EXPECT_LT(reference::angle_between(widened(forward(pose)), seen), 1e-9L)
          << "gamma " << velocity.gamma();
      const Vec3 center = Projection(pose, 1.0, 640, 360).direction(320, 180);
      EXPECT_LT(reference::angle_between(widened(center), seen), 1e-9L);
    }
  }
}

TEST(CameraPose, UpIsAberratedAsASightLine) {
  for (const Velocity& velocity : velocity_grid(1000)) {
    Camera camera = looking_at({1, 2, 3}, velocity, {-3, 0.5, 7});
    camera.up = {0.2, 3, -0.4};
    const CameraPose pose = pose_at(camera, 0);
    const Vec3 up = reference::narrowed(aberrated_sight(velocity.gamma_beta(), camera.up));
    const double across = glm::length(glm::cross(up, forward(pose)));
    EXPECT_NEAR(glm::dot(pose.axes[0], up), 0, 1e-9);
    EXPECT_GT(glm::dot(pose.axes[1], up), 0.99 * across);
  }
}

TEST(CameraPose, ATextbookAberration) {
  // tan(theta'/2) = sqrt((1-beta)/(1+beta)) tan(theta/2): at 0.6c what is abeam is seen at 53.13
  // degrees off the motion.
  const Camera camera = looking_at({0, 0, 0}, Velocity::from_beta({0, 0, -0.6}), Vec3(5, 0, 0));
  const Vec3 seen = forward(pose_at(camera, 0));
  EXPECT_NEAR(std::acos(-seen.z), 2 * std::atan(0.5), 1e-14);
  EXPECT_GT(seen.x, 0);
}

TEST(CameraPose, AimsThatLeaveTheOrientationOpenAreErrors) {
  Camera camera;
  camera.aim = AimDirection{{0, 1, 0}};
  EXPECT_THROW(pose_at(camera, 0), InputError);
  camera.aim = AimDirection{{0, -1, 0}};
  EXPECT_THROW(pose_at(camera, 0), InputError);
  camera.aim = AimDirection{{0, 0, -1}};
  camera.up = {0, 0, 0};
  EXPECT_THROW(pose_at(camera, 0), InputError);
  EXPECT_THROW(pose_at(looking_at({1, 2, 3}, {}, {1, 2, 3}), 0), InputError);
  EXPECT_THROW(pose_at(looking_at({1, 2, 3}, {}, {1, 7, 3}), 0), InputError);
}

TEST(CameraPose, APointThatTheCameraPassesIsAnErrorOnlyThere) {
  const Camera camera = looking_at({0, 0, 5}, Velocity::from_gamma_beta({0, 0, -1}), {0, 0, 0});
  EXPECT_NO_THROW(pose_at(camera, 4.9));
  EXPECT_THROW(pose_at(camera, 5), InputError);
  EXPECT_NO_THROW(pose_at(camera, 5.1));
}

Projection projection_of(double fov, int width, int height) {
  CameraPose pose;  // axes of the world
  return Projection(pose, fov, width, height);
}

TEST(Projection, TheCentreOfTheFilmIsStraightAhead) {
  EXPECT_LT(glm::length(projection_of(1.2, 640, 360).direction(320, 180) - Vec3(0, 0, -1)), 1e-15);
  EXPECT_LT(glm::length(projection_of(1.2, 3, 3).direction(1.5, 1.5) - Vec3(0, 0, -1)), 1e-15);
}

TEST(Projection, CornersAreWhereTheFieldOfViewPutsThem) {
  const double fov = std::numbers::pi / 2;
  const Projection projection = projection_of(fov, 200, 100);  // half height 1, half width 2
  EXPECT_LT(glm::length(projection.direction(0, 0) - glm::normalize(Vec3(-2, 1, -1))), 1e-15);
  EXPECT_LT(glm::length(projection.direction(200, 0) - glm::normalize(Vec3(2, 1, -1))), 1e-15);
  EXPECT_LT(glm::length(projection.direction(0, 100) - glm::normalize(Vec3(-2, -1, -1))), 1e-15);
  EXPECT_LT(glm::length(projection.direction(200, 100) - glm::normalize(Vec3(2, -1, -1))), 1e-15);
}

TEST(Projection, TheFieldOfViewIsVerticalForEveryShape) {
  for (const double fov : {0.01, 0.7, 2.6}) {
    for (const int width : {1, 50, 100, 3000}) {
      const Projection projection = projection_of(fov, width, 100);
      const Vec3 top = projection.direction(0.5 * width, 0);
      const Vec3 bottom = projection.direction(0.5 * width, 100);
      EXPECT_NEAR(std::acos(glm::dot(top, bottom)), fov, 1e-8);
      // Pixels are square.
      EXPECT_NEAR(glm::length(projection.step_x()), glm::length(projection.step_y()), 1e-15);
    }
  }
}

TEST(Projection, TurnsWithTheAxes) {
  Camera camera;
  camera.aim = AimDirection{{1, 0, 0}};
  camera.up = {0, 0, 1};
  const Projection projection(pose_at(camera, 0), std::numbers::pi / 2, 100, 100);
  // Right of +X with +Z up is -Y.
  EXPECT_LT(glm::length(projection.direction(100, 50) - glm::normalize(Vec3(1, -1, 0))), 1e-15);
  EXPECT_LT(glm::length(projection.direction(50, 0) - glm::normalize(Vec3(1, 0, 1))), 1e-15);
}

}  // namespace
}  // namespace restframe
