// Cameras on keyed and accelerated paths, against closed forms, quadrature and integration in long
// double.

#include "scene/camera_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/long_vectors.h"
#include "support/velocity_grid.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;
using reference::widened;

KeyedPath path_of(double time, const std::vector<PathKey>& keys) {
  return {time, keys, false};
}
KeyedPath stating(double time, const std::vector<PathKey>& keys) {
  return {time, keys, true};
}

void expect_at(const CameraState& state, double t, const Vec3& x, double precision = 1e-14) {
  EXPECT_NEAR(state.event.t, t, precision * (1 + std::abs(t)));
  EXPECT_LE(glm::length(state.event.x - x), precision * (1 + glm::length(x)));
}

TEST(KeyedPath, TheVelocityFollowsFromThePath) {
  // gamma beta = 0.75, that is 0.6c, for 4 s of the camera's time; then 2.4 in 1 s, 12/13 c.
  const KeyedPath path =
      path_of(7, {{0, {1, 0, 0}, {}}, {4, {1, 3, 0}, {}}, {5, {1, 3, -2.4}, {}}});
  expect_at(path.state_at(0), 7, {1, 0, 0});
  expect_at(path.state_at(1), 7 + 1.25, {1, 0.75, 0});
  expect_at(path.state_at(4), 7 + 5, {1, 3, 0});
  expect_at(path.state_at(4.5), 7 + 5 + 1.3, {1, 3, -1.2});
  expect_at(path.state_at(5), 7 + 5 + 2.6, {1, 3, -2.4});
  EXPECT_LT(glm::length(path.state_at(0).velocity.beta() - Vec3(0, 0.6, 0)), 1e-15);
  EXPECT_LT(glm::length(path.state_at(3.9).velocity.beta() - Vec3(0, 0.6, 0)), 1e-15);
  EXPECT_LT(glm::length(path.state_at(4).velocity.beta() - Vec3(0, 0, -12.0 / 13)), 1e-15);
  EXPECT_LT(glm::length(path.state_at(5).velocity.beta() - Vec3(0, 0, -12.0 / 13)), 1e-15)
      << "at the last key it moves as before it";
}

TEST(KeyedPath, BeforeAndAfterItRests) {
  const KeyedPath path = path_of(0, {{1, {0, 0, 0}, {}}, {2, {0, 0, 0.75}, {}}});
  expect_at(path.state_at(0), 0, {0, 0, 0});
  expect_at(path.state_at(-3), -3, {0, 0, 0});
  expect_at(path.state_at(1), 1, {0, 0, 0});
  expect_at(path.state_at(2), 2.25, {0, 0, 0.75});
  expect_at(path.state_at(5), 5.25, {0, 0, 0.75});
  EXPECT_EQ(path.state_at(0.5).velocity, Velocity());
  EXPECT_EQ(path.state_at(2.5).velocity, Velocity());
}

TEST(KeyedPath, ClockZeroHasTheGivenWorldTimeWhereverItFalls) {
  for (const double shift : {-7.0, -0.5, 0.0, 0.25, 1.5, 3.0}) {
    const KeyedPath path = path_of(
        100,
        {{shift, {0, 0, 0}, {}}, {shift + 1, {0, 0.75, 0}, {}}, {shift + 2, {2.4, 0.75, 0}, {}}});
    EXPECT_NEAR(path.state_at(0).event.t, 100, 1e-13) << shift;
    EXPECT_NEAR(path.state_at(shift + 2).event.t - path.state_at(shift).event.t, 1.25 + 2.6, 1e-13);
  }
}

TEST(KeyedPath, OneKeyHolds) {
  const KeyedPath path = path_of(3, {{10, {1, 2, 3}, {}}});
  expect_at(path.state_at(-1), 2, {1, 2, 3});
  expect_at(path.state_at(10), 13, {1, 2, 3});
  expect_at(path.state_at(11), 14, {1, 2, 3});
}

