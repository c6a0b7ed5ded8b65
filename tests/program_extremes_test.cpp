// Numbers as extreme as a scene file may state them: a picture or one line of error, never a signal.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;

constexpr const char* ball = "[[object]]\nname = \"ball\"\nsphere = {fineness = 1}\n";
constexpr const char* camera = "[camera]\nposition = [0, 0, 5]\n";

class Extremes : public ::testing::Test {
 protected:
  RunResult render(const std::string& scene, const std::vector<std::string>& more = {}) {
    const auto file = folder.write("scene.toml", scene);
    std::vector<std::string> arguments = {"render",   file.string(),
                                          "--quiet",  "--overwrite",
                                          "--output", (folder.path() / "#.exr").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    if (more.empty()) arguments.insert(arguments.end(), {"--size", "16x16", "--samples", "1"});
    return run_program(RESTFRAME_PROGRAM, arguments);
  }
  void expect_a_picture(const std::string& scene) {
    const RunResult result = render(scene);
    EXPECT_EQ(result.exit_code, 0) << scene << result.error;
    EXPECT_THAT(result.error, Not(HasSubstr("error"))) << scene;  // it may show nothing
  }
  void expect_one_error(const std::string& scene, const std::string& words) {
    const RunResult result = render(scene);
    EXPECT_EQ(result.exit_code, 2) << scene << result.error;
    EXPECT_THAT(result.error, HasSubstr("scene.toml: "));
    EXPECT_THAT(result.error, HasSubstr(words));
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "0.exr"));
  }

  TemporaryFolder folder;
};

TEST_F(Extremes, SpeedsOfLight) {
  for (const char* light_speed : {"1e-30", "1e-18", "3e8", "1e19", "1e30"}) {
    const std::string scene = fmt::format("[scene]\nlight_speed = {}\n", light_speed);
    expect_a_picture(scene + ball);
    expect_a_picture(scene + camera + ball);
  }
}

TEST_F(Extremes, ScalesAlone) {
  for (const char* scale : {"1e-30", "1e-19", "1e19", "1e30"}) {
    expect_a_picture(fmt::format("{}{}scale = {}\n", camera, ball, scale));
  }
}

TEST_F(Extremes, ScalesOfTwoInOneRestFrame) {
  for (const char* scale : {"1e-30", "1e-19", "1e19", "1e30"}) {
    expect_a_picture(fmt::format("{}{}scale = {}\n[[object]]\nsphere = {{fineness = 1}}\n", camera,
                                 ball, scale));
  }
}

TEST_F(Extremes, TheFastestAndSmallest) {
  // Lengths in millimetres, at the greatest gamma: a wave vector of 10^19 in the mesh's own units.
  expect_a_picture(fmt::format(
      "[scene]\nlight_speed = 3e8\n{}{}scale = 0.001\ngamma = 1e8\ndirection = [0, 0, 1]\n", camera,
      ball));
}

TEST_F(Extremes, NumbersWhoseSquaresOverflowAreErrors) {
  expect_one_error(std::string(camera) + ball + "position = [1e300, 0, 0]\n", "object \"ball\"");
  expect_one_error(std::string("[camera]\nposition = [1e308, 1e308, 1e308]\n") + ball, "camera");
  expect_one_error(std::string(camera) + ball + "scale = 1e300\n", "object \"ball\"");
  expect_one_error(std::string("[scene]\nlight_speed = 1e-300\n") + ball, "object \"ball\"");
}

TEST_F(Extremes, ACameraAtItsLookAtPointIsFoundBeforeAnyPicture) {
  expect_one_error(std::string("[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, 0]\n") + ball,
                   "look_at");
  // It passes the point in its third picture.
  expect_one_error(
      std::string("[camera]\nposition = [0, 0, 1.3333333333333335]\nvelocity = [0, 0, -0.8]\n"
                  "look_at = [0, 0, 0]\n[animation]\nrate = 2\npictures = 5\n") +
          ball,
      "picture 2");
}

TEST_F(Extremes, MoreThreadsThanCoresAreQuiet) {
  const RunResult result =
      render(std::string(camera) + ball, {"--threads", "300", "--size", "64x64", "--samples", "1"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.error, IsEmpty());
}

}  // namespace
}  // namespace restframe
