// Glass on pictures: how long light takes in it, where it goes, what is left of it; media within
// media; total reflection; and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/path_scene.h"
#include "support/program_errors.h"

namespace restframe {
namespace {

constexpr double kLampRadius = 0.3;

// Looks along -z. Lamps show their clock plus 100 in red, 1 in green.
std::string camera_at(const Vec3& position, double fov, int size, const std::string& render) {
  reference::ObserverCamera camera;
  camera.position = position;
  camera.width = camera.height = size;
  camera.vertical_fov = fov;
  return camera_text(camera, render + "\nbeaming = true");
}

std::string lamp_at(const Vec3& position, double radius = kLampRadius) {
  return fmt::format(
      "[[object]]\nname = \"lamp\"\nsphere = {{radius = {}, fineness = 4}}\nposition = {}\n"
      "material = \"lamp\"\n[[material]]\nname = \"lamp\"\nbase_color = \"black\"\nunlit = true\n"
      "emission = {{formula = [\"t + 100\", \"1\", \"1\"]}}\n",
      radius, toml(position));
}

std::string glass_material(const std::string& name, double ior, const std::string& more = "") {
  return fmt::format(
      "[[material]]\nname = \"{}\"\nmetallic = 0\nroughness = 0\ntransmission = 1\nior = {}\n{}\n",
      name, ior, more);
}

Vec3 sum_of(const ExrPicture& picture) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < picture.channel("G").size(); ++i) {
    sum += Vec3(picture.channel("R")[i], picture.channel("G")[i], picture.channel("B")[i]);
  }
  return sum;
}

// The part that a surface between vacuum and index n lets pass at normal incidence.
double passed(double n) {
  return 4 * n / ((n + 1) * (n + 1));
}

// A slab across the sight line, which moves along it with its front at z = beta t. Followed
// backwards from the camera at time 0; inside, light has the sum of the velocities 1/n and beta.
double emission_through_slab(double camera_z, double lamp_z, double n, double thickness,
                             double beta) {
  const double in_glass = (1 / n + beta) / (1 + beta / n);
  const double front_t = -camera_z / (1 - beta), front_z = beta * front_t;
  const double contracted = thickness * std::sqrt(1 - beta * beta);
  const double back_t = (front_z - in_glass * front_t + contracted) / (beta - in_glass);
  const double back_z = beta * back_t - contracted;
  return back_t - (back_z - lamp_z);
}

TEST(Glass, DelaysLightByItsIndex) {
  constexpr double camera_z = 4, lamp_z = -30, thickness = 2;
  const AssetFile slab = {"slab.obj", box_obj({-50, -50, -thickness}, {50, 50, 0})};
  for (const double n : {1.5, 2.4}) {
    for (const double beta : {0.0, 0.6, -0.6}) {
      const std::string text = camera_at({0, 0, camera_z}, 1e-4, 4, "samples = 16\ndepth = 2") +
                               placed("slab", "glass", fmt::format("velocity = [0, 0, {}]", beta)) +
                               lamp_at({0, 0, lamp_z}) + glass_material("glass", n);
      const Vec3 sum = sum_of(path_pictures(text, {slab})[0]);
      const double expected = emission_through_slab(camera_z, lamp_z, n, thickness, beta);
      if (beta == 0) {
        EXPECT_NEAR(expected, lamp_z - camera_z - (n - 1) * thickness, 1e-12);
      }
      EXPECT_NEAR(sum.x / sum.y - 100, expected + kLampRadius, 2e-3) << n << ' ' << beta;
      // D = 1 in all, and 256 paths pass two surfaces or do not.
      const double through = passed(n) * passed(n);
      EXPECT_NEAR(sum.y / 16, through, 5 * std::sqrt(through * (1 - through) / 256)) << beta;
    }
  }
}

// One layer of a slab, tilted by `theta`.
struct Layer {
  double n = 1, thickness = 0;

