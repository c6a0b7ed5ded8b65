// Multiple exposure, motion blur and rolling shutter, measured in rendered pictures.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <functional>

#include "support/animation.h"
#include "support/exposed_scene.h"
#include "support/sphere_scene.h"

namespace restframe {
namespace {

std::string camera_of(const Film& film, const std::string& more = "") {
  return fmt::format("[camera]\nposition = [0, 0, 0]\ndirection = [0, 0, -1]\nfov = {:.17g}\n{}\n",
                     film.fov(), more);
}

const std::string kUnlit = "[[material]]\nname = \"ball\"\nunlit = true\nbase_color = \"white\"\n";

// Figure 3: each of the seven images lies where closed form 1 puts it at its own time.
TEST(MultipleExposure, ShowsEachAtItsDelayedPlace) {
  const Film film{700, 30, 600};
  const Vec3 place(11.4, 0, -20), v(0.9, 0, 0);
  const ExrPicture picture = rendered(
      RESTFRAME_PROGRAM, camera_of(film) + film.text(16) +
                             "[exposure]\ncount = 7\ninterval = 1\n[[object]]\nsphere = {radius = "
                             "0.15, fineness = 4}\nposition = [11.4, 0, -20]\nvelocity = [0.9, 0, "
                             "0]\n" +
                             kUnlit);
  double previous = -1e9;
  for (int e = 0; e < 7; ++e) {
    const Vec3 seen = seen_at(place, v, e);
    const double x = film.focal_length * seen.x / -seen.z;
    EXPECT_GT(x - previous, 18);
    previous = x;
    const int column = static_cast<int>(x + 0.5 * film.width);
    const ChannelMoments image = moments_of(picture, "A", column - 9, column + 9, 0, 29);
    EXPECT_NEAR(image.mean_x, x, 0.2) << e;
    EXPECT_NEAR(image.mean_y, 0, 0.1) << e;
    EXPECT_GT(image.sum, 30);
  }
}

// Two spheres, one of them thin as mist; float pictures (beaming).
std::string two_spheres(const std::string& exposure, int pictures,
                        const std::string& layers = R"(["beauty"])") {
  const Film film{80, 60, 60};
  return camera_of(film) + film.text(5, true, layers) +
         fmt::format("[animation]\nstart = 0.3\nrate = 4\npictures = {}\n{}", pictures, exposure) +
         R"(
[[object]]
name = "front"
sphere = {radius = 0.8, fineness = 2}
position = [0, 0, -4]
velocity = [0.7, 0, 0.2]
[[object]]
name = "back"
sphere = {radius = 1, fineness = 3}
position = [0.4, 0, -6]
velocity = [-0.5, 0.1, 0]
[[material]]
name = "ball"
object = "front"
base_color = [0.9, 0.5, 0.1]
opacity = 0.4
)";
}

using Together = std::function<double(const std::string& channel, double before, double next)>;

// Three exposures on one picture are three pictures taken together; `factor` at the end.
void expect_combined(const std::string& combine, const Together& together, double factor = 1) {
  const auto singles = rendered_animation(RESTFRAME_PROGRAM, two_spheres("", 3), 3);
  const ExrPicture all =
      rendered(RESTFRAME_PROGRAM,
               two_spheres("[exposure]\ncount = 3\ninterval = 0.25\n" + combine + "\n", 1));
  int covered = 0;
  for (const std::string channel : {"R", "G", "B", "A"}) {
    for (std::size_t i = 0; i < all.channel(channel).size(); ++i) {
      double expected = static_cast<double>(singles[0].channel(channel)[i]);
      for (int e = 1; e < 3; ++e) {
        expected = together(channel, expected, static_cast<double>(singles[e].channel(channel)[i]));
      }
      const double value = static_cast<double>(all.channel(channel)[i]);
      ASSERT_NEAR(value, factor * expected, 1e-6 * (1 + expected)) << channel << ' ' << i;
      covered += value > 0;
    }
  }
  EXPECT_GT(covered, 1000);
}

TEST(MultipleExposure, AddsLightAndCoversWhatIsLeft) {
  const auto sum = [](const std::string& channel, double before, double next) {
    return channel == "A" ? 1 - (1 - before) * (1 - next) : before + next;
  };
  expect_combined("", sum);
  expect_combined("combine = \"sum\"", sum);
}

TEST(MultipleExposure, TakesTheMean) {
  const auto add = [](const std::string&, double before, double next) { return before + next; };
  expect_combined("combine = \"mean\"", add, 1.0 / 3);
}

TEST(MultipleExposure, TakesTheLargest) {
  const auto larger = [](const std::string&, double before, double next) {
    return std::max(before, next);
  };
  expect_combined("combine = \"max\"", larger);
}

const std::string kAllData = R"(["beauty", "Z", "time", "doppler", "N", "P", "UV", "id"])";

// Data layers hold the pixels' centres as the first exposure opens, whatever the blur.
TEST(DataLayers, AreThoseOfTheOpening) {
  const ExrPicture still = rendered(RESTFRAME_PROGRAM, two_spheres("", 1, kAllData));
  for (const char* exposure :
       {"[exposure]\ncount = 3\ninterval = 0.25\n", "[exposure]\nshutter = 0.4\n",
        "[exposure]\nshutter = 0.1\ncount = 2\ninterval = 0.05\ncombine = \"max\"\n"}) {
    const ExrPicture picture = rendered(RESTFRAME_PROGRAM, two_spheres(exposure, 1, kAllData));
    for (const auto& [name, values] : still.channels) {
      if (name.size() == 1 && name != "Z") continue;  // the beauty
      EXPECT_EQ(values, picture.channel(name)) << name << '\n' << exposure;
    }
    EXPECT_NE(still.channel("R"), picture.channel("R"));
  }
}

// A sphere that passes at 0.6c a thousand light-seconds off, five pixels in radius: it is seen
// sideways, so its image moves evenly, by 60 pixels while the shutter is open for 20 s.
constexpr double kShutter = 20;
const Film kStreakFilm{100, 24, 5000};
const Vec3 kPassing(0.6, 0, 0);

std::string passing_sphere(const std::string& exposure, const std::string& material) {
  return camera_of(kStreakFilm) + kStreakFilm.text(256) +
         fmt::format("[exposure]\nshutter = {}\n{}\n", kShutter, exposure) +
         fmt::format(
             "[[object]]\nsphere = {{radius = 1, fineness = 4}}\nposition = [-6, 0, -1000]\ntime = "
             "{:.17g}\nvelocity = [0.6, 0, 0]\n",
             -std::hypot(1000.0, 6.0)) +
         material;
}

// Pixels from the middle, at a time since the opening.
double streak_x(double time) {
  const Vec3 place(-6 + 0.6 * std::hypot(1000.0, 6.0), 0, -1000);  // at time 0
  const Vec3 seen = seen_at(place, kPassing, time);
  return kStreakFilm.focal_length * seen.x / -seen.z;
}

// The coverage that the pixels of a column add up to: the disc's height there, through the film's
// tent filter, over the shutter's time.
double expected_column(double x, const std::function<double(double)>& openness) {
  double sum = 0, weights = 0;
  for (double u = 0.001; u < 1; u += 0.002) {
    const double weight = openness(u);
    weights += weight;
    for (double dx = -0.95; dx < 1; dx += 0.1) {
      const double off = x + dx - streak_x(u * kShutter);
      sum += weight * 0.1 * (1 - std::abs(dx)) * 2 * std::sqrt(std::max(0.0, 25 - off * off));
    }
  }
  return sum / weights;
}

void expect_streak(const std::string& opening, const std::function<double(double)>& openness) {
  const ExrPicture picture = rendered(RESTFRAME_PROGRAM, passing_sphere(opening, kUnlit));
  for (int column = 0; column < picture.width; ++column) {
    const double seen = moments_of(picture, "A", column, column, 0, 23).sum;
    const double expected = expected_column(column + 0.5 - 50, openness);
    EXPECT_NEAR(seen, expected, 0.04 + 0.04 * expected) << column;
  }
  const double area = std::numbers::pi * 25;
  EXPECT_NEAR(moments_of(picture, "A").sum, area, 0.01 * area);
}

TEST(MotionBlur, OfABoxIsAnEvenStreak) {
  EXPECT_NEAR(streak_x(0), -30, 1e-6);
  EXPECT_NEAR(streak_x(kShutter), 30, 0.1);
  expect_streak("", [](double) { return 1; });
  expect_streak("opening = \"box\"", [](double) { return 1; });
}

TEST(MotionBlur, OfATriangleIsBrightestInTheMiddle) {
  expect_streak("opening = \"triangle\"", [](double u) { return std::min(u, 1 - u); });
}

TEST(MotionBlur, OfACurveFollowsIt) {
  expect_streak("opening = [[0.0, 0.0], [0.25, 1.0], [1, 0]]",
                [](double u) { return std::min(4 * u, (1 - u) / 0.75); });
  expect_streak("opening = [[0.5, 1], [0.75, 1]]",
                [](double u) { return u > 0.5 && u < 0.75 ? 1 : 0; });
}

// Seen sideways its clock shows 16 s passing, the first 4 of them red. What is seen of a sphere is
// nearer than its centre by 2/3 of its radius, in the mean over its disc.
TEST(MotionBlur, SeesColoursAsTheirClockShowsThem) {
  const ExrPicture picture = rendered(
      RESTFRAME_PROGRAM,
      passing_sphere("",
                     "[[material]]\nname = \"ball\"\nunlit = true\nbase_color = {intervals = "
                     "[[-9, 4, [1, 0, 0]], [4, 99, [0, 0, 1]]]}\n"));
  const double red = moments_of(picture, "R").sum;
  const double blue = moments_of(picture, "B").sum;
  EXPECT_NEAR(red / (red + blue), (4 - 2.0 / 3) / 16, 0.003);
}

// Both together: each of two exposures is a streak.
TEST(MotionBlur, OfSeveralExposuresIsSeveralStreaks) {
  const ExrPicture picture =
      rendered(RESTFRAME_PROGRAM,
               passing_sphere("count = 2\ninterval = 15\nopening = [[0, 1], [0.25, 1]]", kUnlit));
  const ChannelMoments first = moments_of(picture, "R", 0, 49, 0, 23);
  const ChannelMoments second = moments_of(picture, "R", 50, 99, 0, 23);
  EXPECT_NEAR(first.mean_x, streak_x(2.5), 0.1);
  EXPECT_NEAR(second.mean_x, streak_x(17.5), 0.1);
  EXPECT_NEAR(first.sum, second.sum, 1);
}

TEST(MotionBlur, LeavesWhatStandsStill) {
  const auto scene = [](const char* exposure) {
    const Film film{60, 40, 40};
    return camera_of(film) + film.text(16, true) + exposure +
           "[[object]]\nsphere = {fineness = 3}\nposition = [0.5, 0, -3]\n";
  };
  const ExrPicture still = rendered(RESTFRAME_PROGRAM, scene(""));
  const ExrPicture blurred = rendered(RESTFRAME_PROGRAM, scene("[exposure]\nshutter = 0.5\n"));
  for (const char* channel : {"R", "A"}) {
    for (std::size_t i = 0; i < still.channel(channel).size(); ++i) {
      ASSERT_NEAR(still.channel(channel)[i], blurred.channel(channel)[i], 1e-5) << channel;
    }
  }
}

// A camera that looks at a point straight ahead turns no more than one without a target, though it
// is asked anew for each ray.
TEST(MotionBlur, IsTheSameForACameraThatAims) {
  const auto scene = [](const std::string& aim) {
    const Film film{60, 40, 40};
    return fmt::format(
               "[camera]\nposition = [0, 0, 0]\nvelocity = [0, 0, -0.5]\nfov = {}\naperture = "
               "0.1\nfocus = 5\nrolling = 0.2\n{}\n",
               film.fov(), aim) +
           film.text(16) +
           "[exposure]\nshutter = 0.5\n[[object]]\nsphere = {fineness = 3}\nposition = [0.5, 0, "
           "-6]\nvelocity = [0.3, 0, 0]\n";
  };
  const ExrPicture free = rendered(RESTFRAME_PROGRAM, scene("direction = [0, 0, -1]"));
  const ExrPicture aiming = rendered(RESTFRAME_PROGRAM, scene("look_at = [0, 0, -100]"));
  double difference = 0, light = 0;
  for (std::size_t i = 0; i < free.channel("R").size(); ++i) {
    const auto a = static_cast<double>(free.channel("R")[i]);
    difference += std::abs(a - static_cast<double>(aiming.channel("R")[i]));
    light += a;
  }
  EXPECT_GT(light, 10);
  EXPECT_LT(difference, 1e-3 * light);
}

// A rod across the motion leans by what it moves from one row to the next.
TEST(RollingShutter, MakesMovingRodsLean) {
  const Film film{100, 60, 5000};
  constexpr double rolling = 15;
  const ExrPicture picture =
      rendered(RESTFRAME_PROGRAM,
               camera_of(film, fmt::format("rolling = {}", rolling)) + film.text(16) +
                   fmt::format("[[object]]\nlattice = {{cells = [1, 2, 1], pitch = 40, ball = 0.8, "
                               "rod = 0.4}}\nposition = [-6, 0, -1000]\ntime = {:.17g}\nvelocity = "
                               "[0.6, 0, 0]\n",
                               -std::hypot(1000.0, 6.0)));
  for (int row = 0; row < film.height; ++row) {
    const double time = rolling * (row + 0.5) / film.height;
    const ChannelMoments bar = moments_of(picture, "A", 0, 99, row, row);
    EXPECT_GT(bar.sum, 3);
    EXPECT_NEAR(bar.mean_x, streak_x(time), 0.15) << row;
  }
}

}  // namespace
}  // namespace restframe
