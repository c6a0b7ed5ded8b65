// Tracking (paper, section 4.4): the point that is tracked is seen at the picture's centre. From
// poses, and from rendered pictures, against long double.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <numbers>

#include "scene/scene.h"
#include "support/animation.h"
#include "support/long_vectors.h"
#include "support/observer_camera.h"
#include "support/velocity_grid.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;
using reference::widened;

Object object_at(const Event<in::World>& reference, const Velocity& velocity) {
  Object object;
  object.name = "thing";
  object.worldline = {reference, velocity};
  return object;
}

// Where an observer at rest in the world sees a point of the object: on a straight line in the
// world, where light from it arrives now, by the quadratic equation.
Long3 seen_in_world(const Object& object, const Vec3& offset, const Event<in::World>& observer) {
  const Long3 u = widened(object.worldline.velocity.gamma_beta());
  const long double gamma = reference::gamma_of(u);
  const Long3 v = u / gamma;
  const Event<in::World>& from = object.worldline.reference;
  const Long4 event = reference::boosted(-1.0L * u, {0, widened(offset)});
  const long double since = static_cast<long double>(observer.t) - from.t - event.t;
  const Long3 now = widened(from.x) - widened(observer.x) + event.x + since * v;
  const long double along = reference::dot(now, v);
  const long double root = std::sqrt(along * along + reference::dot(now, now) / (gamma * gamma));
  return reference::normalized(now - gamma * gamma * (root - along) * v);
}

TEST(Tracking, ThePointIsSeenStraightAhead) {
  const Vec3 offset(0.3, -0.2, 0.7);
  for (const double gamma : {1.0, 1.25, 7.0888, 1000.0}) {
    for (const Vec3& direction : direction_grid(4)) {
      const Object object = object_at({0.5, {1, 2, -3}}, Velocity::from_gamma(gamma, direction));
      Camera camera;
      camera.aim = AimTrack{at_rest_on(object, offset), object.name};
      for (const Vec3& beta : {Vec3(0, 0, 0), Vec3(0.3, -0.5, 0.2), Vec3(0, 0, -0.99)}) {
        camera.motion = Worldline{{0, {4, 0.5, 1}}, Velocity::from_beta(beta)};
        for (const double tau : {-8.0, -1.0, 0.0, 2.0, 20.0}) {
          const CameraPose pose = pose_at(camera, tau);
          const Long3 u = widened(Velocity::from_beta(beta).gamma_beta());
          const Long3 seen = reference::normalized(
              reference::boosted(u, {-1, seen_in_world(object, offset, pose.event)}).x);
          // A pixel of a picture of 1280 pixels and 60 degrees is 8e-4 radians.
          EXPECT_LT(reference::angle_between(widened(-pose.axes[2]), seen), 1e-7L)
              << "gamma " << gamma << ", clock " << tau;
        }
      }
    }
  }
}

TEST(Tracking, RestingOnAnObject) {
  const Object object = object_at({4, {1, 2, 3}}, Velocity::from_beta({0, 0, 0.6}));
  const Worldline along = at_rest_on(object, {5, 0, 1}, 2.0);
  // gamma = 1.25; two seconds of the clock later, one light-second ahead.
  EXPECT_NEAR(along.reference.t, 4 + 2 * 1.25 + 0.75, 1e-14);
  EXPECT_LT(glm::length(along.reference.x - Vec3(6, 2, 3 + 2 * 0.75 + 1.25)), 1e-14);
  EXPECT_EQ(along.velocity, object.worldline.velocity);
  // Now, the length along the motion is contracted.
  const Worldline now = at_rest_on(object, {5, 0, 1});
  EXPECT_EQ(now.reference.t, 4);
  EXPECT_LT(glm::length(now.reference.x - Vec3(6, 2, 3.8)), 1e-14);
}

TEST(Tracking, BothWaysToRestOnAnObjectAreOneWorldline) {
  for (const Velocity& velocity : velocity_grid(1000)) {
    const Object object = object_at({4, {1, 2, 3}}, velocity);
    const Worldline a = at_rest_on(object, {5, -2, 1}), b = at_rest_on(object, {5, -2, 1}, 0.5);
    const double gamma = velocity.gamma();
    EXPECT_LT(glm::length(a.rest_frame()(b.reference).x), 1e-14 * gamma * gamma);
  }
}

TEST(Tracking, ClockAtTheReference) {
  Object object = object_at({4, {1, 2, 3}}, Velocity::from_beta({0, 0, 0.6}));
  object.clock = 0.25;
  EXPECT_EQ(clock_at_reference(object), 0.25);
  object.frame_clock = true;
  EXPECT_NEAR(clock_at_reference(object), 1.25 * 4 - 0.75 * 3, 1e-15);
  EXPECT_LT(glm::length(at_rest_on(object, {0, 0, 0}, 2.75).reference.x - Vec3(1, 2, 3)), 1e-14);
}

