// Directions chosen from a sky: their density integrates to 1, is what histograms show, follows the
// radiance, and changes by D^2 where frames meet.

#include "tracer/sky_distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/long_vectors.h"
#include "support/picture_statistics.h"
#include "support/solid_angles.h"
#include "support/velocity_grid.h"
#include "tracer/environment.h"

namespace restframe {
namespace {

constexpr double pi = std::numbers::pi;

using Radiance = std::function<Vec3f(int x, int y)>;

SkyMap map_of(int width, int height, const Radiance& radiance) {
  SkyMap map{"sky", width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) map.pixels.push_back(radiance(x, y));
  }
  return map;
}

struct NamedMap {
  const char* name;
  SkyMap map;
};

std::vector<NamedMap> maps() {
  std::vector<NamedMap> all;
  all.push_back({"even", map_of(8, 4, [](int, int) { return Vec3f(2); })});
  all.push_back({"one pixel", map_of(1, 1, [](int, int) { return Vec3f(2); })});
  all.push_back({"ramp", map_of(8, 5, [](int x, int y) {
                   return Vec3f(static_cast<float>(x), static_cast<float>(y), 1);
                 })});
  all.push_back({"sun", map_of(64, 32, [](int x, int y) {
                   return x == 40 && y == 9 ? Vec3f(1e5F) : Vec3f(0.3F, 0.5F, 1);
                 })});
  all.push_back({"sun at the zenith, seam", map_of(16, 8, [](int x, int y) {
                   return x == 0 && y == 0 ? Vec3f(100) : Vec3f(0.1F);
                 })});
  all.push_back({"black but for a patch", map_of(16, 8, [](int x, int y) {
                   return x == 15 && y >= 5 ? Vec3f(0, 0, 3) : Vec3f(0);
                 })});
  return all;
}

// By the midpoints of a fine grid over the sphere.
TEST(SkyDistribution, DensityIntegratesToOne) {
  for (const NamedMap& named : maps()) {
    const SkyDistribution sky(named.map);
    constexpr int rows = 600, columns = 1200;
    double sum = 0;
    for (int i = 0; i < rows; ++i) {
      const double theta = pi * (i + 0.5) / rows;
      for (int j = 0; j < columns; ++j) {
        const double phi = 2 * pi * (j + 0.5) / columns;
        const Vec3 direction(std::sin(theta) * std::cos(phi), std::cos(theta),
                             std::sin(theta) * std::sin(phi));
        sum += sky.density(direction) * std::sin(theta) * (pi / rows) * (2 * pi / columns);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-2) << named.name;
  }
}

// What is estimated with it: any function's integral; here those of the sphere's lowest harmonics
// times the radiance, against a sum over the grid.
TEST(SkyDistribution, IsUnbiased) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> number(0, 1);
  for (const NamedMap& named : maps()) {
    const SkyDistribution sky(named.map);
    const auto value = [&](const Vec3& d, int k) {
      const Vec3f radiance = radiance_at(named.map, sky_place(named.map, d));
      const double f = static_cast<double>(radiance.x + 2 * radiance.y + 3 * radiance.z);
      return k == 0 ? f : f * (1 + d[k - 1]);
    };
    constexpr int count = 40'000, rows = 400, columns = 800;
    for (int k = 0; k < 4; ++k) {
      double sum = 0, squares = 0, expected = 0;
      for (int i = 0; i < count; ++i) {
        const auto chosen = sky.choose(number(generator), number(generator));
        const double x = value(chosen.direction, k) / chosen.density;
        sum += x / count;
        squares += x * x / count;
      }
      for (int i = 0; i < rows * columns; ++i) {
        const int row = i / columns, column = i % columns;
        const double theta = pi * (row + 0.5) / rows, phi = 2 * pi * (column + 0.5) / columns;
        const Vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                     std::sin(theta) * std::sin(phi));
        expected += value(d, k) * std::sin(theta) * (pi / rows) * (2 * pi / columns);
      }
      const double error = std::sqrt(std::max(0.0, squares - sum * sum) / count);
      EXPECT_NEAR(sum, expected, sidak_bound(24) * error + 2e-3 * expected) << named.name << k;
    }
  }
}