TEST(KeyedPath, AnyPathStaysBelowLightAndEventsFollowItsVelocity) {
  const KeyedPath path =
      path_of(0, {{0, {0, 0, 0}, {}}, {1e-3, {1, 0, 0}, {}}, {2, {1, 5, -9}, {}}});
  for (const double tau : {1e-4, 5e-4, 0.5, 1.9}) {
    const CameraState a = path.state_at(tau), b = path.state_at(tau + 1e-5);
    const auto d = b.event - a.event;
    EXPECT_NEAR(minkowski_dot(d, d), -1e-10, 1e-15);
    EXPECT_LT(glm::length(d.x / 1e-5 - a.velocity.gamma_beta()), 1e-7 * a.velocity.gamma());
  }
}

// Simpson's rule, finely.
long double integral(const std::function<long double(long double)>& f, long double from,
                     long double to) {
  constexpr int n = 20'000;
  const long double h = (to - from) / n;
  long double sum = f(from) + f(to);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * h);
  return sum * h / 3;
}

TEST(KeyedPath, WorldTimeUnderStatedVelocities) {
  std::vector<Vec3> ends = {{0, 0, 0},       {0, 0, 1e-9},     {0, 0, 1e-5},     {0.75, 0, 0},
                            {0, 2.4, 0},     {0, -2.4, 0},     {30, -1, 0.2},    {-25, 7, 3},
                            {1e-3, 1e3, 10}, {1e-3, 1e3, 9.9}, {0.7500001, 0, 0}};
  for (const Vec3& u : ends) {
    for (const Vec3& v : ends) {
      const KeyedPath path = stating(0, {{0, {1, 1, 1}, Velocity::from_gamma_beta(u)},
                                         {3, {1, 1, 2}, Velocity::from_gamma_beta(v)}});
      for (const double tau : {0.3, 1.5, 3.0}) {
        const long double expected = integral(
            [&](long double at) {
              return reference::gamma_of(widened(u) + at / 3 * (widened(v) - widened(u)));
            },
            0, tau);
        EXPECT_NEAR(path.state_at(tau).event.t / static_cast<double>(expected), 1, 2e-13)
            << u.x << ' ' << u.y << " to " << v.x << ' ' << v.y << " at " << tau;
      }
    }
  }
}

TEST(KeyedPath, StatedVelocitiesSayHowFastPositionsWhere) {
  const auto beta = [](double z) { return Velocity::from_gamma_beta({0, 0, z}); };
  const KeyedPath path = stating(1, {{0, {0, 0, 0}, beta(-1)}, {2, {4, 0, 0}, beta(-3)}});
  EXPECT_LT(glm::length(path.state_at(0.5).velocity.gamma_beta() - Vec3(0, 0, -1.5)), 1e-15);
  EXPECT_LT(glm::length(path.state_at(0.5).event.x - Vec3(1, 0, 0)), 1e-15);
  EXPECT_LT(glm::length(path.state_at(2).velocity.gamma_beta() - Vec3(0, 0, -3)), 1e-15);
  // Outside, the position holds; clock and aberration are the key's.
  const double end = path.state_at(2).event.t;
  EXPECT_NEAR(path.state_at(5).event.t, end + 3 * std::sqrt(10.0), 1e-13);
  EXPECT_EQ(path.state_at(5).velocity, beta(-3));
  EXPECT_EQ(path.state_at(5).event.x, Vec3(4, 0, 0));
  EXPECT_NEAR(path.state_at(-2).event.t, 1 - 2 * std::sqrt(2.0), 1e-14);
  EXPECT_EQ(path.state_at(-2).event.x, Vec3(0, 0, 0));
}

AcceleratedPath from_rest(const std::vector<AccelerationLeg>& legs) {
  return {Worldline{}, legs};
}

