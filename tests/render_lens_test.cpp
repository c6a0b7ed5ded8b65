// The thin lens, measured in rendered pictures: circles of confusion, at rest and at 0.9c, and one
// event a lens point.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "support/exposed_scene.h"
#include "support/sphere_scene.h"

namespace restframe {
namespace {

constexpr double kRadius = 0.04;

// A small sphere that keeps its place before the camera, at `distance` in both's rest frame.
struct LensScene {
  Film film;
  double aperture = 0, focus = 1, distance = 1;
  Vec3 velocity{0, 0, 0};
  std::string color = "\"white\"";
};

std::string text_of(const LensScene& scene) {
  const Vec3& v = scene.velocity;
  // At one time of the world the way along the motion is contracted.
  const double gamma = 1 / std::sqrt(1 - glm::dot(v, v));
  const double z = v.z == 0 ? scene.distance : scene.distance / gamma;
  const std::string velocity = fmt::format("velocity = [{}, {}, {}]\n", v.x, v.y, v.z);
  return fmt::format("[camera]\nposition = [0, 0, 0]\nfov = {:.17g}\naperture = {}\nfocus = {}\n{}",
                     scene.film.fov(), scene.aperture, scene.focus, velocity) +
         scene.film.text(256) +
         fmt::format(
             "[[object]]\nsphere = {{radius = {}, fineness = 3}}\nposition = [0, 0, "
             "{:.17g}]\nclock = \"frame\"\n",
             kRadius, -z) +
         velocity + "[[material]]\nname = \"ball\"\nunlit = true\nbase_color = " + scene.color +
         "\n";
}

// Pixels: the image of the lens through a point, as large as the lens is seen from the plane that
// is sharp.
double blur_radius(const LensScene& scene) {
  return scene.film.focal_length * scene.aperture * std::abs(1 / scene.distance - 1 / scene.focus);
}

// Means of the square of the distance from the middle: R^2 / 2 of an even disc, 1/6 of the film's
// filter for each axis; those of what is convolved add up.
double expected_mean_square(const LensScene& scene) {
  const double blur = blur_radius(scene);
  const double sphere = scene.film.focal_length * kRadius / scene.distance;
  return 0.5 * (blur * blur + sphere * sphere) + 1.0 / 3;
}

void expect_circle(const LensScene& scene) {
  SCOPED_TRACE(fmt::format("distance {} focus {}", scene.distance, scene.focus));
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, text_of(scene));
  const ChannelMoments disc = moments_of(picture, "A");
  const double sphere = scene.film.focal_length * kRadius / scene.distance;
  const double area = std::numbers::pi * sphere * sphere;
  EXPECT_NEAR(disc.sum, area, 0.06 * area);
  EXPECT_NEAR(disc.mean_x, 0, 0.3);
  EXPECT_NEAR(disc.mean_y, 0, 0.3);
  const double expected = expected_mean_square(scene);
  EXPECT_NEAR(disc.mean_square, expected, 0.04 * expected);
  // Nothing outside: a pixel's filter reaches one pixel, its corner 0.71 more.
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double r = std::hypot(x + 0.5 - 0.5 * picture.width, y + 0.5 - 0.5 * picture.height);
      if (r < blur_radius(scene) + 1.01 * sphere + 1.5) continue;
      ASSERT_EQ(picture.at("A", x, y), 0);
    }
  }
}

const std::vector<Vec3> kVelocities = {{0, 0, 0}, {0.9, 0, 0}, {0, 0, -0.9}};

TEST(Lens, BlursAPointToACircleOfTheRightSize) {
  for (const Vec3& velocity : kVelocities) {
    expect_circle({{64, 64, 100}, 0.5, 2, 4, velocity});
    expect_circle({{64, 64, 100}, 0.25, 4, 2, velocity});
  }
}

TEST(Lens, KeepsWhatIsInFocusSharp) {
  for (const Vec3& velocity : kVelocities) expect_circle({{32, 32, 100}, 0.5, 2, 2, velocity});
}

// Light from the sphere takes the longer the farther from the lens's middle it comes in, so the
// middle of the circle sees it redder: later by its own clock. All lens points are at one time of
// the *camera*: were they at one time of the world, at 0.9c one side of the lens would be later
// than the other by four seconds.
TEST(Lens, IsAsManyEventsAtOneCameraTime) {
  constexpr double turns_at = 2.4;  // s of light travelled
  for (const Vec3& velocity : kVelocities) {
    LensScene scene{{120, 120, 100}, 2, 4, 2, velocity};
    scene.color =
        fmt::format("{{intervals = [[-9, -{0}, [0, 0, 1]], [-{0}, 9, [1, 0, 0]]]}}", turns_at);
    const ExrPicture picture = rendered(RESTFRAME_PROGRAM, text_of(scene));
    const ChannelMoments red = moments_of(picture, "R");
    const ChannelMoments blue = moments_of(picture, "B");
    const double way = turns_at + kRadius * 2 / 3;  // to the sphere's centre
    const double turn = std::sqrt(way * way - 4) * blur_radius(scene) / scene.aperture;
    const double rim = blur_radius(scene);
    EXPECT_NEAR(red.mean_x, 0, 2.5);
    EXPECT_NEAR(red.mean_y, 0, 2.5);
    EXPECT_NEAR(red.mean_square, turn * turn / 2, 0.1 * turn * turn / 2);
    EXPECT_NEAR(blue.mean_square, (turn * turn + rim * rim) / 2, 0.05 * rim * rim);
  }
}

TEST(Lens, LeavesDataLayersThePinholes) {
  const std::string layers = R"(["Z", "time", "P", "id"])";
  const auto scene = [&](const char* lens) {
    const Film film{40, 40, 40};
    return fmt::format("[camera]\nposition = [0, 0, 0]\nfov = {}\n{}", film.fov(), lens) +
           film.text(4, false, layers) + "[[object]]\nsphere = {}\nposition = [0, 0, -3]\n";
  };
  const ExrPicture pinhole = rendered(RESTFRAME_PROGRAM, scene(""));
  const ExrPicture lens = rendered(RESTFRAME_PROGRAM, scene("aperture = 0.5\nfocus = 6\n"));
  for (const auto& [name, values] : pinhole.channels) EXPECT_EQ(values, lens.channel(name)) << name;
}

}  // namespace
}  // namespace restframe
