// Scene files and options of strangers.

#include <fmt/format.h>
#include <sys/stat.h>

#include "support/hostile.h"
#include "support/program_errors.h"

namespace restframe {
namespace {

using test::Hostile;

class HostileScene : public Hostile {
 protected:
  void expect_scene_refused(const std::string& text, const std::string& begin,
                            const std::string& part) const {
    SCOPED_TRACE(text);
    folder.write("s.toml", text);
    expect_refused("s.toml", begin, part);
  }
  void expect_object_refused(const std::string& line, const std::string& begin,
                             const std::string& part) const {
    expect_scene_refused(ball + line + "\n", begin, part);
  }
  void expect_camera_refused(const std::string& line, const std::string& begin,
                             const std::string& part) const {
    expect_scene_refused("[camera]\nposition = [0, 0, 4]\n" + line + "\n" + ball, begin, part);
  }
  void expect_section_refused(const std::string& section, const std::string& line,
                              const std::string& part) const {
    expect_scene_refused(fmt::format("[{}]\n{}\n{}", section, line, ball), "2:", part);
  }
  void expect_roughness_refused(const std::string& function, const std::string& part) const {
    expect_scene_refused(
        fmt::format("{}[[material]]\nname = \"ball\"\nroughness = {}\n", ball, function),
        "6:", part);
  }

