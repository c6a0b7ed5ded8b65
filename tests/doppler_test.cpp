#include "physics/doppler.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "support/long_vectors.h"
#include "support/velocity_grid.h"

// D = nu_observed / nu_emitted. A source of velocity v seen along the unit vector e (from the
// observer to where it is seen) has D = 1 / (gamma (1 + e.v)): gamma from its slow clock, the rest
// from the distance that the light of the next tick has to go, more when the source recedes (e.v >
// 0).

namespace restframe {
namespace {

using RestFromWorld = Boost<in::Rest, in::World>;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double doppler_seen(const Velocity& source, const Vec3& sight) {
  return doppler_factor(RestFromWorld(source)(looking_along<in::World>(sight)));
}

// Unit vectors at an angle theta from `axis`, in long double until the end.
Vec3 at_angle(const Vec3& axis, long double theta, long double azimuth) {
  using namespace reference;
  const Long3 w = normalized(widened(axis));
  const Long3 helper = std::abs(w.x) < 0.5L ? Long3{1, 0, 0} : Long3{0, 1, 0};
  const Long3 a = normalized(cross(w, helper)), b = cross(w, a);
  return narrowed(std::cos(theta) * w +
                  std::sin(theta) * (std::cos(azimuth) * a + std::sin(azimuth) * b));
}

TEST(Doppler, HeadOnMatchesTheTable) {
  for (const Vec3& direction : direction_grid()) {
    const auto head_on = [&](double beta) {
      return doppler_seen(Velocity::from_beta(beta * direction), -direction);
    };
    EXPECT_NEAR(head_on(0.6), 2.0, 1e-14);
    EXPECT_NEAR(head_on(0.8), 3.0, 1e-14);
    EXPECT_NEAR(head_on(0.9), 4.3589, 5e-5);
    EXPECT_NEAR(head_on(0.99), 14.1067, 5e-5);
  }
}

TEST(Doppler, AlongTheMotionIsTheSquareRootFormula) {
  for (double beta : {0.0, 1e-300, 1e-12, 1e-3, 0.5, 0.9, 0.99, 0.999, 1 - 1e-9}) {
    const Velocity v = Velocity::from_beta({0, 0, beta});
    const long double b = beta;
    const double expected = static_cast<double>(std::sqrt((1 + b) / (1 - b)));
    EXPECT_NEAR(doppler_seen(v, {0, 0, -1}), expected, 8 * kEpsilon * expected) << beta;
    EXPECT_NEAR(doppler_seen(v, {0, 0, 1}), 1 / expected, 8 * kEpsilon / expected) << beta;
  }
}

TEST(Doppler, SidewaysIsTimeDilationAlone) {
  for (double gamma : {1.0, 1 + 1e-9, 1.25, 2.2942, 7.0888, 1000.0, 1e6}) {
    EXPECT_DOUBLE_EQ(doppler_seen(Velocity::from_gamma(gamma, {1, 0, 0}), {0, 0.6, -0.8}),
                     1 / gamma);
    EXPECT_DOUBLE_EQ(doppler_seen(Velocity::from_gamma(gamma, {0, 0.8, 0.6}), {1, 0, 0}),
                     1 / gamma);
  }
}

TEST(Doppler, CrossesOneAtTheClosedFormsAngle) {
  // cos(theta) = sqrt((gamma-1)/(gamma+1)), theta from v to the direction from object to observer,
  // which is against the sight line.
  for (const Vec3& axis : direction_grid(3)) {
    for (double gamma : {1.01, 1.25, 2.2942, 7.0888, 1000.0}) {
      const long double theta = std::acos(std::sqrt((gamma - 1.0L) / (gamma + 1.0L)));
      for (double azimuth : {0.0, 1.0, 4.0}) {
        const Vec3 sight = -at_angle(axis, theta, azimuth);
        EXPECT_NEAR(doppler_seen(Velocity::from_gamma(gamma, axis), sight), 1.0,
                    8 * kEpsilon * gamma);
      }
    }
  }
}

TEST(Doppler, MatchesTheClosedFormOverTheGrid) {
  for (const Velocity& v : velocity_grid()) {
    for (const Vec3& sight : direction_grid()) {
      const long double expected =
          1 / reference::frequency_seen_from(reference::widened(v.gamma_beta()),
                                             reference::widened(sight));
      // A rounding of the directions turns them by epsilon, which changes ln D by up to gamma
      // epsilon.
      const double tolerance = 4 * kEpsilon * v.gamma() + 4 * kEpsilon;
      EXPECT_NEAR(static_cast<double>(doppler_seen(v, sight) / expected), 1.0, tolerance);
    }
  }
}

// With u = gamma beta and theta the angle between -v and the sight line,
// 1/D = gamma - u cos(theta) = 1/(gamma + u) + 2 u sin^2(theta/2).
double worst_relative_error(double gamma) {
  const long double u = std::sqrt((gamma - 1.0L) * (gamma + 1.0L));
  double worst = 0;
  for (const Vec3& axis : direction_grid()) {
    const Velocity v = Velocity::from_gamma(gamma, axis);
    for (long double exponent = -10; exponent < 0.49L; exponent += 0.05L) {
      const long double theta = exponent < -9.9L ? 0 : std::pow(10.0L, exponent);
      const long double half_sine = std::sin(theta / 2);
      const long double expected = 1 / (1 / (gamma + u) + 2 * u * half_sine * half_sine);
      const double got = doppler_seen(v, -at_angle(axis, theta, 20 * exponent));
      worst = std::max(worst, std::abs(static_cast<double>(got / expected - 1)));
    }
  }
  return worst;
}

TEST(Doppler, KeepsItsDigitsInTheWorstDirection) {
  EXPECT_LT(worst_relative_error(10), 1e-14);
  EXPECT_LT(worst_relative_error(1000), 1e-12);
  EXPECT_LT(worst_relative_error(1e6), 1e-9);
}

TEST(Doppler, IsTheProductOverFrames) {
  // From camera to world to object: the frequencies multiply, whatever the velocities.
  for (const Velocity& camera : velocity_grid(10, 1)) {
    const Boost<in::World, in::Camera> world_from_camera(-camera);
    for (const Velocity& object : velocity_grid(10, 0)) {
      const Vec3 sight = glm::normalize(Vec3(0.2, -0.5, 1));
      const WaveVector<in::World> k = world_from_camera(looking_along<in::Camera>(sight));
      const double product = -1 / k.t * doppler_seen(object, sight_direction(k));
      ASSERT_NEAR(doppler_factor(RestFromWorld(object)(k)) / product, 1.0, 1e-13);
    }
  }
}

TEST(Aberration, HalvesOfTangentsScale) {
  // tan(theta'/2) = sqrt((1-beta)/(1+beta)) tan(theta/2), theta from the velocity to the sight
  // line; the root is gamma - u. Azimuths stay.
  for (const Vec3& axis : direction_grid(2)) {
    for (double gamma : {1.0, 1.0001, 1.25, 7.0888, 1000.0}) {
      const long double u = std::sqrt((gamma - 1.0L) * (gamma + 1.0L));
      const RestFromWorld boost(Velocity::from_gamma(gamma, axis));
      for (long double theta : {0.0L, 1e-3L, 0.5L, 1.5L, 2.5L, 3.1L, 3.1415L}) {
        const long double expected = 2 * std::atan(std::tan(theta / 2) / (gamma + u));
        const Vec3 seen = aberrated(boost, at_angle(axis, theta, 0.7L));
        EXPECT_LE(glm::length(seen - at_angle(axis, expected, 0.7L)), 16 * kEpsilon * gamma)
            << "gamma " << gamma << ", theta " << static_cast<double>(theta);
      }
    }
  }
}

TEST(Aberration, SolidAngleShrinksByTheSquareOfD) {
  // The Jacobian by central differences over a small triangle of directions: an area da of the
  // observer's sky shows D^2 da of the source's, so what is seen is D^-2 of what there is.
  const double step = 1e-5;
  for (const Vec3& axis : direction_grid(2)) {
    for (double beta : {0.0, 1e-12, 0.3, 0.9, 0.99}) {
      const Velocity v = Velocity::from_beta(beta * axis);
      const RestFromWorld boost(v);
      for (const Vec3& sight : random_directions(8, 5)) {
        const Vec3 a = at_angle(sight, std::numbers::pi_v<long double> / 2, 0);
        const Vec3 b = at_angle(sight, std::numbers::pi_v<long double> / 2,
                                std::numbers::pi_v<long double> / 2);
        const auto derivative = [&](const Vec3& side) {
          return (aberrated(boost, glm::normalize(sight + step * side)) -
                  aberrated(boost, glm::normalize(sight - step * side))) /
                 (2 * step);
        };
        const double jacobian = glm::length(glm::cross(derivative(a), derivative(b)));
        const double d = doppler_seen(v, sight);
        EXPECT_NEAR(jacobian / (d * d), 1.0, 1e-6) << "beta " << beta << ", D " << d;
      }
    }
  }
}

}  // namespace
}  // namespace restframe
