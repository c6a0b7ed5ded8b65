// Figures 11 to 17 of the paper: the lattice at rest and at 0.99c. Measured in the pictures of their
// scenes: shells, rods bent to hyperbolae (closed form 2), and lengths along the motion (closed
// form 3).

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "support/animation.h"
#include "support/figure.h"
#include "support/shown_scene.h"

namespace restframe {
namespace {

constexpr double kBeta = 0.99, kGamma2 = 1 / (1 - kBeta * kBeta);
const std::string kPlaces = R"(["beauty", "Z", "P", "id"])";

// A point of the lattice's surface: where it is in the lattice's rest frame, and where it is seen,
// as the camera measures it, by how long its light took: `depth` along the motion and `aside`.
struct SeenPlace {
  Vec3 rest;
  double depth = 0, aside = 0;
};

// All pixels of a picture whose camera looks along -z.
std::vector<SeenPlace> places_in(const ExrPicture& picture, const Scene& scene) {
  std::vector<SeenPlace> places;
  const reference::ObserverCamera camera = figure_camera(scene);
  const double focal_length = 0.5 * picture.height / std::tan(0.5 * camera.vertical_fov);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at("id_object.V", x, y) == 0) continue;
      const double tangent =
          std::hypot(x + 0.5 - 0.5 * picture.width, y + 0.5 - 0.5 * picture.height) / focal_length;
      const double distance = static_cast<double>(picture.at("Z", x, y));
      const auto p = [&](const char* channel) {
        return static_cast<double>(picture.at(channel, x, y));
      };
      const double cosine = 1 / std::hypot(1, tangent);
      places.push_back(
          {{p("P.X"), p("P.Y"), p("P.Z")}, distance * cosine, distance * cosine * tangent});
    }
  }
  return places;
}

std::string lattice_text(const std::string& name, int width, int height) {
  const std::string text = small(scene_text(name), width, height, kPlaces);
  return name == "fig13_lattice_offaxis" ? with_key(text, "render", "integrator", "\"preview\"")
                                         : text;
}

// How far ahead of the camera the plane of a point across the motion is now, at the camera's time.
double ahead_now(const Scene& scene, const SeenPlace& place, double time) {
  const Worldline& lattice = scene.objects.at(0).worldline;
  const double z = lattice.reference.x.z + kBeta * (time - lattice.reference.t) +
                   place.rest.z / std::sqrt(kGamma2);
  return figure_camera(scene).position.z - z;
}

// (X - gamma^2 x)^2 - y^2 gamma^2 beta^2 = gamma^4 beta^2 x^2, the closed form without its
// quotients, since x may be near 0; X is the depth and y the distance from the axis of what is seen.
double off_hyperbola(double x, const SeenPlace& place) {
  const double from_center = place.depth - kGamma2 * x;
  const double terms = kGamma2 * kBeta * kBeta * (kGamma2 * x * x + place.aside * place.aside);
  return (from_center * from_center - terms) / (from_center * from_center + terms);
}

void expect_hyperbolae(const std::string& name) {
  const std::string text = lattice_text(name, 320, 180);
  const Scene scene = figure_scene(text);
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  const Vec3 camera = figure_camera(scene).position;
  std::size_t checked = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double time = static_cast<double>(i) / scene.animation.rate;
    for (const SeenPlace& place : places_in(pictures[i], scene)) {
      ASSERT_NEAR(off_hyperbola(ahead_now(scene, place, time), place), 0, 1e-3)
          << name << ", picture " << i;
      const double aside = std::hypot(place.rest.x - camera.x, place.rest.y - camera.y);
      ASSERT_NEAR(place.aside, aside, 1e-4 * (1 + aside)) << name << ", picture " << i;
      ++checked;
    }
  }
  EXPECT_GT(checked, 20000U);
}

TEST(Figure12, EveryRodAcrossIsItsHyperbola) {
  expect_hyperbolae("fig12_lattice_approach");
}