// The same density comes back for what was chosen, and it is the radiance's, but for the sine that
// changes within a cell.
TEST(SkyDistribution, FollowsTheRadianceBetweenPixels) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> number(0, 1);
  const SkyMap map =
      map_of(64, 32, [](int x, int y) { return x == 40 && y == 9 ? Vec3f(1e5F) : Vec3f(0.5F); });
  const SkyDistribution sky(map);
  double least = 1e30, most = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto chosen = sky.choose(number(generator), number(generator));
    EXPECT_NEAR(glm::length(chosen.direction), 1, 1e-12);
    EXPECT_NEAR(sky.density(chosen.direction) / chosen.density, 1, 1e-3);
    if (std::abs(chosen.direction.y) > 0.95) continue;
    const double radiance =
        static_cast<double>(radiance_at(map, sky_place(map, chosen.direction)).x);
    least = std::min(least, radiance / chosen.density);
    most = std::max(most, radiance / chosen.density);
  }
  EXPECT_LT(most / least, 1.3);
}

TEST(SkyDistribution, OfADarkSkyIsEmpty) {
  EXPECT_TRUE(SkyDistribution(map_of(4, 2, [](int, int) { return Vec3f(0); })).empty());
}

// A pixel brighter than all others together by 1e9: those that single precision loses are never
// chosen, and their density says so.
TEST(SkyDistribution, ToldChancesAreThoseItChoosesBy) {
  const SkyMap map =
      map_of(256, 2, [](int x, int y) { return x == 100 && y == 0 ? Vec3f(1e12F) : Vec3f(1); });
  const SkyDistribution sky(map);
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> number(0, 1);
  for (int i = 0; i < 10'000; ++i) {
    EXPECT_GT(sky.choose(number(generator), number(generator)).density, 0);
  }
}

constexpr int bands = 6, sectors = 8;

// Which of the sphere's parts a direction is in.
std::size_t part_of(const Vec3f& d) {
  const int band = std::min(bands - 1, static_cast<int>(bands * 0.5F * (1 + d.z)));
  const double turn = std::atan2(static_cast<double>(d.y), static_cast<double>(d.x));
  const int sector = std::min(sectors - 1, static_cast<int>(sectors * (0.5 + turn / (2 * pi))));
  return static_cast<std::size_t>(band * sectors + sector);
}

Scene scene_of_moving_sky(const Vec3& beta) {
  Scene scene;
  scene.sky_maps = {map_of(16, 8, [](int x, int y) {
    return Vec3f(1 + static_cast<float>(x % 5), 1 + static_cast<float>(y), 1);
  })};
  Light light;
  light.kind = LightKind::environment;
  light.sky_map = 0;
  light.worldline.velocity = Velocity::from_beta(beta);
  scene.lights = {light};
  return scene;
}

// A sky at rest in a frame of its own, its directions as surfaces of another velocity see them: what
// falls into each part of their sphere is what the density there says (aberration's Jacobian, D^2).
class MovingSky : public ::testing::TestWithParam<double> {};

TEST_P(MovingSky, DensitiesAreThoseOfTheSurfacesFrame) {
  const Scene scene = scene_of_moving_sky({0, GetParam(), 0});
  const std::vector<Environment> skies = environments(scene);
  const Boost<in::Rest, in::World> surface(Velocity::from_beta({0.3, -0.2, 0.1}));
  LitLanes lit;
  lit.rest_from_world.fill(&surface);
  lit.omega.fill(1.7);
  lit.active.fill(-1);
  EventLanes<in::World> event;
  for (int i = 0; i < packet_size; ++i) event.set(i, {});
  TemporalEvaluator evaluator(scene.functions);
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<float> number(0, 1);
  constexpr int packets = 20'000, parts = bands * sectors;
  SolidAngles angles(parts);
  for (int p = 0; p < packets; ++p) {
    Lanes<float> u, v;
    for (int i = 0; i < packet_size; ++i) {
      u[i] = number(generator);
      v[i] = number(generator);
    }
    IncidentLanes incident;
    Lanes<double> density;
    incident_from_sky(skies[0], event, lit, {1, false}, u, v, evaluator, incident, density);
    for (int i = 0; i < packet_size; ++i) {
      ASSERT_NE(incident.active[i], 0);
      angles.add(part_of(incident.direction.at(i)), density[i]);
    }
  }
  angles.expect_equal(packets * packet_size, sidak_bound(parts));
}

INSTANTIATE_TEST_SUITE_P(At, MovingSky, ::testing::Values(0.0, 0.5, 0.9));

}  // namespace
}  // namespace restframe
