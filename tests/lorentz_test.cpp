#include "physics/lorentz.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/long_vectors.h"
#include "support/velocity_grid.h"

namespace restframe {
namespace {

using RestFromWorld = Boost<in::Rest, in::World>;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

const std::vector<Displacement<in::World>> kDisplacements = {
    {0, {0, 0, 0}},     {1, {0, 0, 0}},       {0, {1, 0, 0}},         {-2, {0.5, -3, 0.25}},
    {1, {0.6, 0.8, 0}}, {1e-9, {1e3, -7, 2}}, {1e6, {1e6, 3, -1e-3}}, {-5, {-1, -4, 2.5}},
};

double size(const Vec3& v) {
  return glm::length(v);
}
template <class Frame>
double size(const Displacement<Frame>& d) {
  return std::hypot(d.t, glm::length(d.x));
}

::testing::Message about(const Velocity& v) {
  const Vec3 u = v.gamma_beta();
  return ::testing::Message() << "gamma beta = (" << u.x << ", " << u.y << ", " << u.z << ")";
}

TEST(Velocity, GammaFromBetaMatchesTheClosedForm) {
  EXPECT_DOUBLE_EQ(Velocity::from_beta({0.6, 0, 0}).gamma(), 1.25);
  EXPECT_DOUBLE_EQ(Velocity::from_beta({0, -0.8, 0}).gamma(), 5.0 / 3.0);
  EXPECT_DOUBLE_EQ(Velocity::from_beta({0, 0, 0.99}).gamma(),
                   static_cast<double>(1 / std::sqrt((1 - 0.99L) * (1 + 0.99L))));
}

TEST(Velocity, GivenByGammaKeepsItsDigits) {
  for (const Vec3& direction : direction_grid()) {
    for (double gamma : {1.0, 1 + 1e-12, 1.5, 7.1, 1e3, 1e6, 1e9, 1e12}) {
      const Velocity v = Velocity::from_gamma(gamma, 3.0 * direction);
      EXPECT_NEAR(v.gamma(), gamma, 4 * kEpsilon * gamma);
      const long double g = gamma;
      const double expected = static_cast<double>(std::sqrt((g - 1) * (g + 1)));
      EXPECT_NEAR(size(v.gamma_beta()), expected, 4 * kEpsilon * expected);
    }
  }
}

TEST(Velocity, DirectionMayHaveAnyLength) {
  for (double scale : {1e-300, 1e-160, 1e-3, 1e160, 1e300}) {
    const Vec3 u = Velocity::from_gamma(1.25, scale * Vec3(2, -2, 1)).gamma_beta();
    EXPECT_NEAR(u.x, 0.5, 1e-15) << scale;
    EXPECT_NEAR(u.y, -0.5, 1e-15) << scale;
    EXPECT_NEAR(u.z, 0.25, 1e-15) << scale;
  }
}

TEST(Boost, MatchesTheMatrixInLongDouble) {
  for (const Velocity& v : velocity_grid()) {
    const RestFromWorld boost(v);
    const reference::LongMatrix matrix =
        reference::boost_matrix(reference::widened(v.gamma_beta()));
    for (const auto& d : kDisplacements) {
      const reference::Long4 expected = matrix * reference::Long4{d.t, reference::widened(d.x)};
      const Displacement<in::Rest> got = boost(d);
      const double tolerance = 8 * kEpsilon * v.gamma() * size(d);
      EXPECT_NEAR(got.t, static_cast<double>(expected.t), tolerance) << about(v);
      EXPECT_LE(size(got.x - reference::narrowed(expected.x)), tolerance) << about(v);
    }
  }
}

TEST(Boost, ComovingPointOnlyAges) {
  // Along the worldline of something at rest in the target frame: x = beta t, and t' = t / gamma.
  for (const Velocity& v : velocity_grid(1000)) {
    const Displacement<in::Rest> d =
        RestFromWorld(v)(Displacement<in::World>{v.gamma(), v.gamma_beta()});
    EXPECT_NEAR(d.t, 1.0, 4 * kEpsilon * v.gamma() * v.gamma()) << about(v);
    EXPECT_LE(size(d.x), 4 * kEpsilon * v.gamma() * v.gamma()) << about(v);
  }
}

TEST(Boost, InverseRestores) {
  for (const Velocity& v : velocity_grid()) {
    const RestFromWorld boost(v);
    for (const auto& d : kDisplacements) {
      const Displacement<in::World> back = boost.inverse()(boost(d));
      // The boost and its inverse stretch by up to 2 gamma each.
      const double tolerance = 8 * kEpsilon * v.gamma() * v.gamma() * size(d);
      EXPECT_NEAR(back.t, d.t, tolerance) << about(v);
      EXPECT_LE(size(back.x - d.x), tolerance) << about(v);
    }
  }
}

TEST(Boost, InverseRestoresWaveVectors) {
  for (const Velocity& v : velocity_grid()) {
    const RestFromWorld boost(v);
    for (const Vec3& direction : direction_grid()) {
      for (double frequency : {1e-6, 1.0, 3e7}) {
        const WaveVector<in::World> k{-frequency, frequency * direction};
        const WaveVector<in::World> back = boost.inverse()(boost(k));
        const double tolerance = 16 * kEpsilon * v.gamma() * frequency;
        EXPECT_NEAR(back.t, k.t, tolerance) << about(v);
        EXPECT_LE(size(back.x - k.x), tolerance) << about(v);
      }
    }
  }
}

TEST(Boost, KeepsTheMinkowskiProduct) {
  for (const Velocity& v : velocity_grid()) {
    const RestFromWorld boost(v);
    for (const auto& a : kDisplacements) {
      for (const auto& b : kDisplacements) {
        const double tolerance = 32 * kEpsilon * v.gamma() * v.gamma() * size(a) * size(b);
        EXPECT_NEAR(minkowski_dot(boost(a), boost(b)), minkowski_dot(a, b), tolerance) << about(v);
      }
    }
  }
}

TEST(Boost, NullStaysNull) {
  for (const Velocity& v : velocity_grid()) {
    for (const Vec3& direction : direction_grid()) {
      const WaveVector<in::Rest> k = RestFromWorld(v)(looking_along<in::World>(direction));
      EXPECT_LT(k.t, 0.0) << about(v);
      EXPECT_NEAR(size(k.x), -k.t, 4 * kEpsilon * -k.t) << about(v);
      EXPECT_NEAR(size(sight_direction(k)), 1.0, 4 * kEpsilon) << about(v);
    }
  }
}

TEST(Boost, WaveVectorTransformsLikeADisplacement) {
  for (const Velocity& v : velocity_grid(1000)) {
    const reference::LongMatrix matrix =
        reference::boost_matrix(reference::widened(v.gamma_beta()));
    for (const Vec3& direction : direction_grid()) {
      const WaveVector<in::World> k = looking_along<in::World>(direction);
      const reference::Long3 unit = reference::normalized(reference::widened(direction));
      const reference::Long4 expected = matrix * reference::Long4{-1, unit};
      const WaveVector<in::Rest> got = RestFromWorld(v)(k);
      const double tolerance = 8 * kEpsilon * v.gamma();
      EXPECT_NEAR(got.t, static_cast<double>(expected.t), tolerance) << about(v);
      EXPECT_LE(size(got.x - reference::narrowed(expected.x)), tolerance) << about(v);
    }
  }
}

TEST(Boost, RayParameterIsTheSameInEveryFrame) {
  const Event<in::World> origin{3, {1, -2, 0.5}};
  for (const Velocity& v : velocity_grid(1000)) {
    const AnchoredFrame<in::Rest> rest{{0, {0, 0, 0}}, RestFromWorld(v)};
    const WaveVector<in::World> k = looking_along<in::World>(glm::normalize(Vec3(1, 2, -3)));
    for (double s : {0.0, 1e-3, 7.0, 1e4}) {
      const Event<in::Rest> along = point_on_ray(rest(origin), rest(k), s);
      const Event<in::Rest> across = rest(point_on_ray(origin, k, s));
      const double tolerance = 32 * kEpsilon * v.gamma() * (4 + s);
      EXPECT_NEAR(along.t, across.t, tolerance) << about(v);
      EXPECT_LE(size(along.x - across.x), tolerance) << about(v);
    }
  }
}

TEST(Boost, RestIsTheIdentity) {
  const RestFromWorld rest;
  for (const auto& d : kDisplacements) {
    EXPECT_EQ(rest(d).t, d.t);
    EXPECT_EQ(rest(d).x, d.x);
  }
  for (const Vec3& direction : {Vec3(0, 0, -1), Vec3(0.6, 0.8, 0)}) {
    const WaveVector<in::Rest> k = rest(looking_along<in::World>(direction));
    EXPECT_EQ(k.t, -1.0);
    EXPECT_EQ(k.x, direction);
  }
  for (const Vec3& direction : random_directions(1000, 7)) {
    // A unit vector's length is 1 but for rounding, and the boost makes |x| = -t again.
    const WaveVector<in::Rest> k = rest(looking_along<in::World>(direction));
    EXPECT_EQ(k.t, -1.0);
    EXPECT_LE(size(k.x - direction), 2 * kEpsilon);
  }
}

TEST(Boost, TendsToTheIdentityAsTheVelocityVanishes) {
  for (const Vec3& direction : direction_grid()) {
    for (double beta : {0.0, 5e-324, 1e-310, 1e-300, 1e-150, 1e-30, 1e-12, 1e-6}) {
      const RestFromWorld boost(Velocity::from_beta(beta * direction));
      for (const auto& d : kDisplacements) {
        const double tolerance = (2 * beta + 2 * kEpsilon) * size(d);
        EXPECT_NEAR(boost(d).t, d.t, tolerance) << beta;
        EXPECT_LE(size(boost(d).x - d.x), tolerance) << beta;
      }
      const WaveVector<in::Rest> k = boost(looking_along<in::World>({0.6, 0, -0.8}));
      EXPECT_LE(size(k.x - Vec3(0.6, 0, -0.8)), 2 * beta + 4 * kEpsilon) << beta;
      EXPECT_NEAR(k.t, -1.0, 2 * beta + 4 * kEpsilon) << beta;
    }
  }
}

TEST(Composition, CollinearRapiditiesAdd) {
  const Vec3 axis = glm::normalize(Vec3(1, -2, 0.5));
  for (double a : {-7.0, -0.3, 0.0, 1e-12, 0.5, 3.0, 7.0}) {
    for (double b : {-7.0, -0.5, 0.0, 1e-9, 2.0, 7.0}) {
      const RestFromWorld boost(Velocity::from_gamma_beta(std::sinh(a) * axis));
      const Velocity sum = composed(boost, Velocity::from_gamma_beta(std::sinh(b) * axis));
      const double tolerance = 32 * kEpsilon * std::cosh(a) * std::cosh(b);
      EXPECT_LE(size(sum.gamma_beta() - std::sinh(a + b) * axis), tolerance) << a << " " << b;
    }
  }
}

TEST(Composition, MatchesMatricesInLongDouble) {
  for (const Velocity& outer : velocity_grid(1000)) {
    const reference::LongMatrix back =
        reference::boost_matrix(reference::widened(-outer.gamma_beta()));
    for (const Velocity& inner : velocity_grid(1000, 0)) {
      const reference::Long3 u = reference::widened(inner.gamma_beta());
      const reference::Long4 expected = back * reference::Long4{reference::gamma_of(u), u};
      const Velocity got = composed(RestFromWorld(outer), inner);
      const double tolerance = 16 * kEpsilon * outer.gamma() * inner.gamma();
      ASSERT_LE(size(got.gamma_beta() - reference::narrowed(expected.x)), tolerance)
          << about(outer) << ", " << about(inner);
      ASSERT_NEAR(got.gamma(), static_cast<double>(expected.t), tolerance);
    }
  }
}

TEST(Composition, TwoBoostsAreTheProductOfTheirMatrices) {
  const Displacement<in::Camera> d{0.7, {-2, 1, 5}};
  for (const Velocity& camera : velocity_grid(10)) {
    for (const Velocity& object : velocity_grid(10, 0)) {
      const reference::LongMatrix both =
          reference::boost_matrix(reference::widened(object.gamma_beta())) *
          reference::boost_matrix(reference::widened(-camera.gamma_beta()));
      const reference::Long4 expected = both * reference::Long4{d.t, reference::widened(d.x)};
      const Boost<in::World, in::Camera> world_from_camera(-camera);
      const Displacement<in::Rest> got = RestFromWorld(object)(world_from_camera(d));
      const double tolerance = 64 * kEpsilon * camera.gamma() * object.gamma() * size(d);
      ASSERT_NEAR(got.t, static_cast<double>(expected.t), tolerance);
      ASSERT_LE(size(got.x - reference::narrowed(expected.x)), tolerance);
    }
  }
}

TEST(Composition, OppositeVelocitiesComposeToRest) {
  for (const Velocity& v : velocity_grid()) {
    const Velocity sum = composed(RestFromWorld(v), -v);
    EXPECT_LE(size(sum.gamma_beta()), 8 * kEpsilon * v.gamma() * v.gamma()) << about(v);
  }
}

}  // namespace
}  // namespace restframe