  double cosine(double theta) const {  // of the angle of refraction
    return std::sqrt(1 - std::pow(std::sin(theta) / n, 2));
  }
  // Across and along the incident ray.
  double displacement(double theta) const {
    return thickness * std::sin(theta) *
           (1 - std::cos(theta) / std::sqrt(n * n - std::pow(std::sin(theta), 2)));
  }
  double advance(double theta) const {
    const double refracted = std::asin(std::sin(theta) / n);
    return thickness / cosine(theta) * std::cos(theta - refracted);
  }
  double time(double theta) const { return n * thickness / cosine(theta); }
};

// The ray along the camera's axis leaves the layers displaced and late; there is the lamp.
void expect_displaced(const std::vector<Layer>& layers, double degrees,
                      const std::vector<AssetFile>& assets, const std::string& objects) {
  constexpr double distance = 6, radius = 0.1;
  const double theta = degrees / 57.295779513082320877;
  double displacement = 0, time = 2 * distance;
  for (const Layer& layer : layers) {
    displacement += layer.displacement(theta);
    time += layer.time(theta) - layer.advance(theta);
  }
  const int surfaces = 2 * static_cast<int>(assets.size());
  const std::string text =
      camera_at({0, 0, distance}, 0.2, 80, fmt::format("samples = 16\ndepth = {}", surfaces)) +
      objects + lamp_at({-displacement, 0, -distance}, radius);
  const ExrPicture picture = path_pictures(text, assets)[0];
  double x_sum = 0, y_sum = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double green = static_cast<double>(picture.at("G", x, y));
      x_sum += green * (x + 0.5);
      y_sum += green * (y + 0.5);
    }
  }
  const Vec3 sum = sum_of(picture);
  ASSERT_GT(sum.y, 5);
  EXPECT_NEAR(x_sum / sum.y, 40, 0.3) << degrees;
  EXPECT_NEAR(y_sum / sum.y, 40, 0.3) << degrees;
  EXPECT_NEAR(sum.x / sum.y - 100, -time + radius * 2 / 3, 0.01) << degrees;
}

std::string turned(double degrees) {
  return fmt::format("rotation = [0, {}, 0]", degrees);
}

TEST(Glass, DisplacesWhatIsBehindATiltedSlab) {
  const AssetFile slab = {"slab.obj", box_obj({-20, -20, -2}, {20, 20, 0})};
  for (const double n : {1.33, 1.8}) {
    for (const double degrees : {40.0, -60.0}) {
      expect_displaced({{n, 2}}, degrees, {slab},
                       placed("slab", "glass", turned(degrees)) + glass_material("glass", n));
    }
  }
}

TEST(Glass, HoldsOtherMedia) {
  const AssetFile outer = {"outer.obj", box_obj({-20, -20, -2}, {20, 20, 0})};
  const AssetFile inner = {"inner.obj", box_obj({-19, -19, -1.5}, {19, 19, -0.3})};
  const AssetFile core = {"core.obj", box_obj({-18, -18, -1}, {18, 18, -0.8})};
  for (const double degrees : {35.0, -50.0}) {
    for (const double inside : {1.0, 1.33, 2.2}) {
      expect_displaced({{1.5, 0.8}, {inside, 1.2}}, degrees, {outer, inner},
                       placed("outer", "glass", turned(degrees)) +
                           placed("inner", "other", turned(degrees)) +
                           glass_material("glass", 1.5) + glass_material("other", inside));
    }
    expect_displaced({{1.5, 0.8}, {1.33, 1}, {1.9, 0.2}}, degrees, {outer, inner, core},
                     placed("outer", "glass", turned(degrees)) +
                         placed("inner", "water", turned(degrees)) +
                         placed("core", "flint", turned(degrees)) + glass_material("glass", 1.5) +
                         glass_material("water", 1.33) + glass_material("flint", 1.9));
  }
}

