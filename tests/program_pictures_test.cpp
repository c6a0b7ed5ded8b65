// The files that `restframe render` leaves: their names, resuming, and what their headers say.

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>

#include "support/exr_reader.h"
#include "support/scene_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = R"(
[scene]
light_speed = 2
[camera]
position = [1, 2, 4]
velocity = [0, 0, -0.5]
direction = [0, 0, -1]
fov = 60
[animation]
rate = 25
start = 0.5
pictures = 3
[render]
resolution = [32, 24]
samples = 2
seed = 5
[output]
layers = ["beauty", "Z"]
[[object]]
name = "ball"
sphere = {radius = 1, fineness = 2}
)";

class Pictures : public testing::Test, public SceneFolder {
 protected:
  Pictures() : SceneFolder(kScene) {}
};

TEST_F(Pictures, AreNumberedInPlaceOfHashes) {
  EXPECT_EQ(render({"-o", "a/x.##.exr"}).exit_code, 0);
  for (const char* name : {"a/x.00.exr", "a/x.01.exr", "a/x.02.exr", "a/x.02.png"}) {
    EXPECT_TRUE(exists(name)) << name;
  }
  EXPECT_FALSE(exists("a/x.03.exr"));
  EXPECT_EQ(render({"-o", "b/x.#.exr", "--pictures", "1-2"}).exit_code, 0);
  EXPECT_FALSE(exists("b/x.0.exr"));
  EXPECT_TRUE(exists("b/x.1.exr") && exists("b/x.2.exr"));
  EXPECT_EQ(render({"-o", "c.###.exr", "-p", "2"}).exit_code, 0);
  EXPECT_EQ(read_exr(path("c.002.exr")).attributes.at("pictureNumber"), "2");
}