TEST(Figure13, EveryRodAcrossIsItsHyperbolaBesideTheAxisToo) {
  expect_hyperbolae("fig13_lattice_offaxis");
}

// The front row of balls, straight in its own frame: its end, three to the side, is seen behind its
// middle, by far more than rods are thick.
TEST(Figure12, TheFrontIsBentBackwards) {
  const std::string text = lattice_text("fig12_lattice_approach", 640, 360);
  const Scene scene = figure_scene(text);
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  double middle = 0, end = 0;
  for (const SeenPlace& place : places_in(pictures[0], scene)) {
    if (std::abs(place.rest.z - 9.5) > 0.02 || std::abs(place.rest.y) > 0.16) continue;
    if (std::abs(place.rest.x) < 0.2) middle = std::max(middle, place.depth);
    if (std::abs(place.rest.x - 3) < 0.2) end = std::max(end, place.depth);
  }
  const auto depth = [](double x, double y) {
    return kGamma2 * (x + kBeta * std::sqrt(x * x + y * y / kGamma2));
  };
  const double x = 1.84 - 9.5 / std::sqrt(kGamma2);
  EXPECT_NEAR(middle, depth(x, 0), 1.5);
  EXPECT_NEAR(end - middle, depth(x, 3) - depth(x, 0), 1.5);
  EXPECT_GT(end - middle, 7);
}

// The seen depth of rods along the motion against their own lengths, by a straight line.
double apparent_length_ratio(const std::string& text, int pictures) {
  const Scene scene = figure_scene(text);
  const auto all = rendered_animation(RESTFRAME_PROGRAM, text, pictures);
  double n = 0, sum_z = 0, sum_x = 0, sum_zz = 0, sum_zx = 0, nearest = 1e9, farthest = -1e9;
  for (const SeenPlace& place : places_in(all[0], scene)) {
    const double z = place.rest.z, x = place.depth;
    if (std::hypot(place.rest.x, place.rest.y) > 1) continue;
    ++n, sum_z += z, sum_x += x, sum_zz += z * z, sum_zx += z * x;
    nearest = std::min(nearest, z), farthest = std::max(farthest, z);
  }
  EXPECT_GT(n, 100);
  EXPECT_GT(farthest - nearest, 15);
  return -(n * sum_zx - sum_z * sum_x) / (n * sum_zz - sum_z * sum_z);
}

// The lattice of figure 12 so slim and far away that its middle rods are on the axis, as closed form
// 3 has it, and not hidden by their own ends: 300 away in its own frame, 42.3 away now.
std::string far_lattice(double velocity, double fov) {
  std::string text = lattice_text("fig12_lattice_approach", 720, 720);
  text = replaced(text, "ball = 0.15, rod = 0.05", "ball = 0.02, rod = 0.01");
  text = replaced(text, "cells = [7, 7, 20]", "cells = [2, 2, 20]");
  text = replaced(text, "[0, 0, -1.84]", "[0, 0, -43.67]");
  text = replaced(text, "velocity = [0, 0, 0.99]", fmt::format("velocity = [0, 0, {}]", velocity));
  text = with_key(text, "animation", "pictures", "1");
  return with_key(text, "camera", "fov", fmt::format("{}", fov));
}

TEST(Figure12, IsSeenLongerThanAtRestWhenItComesAndShorterWhenItGoes) {
  const double ratio = std::sqrt((1 + kBeta) / (1 - kBeta));
  EXPECT_NEAR(apparent_length_ratio(far_lattice(0.99, 0.024), 1), ratio, 0.005 * ratio);
  EXPECT_NEAR(apparent_length_ratio(far_lattice(-0.99, 5), 1), 1 / ratio, 0.005 / ratio);
}

// The pixel of a front ball of figure 15 where the sun is reflected: the one with the most of the
// channel that has the least.
struct Reflection {
  double brightest = 0;
  Vec3 normal{0, 0, 1};
  glm::dvec2 from_center{0, 0};  // of the ball's image, in pixels, x right, y down
};

