// Section 5 of the paper: spheres that blink once a second of their own clock come, pass and go. In
// the pictures of scenes/passing, each tracked in turn: equation 3 over the whole passage, time
// dilation alone where a sphere is seen exactly sideways, and the cross-over angle.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <numbers>
#include <sstream>

#include "support/animation.h"
#include "support/figure.h"
#include "support/shown_scene.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::widened;

// What one pixel at the picture's centre sees of the tracked sphere.
struct Moment {
  double time = 0, doppler = 0, clock = 0;
  double along = 0;  // the cosine between the view and the sphere's velocity, from the header
  bool yellow = false;
};

struct Passage {
  reference::MovingSphere sphere;
  std::vector<Moment> moments;
};

double gamma_of(const Passage& passage) {
  return static_cast<double>(reference::gamma_of(widened(passage.sphere.gamma_beta)));
}

// OpenEXR multiplies rows by matrices; z is along the view. The spheres move along x.
double view_along_x(const ExrPicture& picture) {
  std::istringstream numbers(picture.attributes.at("worldToCamera"));
  double first = 0, second = 0, third = 0;
  numbers >> first >> second >> third;
  return third;
}

Passage passage_of(const std::string& name) {
  std::string text = small(scene_text("passing"), 1, 1, R"(["beauty", "doppler", "time", "id"])");
  text = with_key(text, "camera", "track", fmt::format("\"{}\"", name));
  text = with_key(text, "camera", "fov", "1e-3");
  const Scene scene = figure_scene(text);
  Passage passage;
  const auto spheres = figure_spheres(scene, {0.3, 0.3, 0.3});
  int id = 0;
  while (scene.objects.at(static_cast<std::size_t>(id)).name != name) ++id;
  passage.sphere = spheres.at(static_cast<std::size_t>(id));
  for (const ExrPicture& picture :
       rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures)) {
    EXPECT_EQ(picture.at("id_object.V", 0, 0), static_cast<float>(id + 1));
    const auto value = [&](const char* channel) {
      return static_cast<double>(picture.at(channel, 0, 0));
    };
    passage.moments.push_back({std::stod(picture.attributes.at("cameraTime")), value("doppler.D"),
                               value("time_proper.V"), view_along_x(picture),
                               is_yellow(picture, 0, 0)});
  }
  return passage;
}

// Equation 3 for a camera at rest in the world's origin, which sees the sphere where closed form 1
// says; e points to where it is seen.
long double equation_3(const reference::MovingSphere& sphere, double time) {
  const Long3 u = widened(sphere.gamma_beta);
  const Vec3 seen = seen_from({}, sphere, time);
  return 1 / reference::frequency_seen_from(u, widened(seen));
}

long double blinks_between(const reference::MovingSphere& sphere, double begin, double end) {
  const int steps = 20000;
  long double sum = 0;
  for (int i = 0; i < steps; ++i) {
    sum += equation_3(sphere, begin + (end - begin) * (i + 0.5) / steps);
  }
  return sum * static_cast<long double>(end - begin) / steps;
}

// Half the changes between yellow and the sphere's own colour, from `begin` to `end`.
double blinks_seen(const std::vector<Moment>& moments, double begin, double end) {
  int changes = 0;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    if (moments[i - 1].time < begin - 1e-9 || moments[i].time > end + 1e-9) continue;
    changes += moments[i].yellow != moments[i - 1].yellow;
  }
  return 0.5 * changes;
}

void expect_blinks_of_equation_3(const Passage& passage) {
  const double begin = passage.moments.front().time, end = passage.moments.back().time;
  ASSERT_LT(begin, -4);
  ASSERT_GT(end, 6);
  for (const auto& [from, to] : {std::pair(begin, end), {begin, -1.0}, {-1.0, 1.0}, {1.0, end}}) {
    const long double expected = blinks_between(passage.sphere, from, to);
    EXPECT_NEAR(blinks_seen(passage.moments, from, to), static_cast<double>(expected), 1)
        << from << " to " << to;
  }
  EXPECT_GT(blinks_seen(passage.moments, begin, end), 8);
}

void expect_pace_of_doppler_factor(const Passage& passage) {
  for (std::size_t i = 1; i < passage.moments.size(); ++i) {
    const Moment &a = passage.moments[i - 1], &b = passage.moments[i];
    const double pace = (b.clock - a.clock) / (b.time - a.time);
    EXPECT_NEAR(pace, 0.5 * (a.doppler + b.doppler), 0.02 * pace) << a.time;
    EXPECT_NEAR(a.doppler, static_cast<double>(equation_3(passage.sphere, a.time)),
                1e-4 * a.doppler);
  }
}

// Where the view is square to the motion, between two pictures.
void expect_dilation_alone_sideways(const Passage& passage) {
  const double gamma = gamma_of(passage);
  int found = 0;
  for (std::size_t i = 1; i < passage.moments.size(); ++i) {
    const Moment &a = passage.moments[i - 1], &b = passage.moments[i];
    if (a.along >= 0 || b.along < 0) continue;
    const double part = a.along / (a.along - b.along);
    EXPECT_NEAR(a.doppler + part * (b.doppler - a.doppler), 1 / gamma, 0.005 / gamma);
    ++found;
  }
  EXPECT_EQ(found, 1);
}

// cos(theta) = sqrt((gamma - 1) / (gamma + 1)), theta from the motion to the direction from the
// sphere to the camera.
void expect_crossover(const Passage& passage) {
  const double gamma = gamma_of(passage);
  const double degrees = 180 / std::numbers::pi;
  const double expected = std::acos(std::sqrt((gamma - 1) / (gamma + 1))) * degrees;
  int found = 0;
  for (std::size_t i = 1; i < passage.moments.size(); ++i) {
    const Moment &a = passage.moments[i - 1], &b = passage.moments[i];
    if (a.doppler < 1 || b.doppler >= 1) continue;
    const double part = (a.doppler - 1) / (a.doppler - b.doppler);
    const double before = std::acos(-a.along) * degrees, after = std::acos(-b.along) * degrees;
    EXPECT_NEAR(before + part * (after - before), expected, 0.5);
    ++found;
  }
  EXPECT_EQ(found, 1);
}

class Passing : public ::testing::TestWithParam<const char*> {};

TEST_P(Passing, IsSeenAsThePaperSays) {
  const Passage passage = passage_of(GetParam());
  expect_blinks_of_equation_3(passage);
  expect_pace_of_doppler_factor(passage);
  expect_dilation_alone_sideways(passage);
  expect_crossover(passage);
}

INSTANTIATE_TEST_SUITE_P(Spheres, Passing, ::testing::Values("fastest", "fast", "slow"));

}  // namespace
}  // namespace restframe