TEST_F(Pictures, ThatAreThereAreKept) {
  ASSERT_EQ(render({"-o", "p.#.exr"}).exit_code, 0);
  const auto time = fs::last_write_time(path("p.1.exr"));
  const std::string before = content("p.1.exr");
  fs::remove(path("p.2.exr"));
  const RunResult again = render({"-o", "p.#.exr"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.out.find("1 of 3"), std::string::npos) << again.out;
  EXPECT_EQ(fs::last_write_time(path("p.1.exr")), time);
  EXPECT_EQ(content("p.1.exr"), before);
  EXPECT_TRUE(exists("p.2.exr"));
}

TEST_F(Pictures, ThatAreTornAreMadeAgain) {
  ASSERT_EQ(render({"-o", "p.#.exr"}).exit_code, 0);
  const std::string whole = content("p.1.exr");
  for (const std::size_t left :
       {whole.size() - 1, whole.size() / 2, std::size_t{100}, std::size_t{0}}) {
    fs::resize_file(path("p.1.exr"), left);
    EXPECT_EQ(render({"-o", "p.#.exr"}).exit_code, 0);
    EXPECT_TRUE(content("p.1.exr") == whole) << left << " bytes were left";
  }
}

TEST_F(Pictures, OfAnotherSceneAreRefusedUnlessOverwritten) {
  ASSERT_EQ(render({"-o", "p.#.exr"}).exit_code, 0);
  const std::string before = content("p.0.exr");
  change_scene("radius = 1", "radius = 0.75");
  const RunResult refused = render({"-o", "p.#.exr"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.error.find("p.0.exr"), std::string::npos) << refused.error;
  EXPECT_NE(refused.error.find("--overwrite"), std::string::npos) << refused.error;
  EXPECT_TRUE(content("p.0.exr") == before);
  EXPECT_EQ(render({"-o", "p.#.exr", "--overwrite"}).exit_code, 0);
  EXPECT_FALSE(content("p.0.exr") == before);
}

TEST_F(Pictures, RefusalSaysWhatDiffers) {
  ASSERT_EQ(render({"-o", "p.#.exr"}).exit_code, 0);
  const RunResult samples = render({"-o", "p.#.exr", "--samples", "3"});
  EXPECT_EQ(samples.exit_code, 2);
  EXPECT_NE(samples.error.find("samples"), std::string::npos) << samples.error;
  change_scene("fov = 60", "fov = 61");
  const RunResult fov = render({"-o", "p.#.exr"});
  EXPECT_EQ(fov.exit_code, 2);
  EXPECT_NE(fov.error.find("fov"), std::string::npos) << fov.error;
}

std::vector<double> numbers_in(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<double>(stream), {}};
}

// A row vector (x, y, z, 1) times a matrix, row by row as the header has it.
std::vector<double> times(const std::vector<double>& v, const std::vector<double>& m) {
  std::vector<double> result(4, 0.0);
  for (std::size_t i = 0; i < 16; ++i) result[i % 4] += v[i / 4] * m[i];
  return result;
}

TEST_F(Pictures, HeadersSayWhatMadeThem) {
  ASSERT_EQ(render({"-o", "p.#.exr"}).exit_code, 0);
  const auto attributes = read_exr(path("p.1.exr")).attributes;
  EXPECT_EQ(attributes.at("software"), std::string("restframe ") + RESTFRAME_VERSION);
  EXPECT_EQ(attributes.at("pictureNumber"), "1");
  EXPECT_NEAR(std::stod(attributes.at("cameraTime")), 0.54, 1e-12);
  EXPECT_EQ(attributes.at("samples"), "2");
  EXPECT_EQ(attributes.at("seed"), "5");
  EXPECT_EQ(attributes.at("depthType"), "distance");
  EXPECT_EQ(attributes.at("objectNames"), "ball");
  EXPECT_EQ(attributes.at("timeOrigin"), "0 0");
  EXPECT_TRUE(attributes.count("framesPerSecond"));
  EXPECT_TRUE(attributes.count("restframeSettings"));
  EXPECT_EQ(attributes.at("compression"), "zip");
  const std::vector<double> velocity = numbers_in(attributes.at("cameraVelocity"));
  ASSERT_EQ(velocity.size(), 3U);
  EXPECT_NEAR(velocity[2], -0.5, 1e-15);
}

// At its own time tau the camera is at gamma beta tau (times the light's speed) from its start. A
// point 3 ahead, 1 to the right and 0.5 up has these coordinates beside the camera: OpenEXR's z is
// along the view. On the film of half-height tan 30, from (0, 0) top left to (1, 1):
TEST_F(Pictures, HeadersHoldTheCamerasMatrices) {
  ASSERT_EQ(render({"-o", "p.#.exr"}).exit_code, 0);
  const auto attributes = read_exr(path("p.1.exr")).attributes;
  const double z = 4 - 2 * 0.54 * 0.5 / std::sqrt(0.75);
  const std::vector<double> point = {1 + 1, 2 + 0.5, z - 3, 1};
  const auto beside = times(point, numbers_in(attributes.at("worldToCamera")));
  EXPECT_NEAR(beside[0], 1, 1e-6);
  EXPECT_NEAR(beside[1], 0.5, 1e-6);
  EXPECT_NEAR(beside[2], 3, 1e-6);
  EXPECT_NEAR(beside[3], 1, 1e-6);
  const auto film = times(point, numbers_in(attributes.at("worldToNDC")));
  const double half_height = std::tan(std::numbers::pi / 6), half_width = half_height * 32 / 24;
  EXPECT_NEAR(film[0] / film[3], 0.5 + 0.5 * (1.0 / 3) / half_width, 1e-6);
  EXPECT_NEAR(film[1] / film[3], 0.5 - 0.5 * (0.5 / 3) / half_height, 1e-6);
}

// Half holds up to 65504; D^4 = 39,600 at 0.99c times an emission of 10 goes beyond.
TEST_F(Pictures, BeamingNeedsFloats) {
  const std::string bright = R"(
velocity = [0, 0, 0.99]
[[material]]
name = "ball"
unlit = true
base_color = "black"
emission = "white"
emission_strength = 10
)";
  const std::string ball = "sphere = {radius = 1, fineness = 2}\n";
  std::string text = kScene;
  text.replace(text.find(ball), ball.size(), ball + "position = [1, 2, -500]" + bright);
  text.replace(text.find("velocity = [0, 0, -0.5]"), 23, "velocity = [0, 0, 0]");
  text.replace(text.find("fov = 60"), 8, "fov = 0.001");
  text.replace(text.find("seed = 5"), 8, "beaming = true");
  write("scene.toml", text);
  const RunResult result = render({"-o", "p.#.exr", "-p", "0"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(result.error.empty()) << result.error;
  const double expected = 10 * std::pow(1.99 / 0.01, 2);
  EXPECT_NEAR(read_exr(path("p.0.exr")).at("G", 16, 12), expected, 1e-5 * expected);
}

}  // namespace
}  // namespace restframe