Reflection reflection_on(const ExrPicture& picture, const Vec3& ball) {
  Reflection found;
  glm::dvec2 sum(0), place(0);
  double pixels = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto at = [&](const char* name) { return static_cast<double>(picture.at(name, x, y)); };
      if (picture.at("id_object.V", x, y) == 0) continue;
      if (glm::length(Vec3(at("P.X"), at("P.Y"), at("P.Z")) - ball) > 0.152) continue;
      sum += glm::dvec2(x, y), ++pixels;
      const double least = std::min({at("R"), at("G"), at("B")});
      if (least <= found.brightest) continue;
      found.brightest = least;
      found.normal = {at("N.X"), at("N.Y"), at("N.Z")};
      place = {x, y};
    }
  }
  EXPECT_GT(pixels, 50);
  found.from_center = place - sum / pixels;
  return found;
}

// The sun shines square across the motion, from the right. Yet each front ball reflects it on its
// outer side, those on the left on their left: in the lattice's frame the mirror's normal is halfway
// between the sun, which aberration has put nearly ahead, and the camera.
TEST(Figure13, ReflectionsAreAtImpossibleAngles) {
  std::string text =
      small(scene_text("fig13_lattice_offaxis"), 640, 360, R"(["beauty", "P", "N", "id"])");
  text = with_key(with_key(text, "render", "depth", "1"), "animation", "start", "0.2");
  text = with_key(text, "animation", "pictures", "1");
  const ExrPicture picture = rendered_animation(RESTFRAME_PROGRAM, text, 1)[0];
  const double gamma = std::sqrt(kGamma2);
  const Vec3 sun =
      glm::normalize(Vec3(glm::normalize(Vec3(1, 0.5, 0)) + Vec3(0, 0, gamma * kBeta)));
  const Vec3 camera(1.5, 0.5, gamma * (1.594 - kBeta * 0.2));
  for (const Vec3& ball : {Vec3(1, 0, 9.5), Vec3(1, 1, 9.5), Vec3(2, 0, 9.5), Vec3(2, 1, 9.5)}) {
    SCOPED_TRACE(::testing::Message() << "ball at " << ball.x << ' ' << ball.y);
    const Reflection found = reflection_on(picture, ball);
    const Vec3 halfway = glm::normalize(sun + glm::normalize(camera - ball));
    EXPECT_GT(found.brightest, 0.3);
    EXPECT_GT(glm::dot(found.normal, halfway), std::cos(0.15));
    EXPECT_GT(found.from_center.x * (ball.x - 1.5), 1);
    EXPECT_LT(found.from_center.y * (ball.y - 0.5), -1);
  }
}

// At rest: what is seen is as much older as it is farther away, in shells half a light-second thick.
TEST(Figure11, ShellsRunOutwards) {
  const auto file = folder_of_scene("fig11_lattice_rest") / "blink.txt";
  std::string text = replaced(scene_text("fig11_lattice_rest"), "\"blink.txt\"",
                              fmt::format("\"{}\"", file.string()));
  text = small(text, 200, 112, kPlaces);
  const Scene scene = figure_scene(text);
  const Vec3 camera = figure_camera(scene).position;
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  int checked = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const ExrPicture& p = pictures[i];
    for (int y = 0; y < p.height; ++y) {
      for (int x = 0; x < p.width; ++x) {
        if (p.at("id_object.V", x, y) == 0) continue;
        const Vec3 place(p.at("P.X", x, y), p.at("P.Y", x, y), p.at("P.Z", x, y));
        const double clock = 0.1 * static_cast<double>(i) - glm::length(place - camera);
        const double phase = clock - std::floor(clock);
        if (std::abs(std::remainder(phase, 0.5)) < 0.01) continue;
        ASSERT_EQ(p.at("R", x, y) > p.at("B", x, y), phase < 0.5) << i << ' ' << x << ' ' << y;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 20000);
}

}  // namespace
}  // namespace restframe