TEST(AcceleratedPath, IsHyperbolicMotion) {
  for (const double a : {1e-200, 1e-9, 1e-3, 0.5, 2.0, 7.0}) {
    const AcceleratedPath path = from_rest({{2, {0, 0, -a}}});
    for (const double tau : {1e-9, 0.1, 1.0, 2.0}) {
      const CameraState state = path.state_at(tau);
      const long double r = static_cast<long double>(a) * tau;
      const long double t = std::sinh(r) / a;
      const long double x = 2 * std::sinh(r / 2) * std::sinh(r / 2) / a;
      EXPECT_NEAR(state.event.t / static_cast<double>(t), 1, 1e-15) << a << ' ' << tau;
      EXPECT_NEAR(state.event.x.z / -static_cast<double>(x), 1, 2e-15) << a << ' ' << tau;
      EXPECT_NEAR(state.velocity.gamma_beta().z / -static_cast<double>(std::sinh(r)), 1, 1e-15);
      EXPECT_EQ(state.event.x.x, 0);
    }
  }
}

TEST(AcceleratedPath, CoastsWithoutAcceleration) {
  const Worldline start{{1, {2, 3, 4}}, Velocity::from_beta({0.6, 0, 0})};
  const AcceleratedPath path(start, {{2, {0, 0, 0}}});
  for (const double tau : {-3.0, 0.0, 1.0, 2.0, 9.0}) {
    const CameraState state = path.state_at(tau);
    const Event<in::World> expected = start.at_proper_time(tau);
    expect_at(state, expected.t, expected.x);
    EXPECT_LT(glm::length(state.velocity.gamma_beta() - Vec3(0.75, 0, 0)), 1e-15);
  }
}

TEST(AcceleratedPath, CoastsBeforeAndAfter) {
  const AcceleratedPath path({{5, {1, 0, 0}}, Velocity::from_beta({0, 0, 0.6})}, {{1, {0, 0, 2}}});
  expect_at(path.state_at(-4), 5 - 5, {1, 0, -3});
  const CameraState end = path.state_at(1), later = path.state_at(3);
  EXPECT_EQ(later.velocity, end.velocity);
  expect_at(later, end.event.t + 2 * end.velocity.gamma(),
            end.event.x + 2.0 * end.velocity.gamma_beta());
  // Rapidities of one direction add.
  EXPECT_NEAR(std::asinh(end.velocity.gamma_beta().z), std::atanh(0.6) + 2, 1e-14);
}

// The published table of the relativistic rocket (1.03 light-years a year squared): after five years
// of its own, 83.7 years have passed at home, it is 82.7 light-years off, gamma is 86.2. Unit: year.
TEST(AcceleratedPath, TheRelativisticRocket) {
  const CameraState state = from_rest({{5, {0, 1.03, 0}}}).state_at(5);
  EXPECT_NEAR(state.event.t, 83.7, 0.05);
  EXPECT_NEAR(state.event.x.y, 82.7, 0.05);
  EXPECT_NEAR(state.velocity.gamma(), 86.2, 0.05);
}

// 1 g, speeding up and slowing down out, and likewise back.
TEST(AcceleratedPath, TheRocketsRoundTrip) {
  const double year = 365.25 * 86400, g = 9.80665 / 299792458;
  const double quarter = 5 * year;
  const AcceleratedPath path =
      from_rest({{quarter, {0, g, 0}}, {2 * quarter, {0, -g, 0}}, {quarter, {0, g, 0}}});
  const CameraState half = path.state_at(2 * quarter), home = path.state_at(4 * quarter);
  EXPECT_NEAR(half.event.x.y / (2 * (std::cosh(g * quarter) - 1) / g), 1, 1e-12);
  EXPECT_NEAR(home.event.t / (4 * std::sinh(g * quarter) / g), 1, 1e-12);
  EXPECT_LT(glm::length(home.event.x), 1e-11 * half.event.x.y);
  EXPECT_LT(glm::length(home.velocity.gamma_beta()), 1e-10);
  EXPECT_LT(glm::length(half.velocity.gamma_beta()), 1e-10);
}

