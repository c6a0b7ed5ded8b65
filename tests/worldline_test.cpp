#include "physics/worldline.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/long_vectors.h"
#include "support/velocity_grid.h"

namespace restframe {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// An observer at the origin at time 0 sees, at distance d, a point that is at R now and moves with
// v: |R - v d| = d, so d^2/gamma^2 + 2 d R.v - r^2 = 0, of which the positive solution is d =
// gamma^2 [-R.v + sqrt((R.v)^2 + r^2/gamma^2)].
long double delay(const reference::Long3& R, const reference::Long3& u) {
  using namespace reference;
  const long double gamma = gamma_of(u), along = gamma * dot(R, u);
  const long double root = std::sqrt(along * along + gamma * gamma * dot(R, R));
  return along > 0 ? gamma * gamma * dot(R, R) / (along + root) : root - along;
}

TEST(Worldline, ProperTimeRunsSlow) {
  const Worldline ship{{5, {1, 2, 3}}, Velocity::from_beta({0, 0.6, 0})};
  const Event<in::World> e = ship.at_proper_time(4);
  EXPECT_DOUBLE_EQ(e.t, 10);  // gamma = 1.25
  EXPECT_DOUBLE_EQ(e.x.x, 1);
  EXPECT_DOUBLE_EQ(e.x.y, 5);
  EXPECT_DOUBLE_EQ(e.x.z, 3);
}

TEST(Worldline, RestsAtTheOriginOfItsRestFrame) {
  for (const Velocity& v : velocity_grid(1000)) {
    const Worldline line{{-3, {10, -4, 0.5}}, v};
    for (double tau : {-50.0, -0.1, 0.0, 7.0}) {
      const Event<in::Rest> e = line.rest_frame()(line.at_proper_time(tau));
      const double tolerance = 8 * kEpsilon * v.gamma() * (10 + v.gamma() * std::abs(tau));
      EXPECT_NEAR(e.t, tau, tolerance);
      EXPECT_LE(glm::length(e.x), tolerance);
    }
  }
}

TEST(SeenEvent, MatchesTheClosedFormOfDelay) {
  using namespace reference;
  const Event<in::World> observer{0, {0, 0, 0}};
  for (const Velocity& v : velocity_grid()) {
    const Long3 u = widened(v.gamma_beta());
    for (const Vec3& R : {Vec3(0, 0, -7), Vec3(3, 4, 1), Vec3(-100, 20, 5), Vec3(0.01, 0, 0)}) {
      const Worldline point{{0, R}, v};
      const Event<in::Rest> seen = seen_event(point.rest_frame(), observer, {0, 0, 0});
      const double d = static_cast<double>(delay(widened(R), u));
      // The point's clock shows 0 at R and runs slow: -d/gamma where it is seen.
      EXPECT_NEAR(seen.t, -d / v.gamma(), 8 * kEpsilon * v.gamma() * glm::length(R));
      const Event<in::World> world = point.rest_frame().to_world(seen);
      const double tolerance = 16 * kEpsilon * v.gamma() * v.gamma() * glm::length(R);
      EXPECT_NEAR(world.t, -d, tolerance);
      EXPECT_LE(glm::length(world.x - (R - v.beta() * d)), tolerance);
    }
  }
}

TEST(SeenEvent, OfAPointAsideFromTheWorldlineToo) {
  using namespace reference;
  const Event<in::World> observer{2, {1, -1, 4}};
  const Vec3 point(0.5, -2, 1.5);
  for (const Velocity& v : velocity_grid(1000)) {
    const Worldline line{{-1, {20, 3, -8}}, v};
    const Long3 u = widened(v.gamma_beta());
    const long double gamma = gamma_of(u);
    // Where the point is at the observer's time: its rest time then is (t - t0 - u.p) / gamma.
    const long double rest_time = (3 - dot(u, widened(point))) / gamma;
    const Long4 now = boosted(-1.0L * u, {rest_time, widened(point)});
    const Long3 R = Long3{20, 3, -8} + now.x - widened(observer.x);
    const long double expected = rest_time - delay(R, u) / gamma;
    const Event<in::Rest> seen = seen_event(line.rest_frame(), observer, point);
    EXPECT_EQ(seen.x, point);
    EXPECT_NEAR(seen.t, static_cast<double>(expected), 1e-14 * v.gamma() * 30);
  }
}

TEST(SeenEvent, IsOnThePastLightCone) {
  const Event<in::World> observer{2, {1, -1, 4}};
  for (const Velocity& v : velocity_grid(1000)) {
    const Worldline line{{-1, {20, 3, -8}}, v};
    const Event<in::World> seen =
        line.rest_frame().to_world(seen_event(line.rest_frame(), observer, {0.1, 0.2, 0.3}));
    EXPECT_LT(seen.t, observer.t);
    const double distance = glm::length(seen.x - observer.x);
    EXPECT_NEAR(observer.t - seen.t, distance, 1e-13 * v.gamma() * v.gamma() * 30);
  }
}

TEST(AnchoredFrame, WorldRoundTrip) {
  for (const Velocity& v : velocity_grid(1000)) {
    const AnchoredFrame<in::Rest> rest{{4, {-2, 9, 1}}, Boost<in::Rest, in::World>(v)};
    const Event<in::World> e{-1, {3, 0.5, -6}};
    const Event<in::World> back = rest.to_world(rest(e));
    const double tolerance = 32 * kEpsilon * v.gamma() * v.gamma() * 15;
    EXPECT_NEAR(back.t, e.t, tolerance);
    EXPECT_LE(glm::length(back.x - e.x), tolerance);
  }
}

TEST(AnchoredFrame, FarAwayAndLaterIsTheSame) {
  const Displacement<in::World> shift{1e6, {1e6, -1e6, 1e6}};
  // Multiples of 1/1024 stay exact a million away, so that nothing but the frame's own arithmetic
  // counts.
  const Event<in::World> anchor{0.5, {-12.25, 3, 0.125}};
  const std::vector<Event<in::World>> events = {
      {7.75, {1, -2.5, 40}}, {-300.0078125, {250.5, 0.0009765625, -3}}, {0, {0, 0, 0}}};
  for (const Velocity& v : velocity_grid(1000)) {
    const AnchoredFrame<in::Rest> near{anchor, Boost<in::Rest, in::World>(v)};
    const AnchoredFrame<in::Rest> far{anchor + shift, Boost<in::Rest, in::World>(v)};
    for (const auto& e : events) {
      const Event<in::Rest> expected = near(e), got = far(e + shift);
      EXPECT_NEAR(got.t, expected.t, 1e-9);
      EXPECT_LE(glm::length(got.x - expected.x), 1e-9);
      const Event<in::Rest> seen = seen_event(near, e, {1, 2, 3});
      EXPECT_NEAR(seen_event(far, e + shift, {1, 2, 3}).t, seen.t, 1e-9);
    }
  }
}

}  // namespace
}  // namespace restframe