// A sphere that passes at 0.99c; its origin is nearest at world time 0. In its asset's coordinates
// the tracked point is at (0.15, -0.1, 0.2); turned by 90 degrees about z and doubled.
const Vec3 kTracked(0.2, 0.3, 0.4);
const Vec3 kNearest(0, -3, -1);

std::string passing_sphere(const std::string& camera, double start, int pictures) {
  return fmt::format(R"(
[camera]
fov = {}
track = {{object = "sphere", point = [0.15, -0.1, 0.2]}}
{}
[animation]
start = {}
rate = 2
pictures = {}
[render]
resolution = [9, 9]
samples = 1
[output]
layers = ["beauty", "P"]
preview = false
[[object]]
name = "sphere"
sphere = {{radius = 0.5, fineness = 5}}
position = [0, -3, -1]
velocity = [0.99, 0, 0]
rotation = [0, 0, 90]
scale = 2
)",
                     1e-3 * 180 / std::numbers::pi, camera, start, pictures);
}

// Every ray goes from the observer through the P of its pixel. In the sphere's rest frame it leaves
// the line from the observer to the tracked point by these tangents.
glm::dvec2 off_tracked(const ExrPicture& picture, int x, int y, const Long3& observer) {
  const Long3 ahead = reference::normalized(widened(kTracked) - observer);
  const Long3 aside = reference::normalized(reference::cross(ahead, Long3{0.3L, 0.5L, 0.8L}));
  const Long3 p{picture.at("P.X", x, y), picture.at("P.Y", x, y), picture.at("P.Z", x, y)};
  const Long3 ray = p - observer;
  const long double depth = reference::dot(ray, ahead);
  return {static_cast<double>(reference::dot(ray, aside) / depth),
          static_cast<double>(reference::dot(ray, reference::cross(aside, ahead)) / depth)};
}

// The film coordinates where the tracked point is seen: those of no tangent at all, by the straight
// line through all pixels, since the field is so narrow.
glm::dvec2 film_of_tracked(const ExrPicture& picture, const Long3& observer) {
  const double unit =
      glm::length(off_tracked(picture, 8, 8, observer) - off_tracked(picture, 0, 0, observer));
  Mat3 normal(0);
  Vec3 right_x(0), right_y(0);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 9; ++x) {
      const Vec3 row(1, off_tracked(picture, x, y, observer) / unit);
      normal += glm::outerProduct(row, row);
      right_x += (x + 0.5) * row;
      right_y += (y + 0.5) * row;
    }
  }
  const Mat3 inverse = glm::inverse(normal);
  return {(inverse * right_x).x, (inverse * right_y).x};
}

void expect_centred(const std::string& camera_lines, const reference::ObserverCamera& camera,
                    double start, int pictures) {
  const auto all = rendered_animation(RESTFRAME_PROGRAM,
                                      passing_sphere(camera_lines, start, pictures), pictures);
  const Long3 u = widened(reference::gamma_beta_from_beta({0.99, 0, 0}));
  double worst = 0;
  for (int i = 0; i < pictures; ++i) {
    const Long4 event = reference::camera_event(camera, start + 0.5 * i);
    const Long4 observer = reference::boosted(u, {event.t, event.x - widened(kNearest)});
    const ExrPicture& picture = all[static_cast<std::size_t>(i)];
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) ASSERT_GT(picture.at("A", x, y), 0) << "picture " << i;
    }
    const glm::dvec2 film = film_of_tracked(picture, observer.x);
    worst = std::max(worst, glm::length(film - glm::dvec2(4.5)));
    EXPECT_NEAR(film.x, 4.5, 0.01) << "picture " << i;
    EXPECT_NEAR(film.y, 4.5, 0.01) << "picture " << i;
  }
  ::testing::Test::RecordProperty("pixels_off_centre", fmt::format("{:.5f}", worst));
}

TEST(TrackingPictures, StayCentredForACameraAtRest) {
  // Seen 3 light-seconds ahead 1.2 s after the world's time 0, abeam at 3.2 s, far off at 12 s.
  expect_centred("position = [0, 0, 0]", {}, 0.4, 24);
}

TEST(TrackingPictures, StayCentredForAMovingCamera) {
  reference::ObserverCamera camera;
  camera.position = {0.5, 0, 0.5};
  camera.time = 1;
  camera.gamma_beta = reference::gamma_beta_from_beta({0.3, 0.5, -0.2});
  expect_centred("position = [0.5, 0, 0.5]\ntime = 1\nvelocity = [0.3, 0.5, -0.2]", camera, -0.5,
                 24);
}

}  // namespace
}  // namespace restframe