// A four-vector that the observer carries without turning it (Fermi-Walker): of constant length a
// along the motion's hyperbola. d(event) = U, dU = A, dA = (A.A) U.
struct Hyperbola {
  Long4 event, velocity, acceleration;
};
Long4 operator+(const Long4& a, const Long4& b) {
  return {a.t + b.t, reference::operator+(a.x, b.x)};
}
Long4 operator*(long double s, const Long4& a) {
  return {s * a.t, reference::operator*(s, a.x)};
}
Hyperbola moved(const Hyperbola& h, long double s, const Hyperbola& by) {
  return {h.event + s * by.event, h.velocity + s * by.velocity,
          h.acceleration + s * by.acceleration};
}
Hyperbola rate(const Hyperbola& h) {
  const Long4& a = h.acceleration;
  return {h.velocity, a, (reference::dot(a.x, a.x) - a.t * a.t) * h.velocity};
}
Hyperbola integrated(Hyperbola h, long double duration, int steps) {
  const long double d = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Hyperbola k1 = rate(h), k2 = rate(moved(h, d / 2, k1)), k3 = rate(moved(h, d / 2, k2)),
                    k4 = rate(moved(h, d, k3));
    h = moved(moved(moved(moved(h, d / 6, k1), d / 3, k2), d / 3, k3), d / 6, k4);
  }
  return h;
}

TEST(AcceleratedPath, SidewaysMotionComposes) {
  const Worldline start{{3, {1, -2, 0.5}}, Velocity::from_beta({0.8, 0.1, -0.2})};
  const std::vector<AccelerationLeg> legs = {
      {1.5, {0, 0, -0.5}}, {0.75, {1, 2, 0}}, {2, {0, 0, 0}}, {1, {-1, 0.3, 0.7}}};
  const AcceleratedPath path(start, legs);
  Long4 event{start.reference.t, widened(start.reference.x)};
  Long3 u = widened(start.velocity.gamma_beta());
  double clock = 0;
  for (const AccelerationLeg& leg : legs) {
    const Hyperbola begin{event,
                          {reference::gamma_of(u), u},
                          reference::boosted(-1.0L * u, {0, widened(leg.acceleration)})};
    for (const double part : {0.1, 0.6, 1.0}) {
      const Hyperbola now = integrated(begin, part * leg.duration, 3000);
      const CameraState state = path.state_at(clock + part * leg.duration);
      EXPECT_NEAR(state.event.t, static_cast<double>(now.event.t), 1e-12);
      EXPECT_LT(glm::length(state.event.x - reference::narrowed(now.event.x)), 1e-12);
      EXPECT_LT(glm::length(state.velocity.gamma_beta() - reference::narrowed(now.velocity.x)),
                1e-12);
      event = now.event;
      u = now.velocity.x;
    }
    clock += leg.duration;
  }
}

TEST(AcceleratedPath, ALegInPiecesIsTheSame) {
  const Vec3 a(0, 0.3, -0.4);
  const AcceleratedPath whole = from_rest({{3, a}}),
                        pieces = from_rest({{1, a}, {0.5, a}, {1.5, a}});
  for (const double tau : {0.5, 1.2, 1.5, 2.9, 3.5}) {
    const CameraState expected = whole.state_at(tau);
    expect_at(pieces.state_at(tau), expected.event.t, expected.event.x);
  }
}

TEST(AcceleratedPath, ReachesAGammaOfAThousand) {
  const double rapidity = std::acosh(1000.0);
  const AcceleratedPath path = from_rest({{rapidity, {1, 0, 0}}, {rapidity, {-1, 0, 0}}});
  EXPECT_NEAR(path.state_at(rapidity).velocity.gamma(), 1000, 1e-9);
  EXPECT_NEAR(path.state_at(2 * rapidity).event.x.x, 2 * 999, 1e-8);
  EXPECT_NEAR(path.state_at(2 * rapidity).event.t, 2 * std::sqrt(999.0 * 1001), 1e-8);
  EXPECT_NEAR(path.state_at(2 * rapidity).velocity.gamma_beta().x, 0, 1e-8);
}

TEST(CameraMotion, UniformMotionIsTheWorldlines) {
  const CameraMotion motion = Worldline{{1, {0, 0, 2}}, Velocity::from_beta({0, 0.8, 0})};
  expect_at(state_at(motion, 3), 1 + 5, {0, 4, 2});
  EXPECT_LT(glm::length(state_at(motion, 3).velocity.beta() - Vec3(0, 0.8, 0)), 1e-15);
}

}  // namespace
}  // namespace restframe