// What is left of white falls with each attenuation distance of the slab's proper thickness.
TEST(Glass, AttenuatesByProperLength) {
  constexpr double thickness = 1.5;
  const AssetFile slab = {"slab.obj", box_obj({-50, -50, -thickness}, {50, 50, 0})};
  for (const double light_speed : {1.0, 3.0}) {
    for (const double beta : {0.0, 0.6}) {
      const std::string text =
          fmt::format("[scene]\nlight_speed = {}\n", light_speed) +
          camera_at({0, 0, 4}, 1e-4, 4, "samples = 4\ndepth = 2") +
          placed("slab", "glass", fmt::format("velocity = [0, 0, {}]", beta)) +
          lamp_at({0, 0, -30}) +
          glass_material("glass", 1.5,
                         "attenuation_color = [1, 0.5, 0.2]\nattenuation_distance = 0.7");
      const Vec3 sum = sum_of(path_pictures(text, {slab})[0]);
      EXPECT_NEAR(sum.z / sum.y, std::pow(0.2 / 0.5, thickness / 0.7), 1e-4) << beta;
      const double emitted = sum.x / sum.y * std::pow(0.5, thickness / 0.7) - 100;
      EXPECT_NEAR(emitted * light_speed,
                  emission_through_slab(4, -30, 1.5, thickness, beta) + kLampRadius, 0.05);
    }
  }
}

// A right-angled prism turns the view by 90 degrees: all of it where 45 degrees are beyond the
// critical angle, else Fresnel's part.
TEST(Glass, ReflectsTotally) {
  const AssetFile prism = {"prism.obj", prism_obj({{0, 0, 0}, {1, 0, -1}, {1, 0, 0}}, 0, 1)};
  for (const double n : {1.5, 1.3}) {
    const std::string text = camera_at({0.5, 0.5, 5}, 1e-3, 8, "samples = 16\ndepth = 3") +
                             placed("prism", "glass") + lamp_at({6, 0.5, -0.5}) +
                             glass_material("glass", n);
    const Vec3 sum = sum_of(path_pictures(text, {prism})[0]);
    double reflected = 1;
    if (n * std::sqrt(0.5) < 1) {
      const double beyond = std::sqrt(1 - 0.5 * n * n), before = std::sqrt(0.5);
      const double across = (n * before - beyond) / (n * before + beyond);
      const double along = (before - n * beyond) / (before + n * beyond);
      reflected = 0.5 * (across * across + along * along);
    }
    const double expected = passed(n) * passed(n) * reflected;
    EXPECT_NEAR(sum.y / 64, expected, 5 * std::sqrt(expected * (1 - expected) / 1024)) << n;
    // To the hypotenuse, to the right, in the glass n times as long.
    EXPECT_NEAR(sum.x / sum.y - 100, -(5 + n * 1 + 5) + kLampRadius, 0.01) << n;
  }
}

std::string two_balls(const Vec3& first, const Vec3& second) {
  return camera_at({0, 0, 5}, 0.5, 16, "samples = 4") +
         fmt::format(
             "[[object]]\nname = \"bowl\"\nsphere = {{radius = 1}}\nvelocity = {}\nmaterial = "
             "\"glass\"\n[[object]]\nname = \"pebble\"\nsphere = {{radius = 0.5}}\nvelocity = {}\n"
             "material = \"stone\"\n[[material]]\nname = \"stone\"\nbase_color = \"red\"\n",
             toml(first), toml(second)) +
         glass_material("glass", 1.5) + "[[light]]\ntype = \"environment\"\n";
}

// Media nest only within one rest frame.
TEST(Glass, WithSomethingElseMovingThroughIsRefused) {
  const PathRender moving = run_path(two_balls({0, 0, 0}, {0.1, 0, 0}), {});
  expect_refused(moving.result, {"\"bowl\"", "\"pebble\""});
  EXPECT_FALSE(std::filesystem::exists(moving.folder->path() / "picture.0000.exr"));
  EXPECT_EQ(run_path(two_balls({0.1, 0, 0}, {0.1, 0, 0}), {}).result.exit_code, 0);
}

}  // namespace
}  // namespace restframe