  std::string ball = "[[object]]\nname = \"a\"\nsphere = {fineness = 1}\n";  // three lines
};

TEST_F(HostileScene, Velocities) {
  expect_object_refused("velocity = [0, 0, 1]", "4:12: ", "|velocity| is 1, must be below 1");
  expect_object_refused("velocity = [0, 0, 1.2]", "4:12: ", "|velocity| is 1.2, must be below 1");
  expect_object_refused("velocity = [0, 0, nan]", "4:", "finite");
  expect_object_refused("gamma = 0.5\ndirection = [0, 0, 1]", "4:9: ", "gamma is 0.5");
  expect_object_refused("gamma = nan\ndirection = [0, 0, 1]", "4:9: ", "finite");
  expect_camera_refused("velocity = [0, 1, 0]", "3:12: ", "|velocity| is 1, must be below 1");
}

TEST_F(HostileScene, FieldsOfView) {
  for (const char* fov : {"0", "-10", "180", "1e9"}) {
    expect_camera_refused(fmt::format("fov = {}", fov), "3:7: ", "above 0 and below 180");
  }
  expect_camera_refused("fov = nan", "3:7: ", "finite");
}

TEST_F(HostileScene, SamplesResolutionAndRate) {
  for (const char* samples : {"0", "-1", "65537", "1e3", "\"many\""}) {
    expect_section_refused("render", fmt::format("samples = {}", samples), "samples");
  }
  for (const char* size : {"[0, 10]", "[10, -1]", "[10]", "[40000, 40000]", "10"}) {
    expect_section_refused("render", fmt::format("resolution = {}", size), "");
  }
  for (const char* rate : {"0", "-1", "nan", "inf"}) {
    expect_section_refused("animation", fmt::format("rate = {}", rate), "rate");
  }
  for (const char* pictures : {"0", "-1", "1.5"}) {
    expect_section_refused("animation", fmt::format("pictures = {}", pictures), "pictures is ");
  }
}

TEST_F(HostileScene, UnknownKeysNameTheNearest) {
  expect_camera_refused("fvo = 3",
                        "3:1: ", "unknown key \"fvo\", the nearest known one is \"fov\"");
  expect_scene_refused("[camra]\n" + ball, "1:2: ", "\"camera\"");
}

TEST_F(HostileScene, WhatDoesNotExist) {
  expect_object_refused("material = \"rde\"", "4:12: ", "no material \"rde\"");
  expect_camera_refused("track = \"b\"", "3:", "\"b\"");
  expect_scene_refused(ball + "[[material]]\nname = \"ball\"\nobject = \"b\"\n",
                       "6:10: ", "no object \"b\"");
  for (const char* name : {"missing.glb", "missing.obj"}) {
    expect_scene_refused(fmt::format("[[object]]\nasset = \"{}\"\n", name),
                         "2:9: ", "no such file");
  }
}

TEST_F(HostileScene, AssetsThatAreNoFiles) {
  ASSERT_EQ(::mkfifo((folder.path() / "fifo.glb").c_str(), 0600), 0);
  std::filesystem::create_directory(folder.path() / "folder.glb");
  expect_scene_refused("[[object]]\nasset = \"fifo.glb\"\n", "2:9: ", "not a regular file");
  expect_scene_refused("[[object]]\nasset = \"folder.glb\"\n", "2:9: ", "is a folder");
  expect_scene_refused("[[object]]\nasset = \"/dev/zero\"\n", "2:9: ", "not a regular file");
}

TEST_F(HostileScene, IntervalsAndKeys) {
  expect_roughness_refused("{period = 1, intervals = [[0, 0.6, 0], [0.5, 1, 1]]}", "overlaps");
  expect_roughness_refused("{period = 1, intervals = [[0, 1.5, 0]]}", "leaves the period");
  expect_roughness_refused("{intervals = [[0, nan, 0]]}", "finite");
  expect_roughness_refused("{keys = [[1, 0], [0, 1]]}", "out of order");
  expect_roughness_refused("{period = 0, keys = [[0, 1]]}", "period is 0");
}

TEST_F(HostileScene, Formulas) {
  for (const char* formula : {"sin(", "t +", ")", "1 2", "x", "\\\"t\\\"", ""}) {
    expect_roughness_refused(fmt::format("{{formula = \"{}\"}}", formula), "formula");
  }
  expect_roughness_refused("{formula = \"t = 5\"}", "assign");
  expect_roughness_refused("{formula = \"1, 2, 3\"}", "list of 3");
  expect_roughness_refused(fmt::format("{{formula = \"{}\"}}", std::string(20'000, '1')), "longer");
}

TEST_F(HostileScene, TextThatIsNoScene) {
  expect_scene_refused("", "1:1: ", "no [[object]]");
  expect_scene_refused("x = \"\xff\"", "1:", "");
  expect_scene_refused("x = " + std::string(100'000, '['), "1:", "");
  expect_scene_refused("x" + std::string(100'000, '.') + " = 1", "1:", "deeper");
  expect_scene_refused(std::string("a = 1\0", 6), "1:", "");
}

TEST_F(HostileScene, WorkIsBoundedBeforeItStarts) {
  expect_scene_refused("[[object]]\nlattice = {cells = [1000, 1000, 3]}\n",
                       "2:11: ", "balls and rods");
  std::string spheres;
  for (int i = 0; i < 400; ++i) {
    spheres += fmt::format("[[object]]\nsphere = {{fineness = 7, radius = {}}}\n", i + 1);
  }
  folder.write("s.toml", spheres);
  expect_refused("s.toml", "2:10: ", "up to here, must have at most 1000",
                 {"--max-triangles", "1000"});
}

// Each of these lines has a fault whose message looks for the nearest of many words.
TEST_F(HostileScene, MegabytesOfFaults) {
  std::string keys = "[camera]\n", intervals;
  for (int i = 0; i < 100'000; ++i) {
    keys += fmt::format("{}{} = 1\n", std::string(90, 'k'), i);
    intervals += "% interval 0 1 " + std::string(90, 'c') + "\n";
  }
  folder.write("s.toml", keys);
  expect_refused("s.toml", "1:1: ", "999 more");
  folder.write("f.txt", intervals);
  folder.write("s.toml", ball + "[[material]]\nname = \"ball\"\nbase_color = {file = \"f.txt\"}\n");
  const RunResult result = render("s.toml");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.error, ::testing::HasSubstr("f.txt:1:16: "));
  EXPECT_THAT(result.error, ::testing::HasSubstr("999 more"));
}

TEST_F(HostileScene, OptionsInPlaceOfTheScene) {
  folder.write("s.toml", ball);
  const std::vector<std::vector<std::string>> bad = {
      {"--samples", "0"},    {"--samples", "-1"}, {"--size", "0x0"},  {"--size", "x"},
      {"--pictures", "1-0"}, {"--threads", "-2"}, {"--sampels", "1"}, {"--samples", "nan"}};
  for (const auto& options : bad) {
    SCOPED_TRACE(options[0] + " " + options[1]);
    expect_error(run({"render", "s.toml", options[0] + "=" + options[1]}), 2, {});
  }
}

TEST_F(HostileScene, PlacesThatCannotBeWritten) {
  folder.write("s.toml", ball);
  for (const char* place : {"/dev/full/#.exr", "/proc/nowhere/#.exr", "s.toml/#.exr"}) {
    SCOPED_TRACE(place);
    const RunResult result =
        run({"render", "s.toml", "--quiet", "--size", "8x8", "--samples", "1", "--output", place});
    expect_error(result, 3, {});
  }
}

TEST_F(HostileScene, AFullDisk) {
  folder.write("s.toml", ball);
  RunOptions options;
  options.folder = folder.path();
  options.largest_file = 100;
  const RunResult result = run_program(
      RESTFRAME_PROGRAM,
      {"render", "s.toml", "--quiet", "--size", "32x32", "--samples", "1", "--output", "out/#.exr"},
      options);
  EXPECT_EQ(result.exit_code, 3) << result.error;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/0.exr"));
}

}  // namespace
}  // namespace restframe
