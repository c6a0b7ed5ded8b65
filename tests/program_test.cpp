// The program as a process: options, exit codes, messages, interruption.

#include <gtest/gtest.h>

#include "support/program_errors.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

constexpr const char* kScene = R"([camera]
position = [0, 0, 4]

[animation]
pictures = 3

[render]
resolution = [32, 24]
samples = 1

[output]
path = "out/p.###.exr"

[[object]]
name = "ball"
sphere = {radius = 1, fineness = 2}
velocity = [0, 0, 0.5]

[[object]]
name = "still"
sphere = {radius = 0.5, fineness = 2}
position = [1, 0, 0]
)";

RunResult run(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
              RunOptions options = {}) {
  options.folder = folder.path();
  return run_program(RESTFRAME_PROGRAM, arguments, options);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// What the scene with this line in place of another does.
RunResult run_changed(const std::string& line, const std::string& by,
                      const std::string& command = "render") {
  const TemporaryFolder folder;
  std::string text = kScene;
  text.replace(text.find(line), line.size(), by);
  folder.write("scene.toml", text);
  const RunResult result = run(folder, {command, "scene.toml"});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/p.000.exr"));
  return result;
}

TEST(Program, HelpStartsANewcomer) {
  const TemporaryFolder folder;
  const RunResult result = run(folder, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* word :
       {"render", "lattice", "curves", "info", "check", "scene.toml", "Exit codes"}) {
    EXPECT_TRUE(has(result.out, word)) << word;
  }
  EXPECT_TRUE(result.error.empty());
  for (const char* command : {"render", "lattice", "curves", "info", "check"}) {
    const RunResult help = run(folder, {command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_TRUE(has(help.out, "--help")) << command;
  }
}

TEST(Program, Version) {
  const RunResult result = run(TemporaryFolder(), {"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, std::string("restframe ") + RESTFRAME_VERSION + "\n");
}

TEST(Program, BadOptionsExitWithTwo) {
  const TemporaryFolder folder;
  folder.write("scene.toml", kScene);
  expect_error(run(folder, {}), 2, {});
  expect_error(run(folder, {"rendre", "x"}), 2, {"\"rendre\"", "the nearest is \"render\""});
  expect_error(run(folder, {"render"}), 2, {"SCENE"});
  expect_error(run(folder, {"render", "scene.toml", "--sampels", "3"}), 2, {"--sampels"});
  const std::vector<std::pair<const char*, const char*>> bad = {
      {"--samples", "0"},    {"--samples", "x"},    {"--threads", "-1"},
      {"--size", "0x5"},     {"--size", "640"},     {"--size", "3x4x5"},
      {"--pictures", "3"},   {"--pictures", "2-1"}, {"--pictures", "-1"},
      {"--pictures", "a"},   {"--pictures", "0-3"}, {"--pictures", "0-"},
      {"--pictures", "1;2"}, {"--output", "x.png"}, {"--output", "noplace.exr"}};
  for (const auto& [option, value] : bad) {
    SCOPED_TRACE(std::string(option) + " " + value);
    expect_error(run(folder, {"render", "scene.toml", std::string(option) + "=" + value}), 2, {});
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

TEST(Program, MissingFilesAreNamed) {
  const TemporaryFolder folder;
  for (const char* command : {"render", "info", "check"}) {
    for (const char* file : {"missing.toml", "missing.glb", "missing.obj"}) {
      expect_error(run(folder, {command, file}), 2, {file});
    }
  }
  expect_error(run(folder, {"render", "."}), 2, {});
  folder.write("asset.xyz", "");
  expect_error(run(folder, {"render", "asset.xyz"}), 2, {"asset.xyz"});
}

TEST(Program, FaultsOfScenesHaveTheirPlace) {
  expect_error(run_changed("velocity = [0, 0, 0.5]", "velocity = [0, 0, 1.2]"), 2,
               {"scene.toml:17:12: object \"ball\": |velocity| is 1.2, must be below 1"});
  expect_error(run_changed("samples = 1", "sampels = 1"), 2,
               {"scene.toml:9:1: ", "sampels", "samples"});
  expect_error(run_changed("samples = 1", "samples = "), 2, {"scene.toml:9:"});
}

TEST(Program, FormulasThatFailWhileRenderingHaveTheirPlace) {
  const TemporaryFolder folder;
  const std::string material = "\n[[material]]\nname = \"ball\"\n";
  const std::string text =
      kScene + material + "emission_strength = {formula = \"sqrt(t - 1000)\"}\n";
  folder.write("scene.toml", text);
  const auto line = std::count(text.begin(), text.end(), '\n');
  expect_error(
      run(folder, {"render", "scene.toml"}), 2,
      {"scene.toml:" + std::to_string(line) + ":32: material \"ball\": emission_strength: ",
       "formula \"sqrt(t - 1000)\": no finite value at t = "});
}

TEST(Program, CheckListsEveryFault) {
  const RunResult result =
      run_changed("samples = 1", "samples = 0\nresolution_ = 1\nseed = -3", "check");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 3) << result.error;
  for (const char* place : {"scene.toml:9:", "scene.toml:10:", "scene.toml:11:"}) {
    EXPECT_TRUE(has(result.error, place)) << result.error;
  }
  const TemporaryFolder folder;
  folder.write("scene.toml", kScene);
  const RunResult good = run(folder, {"check", "scene.toml"});
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_TRUE(has(good.out, "no fault"));
  EXPECT_TRUE(good.error.empty());
}

TEST(Program, InfoSaysWhatIsThere) {
  const TemporaryFolder folder;
  folder.write("scene.toml", kScene);
  const RunResult result = run(folder, {"info", "scene.toml"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  for (const char* part : {"2 rest frames", "2 objects", "ball", "still", "320 triangles, closed",
                           "[0, 0, 0.5]", "gamma 1.1547", "memory", "material"}) {
    EXPECT_TRUE(has(result.out, part)) << part << " is not in\n" << result.out;
  }
}

TEST(Program, FormulasWithoutValueAreNamed) {
  const RunResult result = run_changed(
      "velocity = [0, 0, 0.5]",
      "velocity = [0, 0, 0.5]\n[[material]]\nname = \"ball\"\nemission_strength = {formula = "
      "\"sqrt(-1-t*t)\"}\nemission = \"white\"\n");
  expect_error(result, 2, {"sqrt(-1-t*t)", "t = "});
}

TEST(Program, SigtermEndsARenderingAtOnce) {
  for (const int signal : {SIGTERM, SIGINT}) {
    const TemporaryFolder folder;
    folder.write("scene.toml", kScene);
    RunOptions options;
    options.timeout = std::chrono::milliseconds(1000);
    options.signal = signal;
    const RunResult result =
        run(folder, {"render", "scene.toml", "--size", "4000x4000", "--samples", "1000"}, options);
    EXPECT_TRUE(result.timed_out);
    expect_error(result, 130, {"interrupted"});
    EXPECT_LT(result.duration.count(), 1000 + 3000);
    EXPECT_TRUE(!std::filesystem::exists(folder.path() / "out") ||
                std::filesystem::is_empty(folder.path() / "out"));
  }
}

// As many files as there are, hidden ones too.
std::size_t files_in(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return 0;
  const std::filesystem::recursive_directory_iterator files(folder);
  return static_cast<std::size_t>(std::count_if(
      begin(files), end(files), [](const auto& entry) { return entry.is_regular_file(); }));
}

TEST(Program, AFullDiskLeavesNothing) {
  const TemporaryFolder folder;
  folder.write("scene.toml", kScene);
  RunOptions options;
  options.largest_file = 500;
  const RunResult result = run(folder, {"render", "scene.toml"}, options);
  expect_error(result, 3, {"out/p.000"});
  // The small preview fits; of the picture itself nothing stays.
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/p.000.exr"));
  EXPECT_LE(files_in(folder.path() / "out"), 1U);
}

TEST(Program, PlacesThatCannotBeWrittenAreNamed) {
  const TemporaryFolder folder;
  folder.write("scene.toml", kScene);
  folder.write("file", "");
  const RunResult in_file = run(folder, {"render", "scene.toml", "-o", "file/p.###.exr"});
  expect_error(in_file, 3, {"file"});
  const RunResult device = run(folder, {"render", "scene.toml", "-o", "/dev/full/p.###.exr"});
  expect_error(device, 3, {"/dev/full"});
  std::filesystem::create_directory(folder.path() / "p.000.exr");
  const RunResult on_folder = run(folder, {"render", "scene.toml", "-o", "p.###.exr"});
  expect_error(on_folder, 3, {"p.000.exr"});
}

TEST(Program, LatticesAreWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  for (const char* name : {"l.glb", "l.obj"}) {
    EXPECT_EQ(run(folder, {"lattice", "-o", name, "--cells", "2x2x2"}).exit_code, 0);
    EXPECT_EQ(run(folder, {"check", name}).exit_code, 0);
    RunOptions options;
    options.largest_file = 300;
    const std::string other = std::string("full-") + name;
    expect_error(run(folder, {"lattice", "-o", other, "--cells", "2x2x2"}, options), 3, {other});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / other));
  }
  expect_error(run(folder, {"lattice", "-o", "x.glb", "--cells", "2x2"}), 2, {"--cells"});
  expect_error(run(folder, {"lattice", "-o", "x.glb", "--rod", "0.5"}), 2, {"rod"});
  expect_error(run(folder, {"lattice", "-o", "x.stl"}), 2, {"x.stl"});
}

}  // namespace
}  // namespace restframe
