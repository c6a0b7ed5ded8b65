// The same bytes for any number of threads.

#include <gtest/gtest.h>

#include <iterator>

#include "film/preview.h"
#include "support/exr_writer.h"
#include "support/file_bytes.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

// Every kind of material property that is evaluated on the ray path.
constexpr const char* kScene = R"toml(
[camera]
position = [0, 0, 4]
velocity = [0.1, 0, -0.4]
look_at = [0, 0, 0]
[animation]
rate = 20
pictures = 2
[render]
resolution = [90, 70]
samples = 3
seed = 7
[output]
layers = ["beauty", "Z", "time", "doppler", "N", "P", "UV", "id", "emission", "direct", "reflection", "lights", "albedo", "motion"]
[[object]]
name = "board"
asset = "board.obj"
position = [0, 0, -1]
velocity = [0, 0, 0.3]
[[object]]
name = "lattice"
lattice = {cells = [2, 2, 2], ball = 0.3, rod = 0.1, fineness = 1}
velocity = [0.6, 0, 0.2]
[[object]]
name = "veil"
sphere = {radius = 0.8, fineness = 2}
position = [0.2, 0.1, 1]
gamma = 5
direction = [0, 1, 0.1]
[[material]]
name = "board"
emission = {period = 0.7, keys = [[0.0, "black"], [0.3, "red"], [0.7, "black"]]}
[[material]]
name = "balls"
base_color = {formula = "0.5 + 0.5*sin(2*pi*t)", from = "green", to = "white"}
[[material]]
name = "rods"
base_color = {period = 1.0, intervals = [[0.0, 0.5, "yellow"], [0.5, 1.0, "blue"]]}
[[material]]
name = "ball"
object = "veil"
opacity = {formula = "0.5 + 0.4*cos(20*t)"}
)toml";

constexpr const char* kBoard = R"(mtllib board.mtl
v -3 -3 0
v 3 -3 0
v 3 3 0
v -3 3 0
vt 0 0
vt 4 0
vt 4 4
vt 0 4
usemtl board
f 1/1 2/2 3/3 4/4
)";

// Stripes of colours.
void write_texture(const std::filesystem::path& path) {
  constexpr int size = 8;
  const Layer layers[] = {Layer::beauty};
  Picture texture({0, 0, size, size}, layers, {});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      texture.set_radiance(x, y,
                           Vec4f(0.125F * static_cast<float>(x), 0.125F * static_cast<float>(y),
                                 (x + y) % 2 ? 1.0F : 0.2F, 1));
    }
  }
  write_preview(path, texture, {});
}

// Both pictures' files, one after the other.
std::string pictures_with(const TemporaryFolder& folder, int threads) {
  const auto out = folder.path() / std::to_string(threads);
  const RunResult result =
      run_program(RESTFRAME_PROGRAM,
                  {"render", (folder.path() / "scene.toml").string(), "--output",
                   (out / "##.exr").string(), "--quiet", "--threads", std::to_string(threads)});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  std::string bytes;
  for (const char* name : {"00.exr", "00.png", "01.exr", "01.png"}) bytes += bytes_of(out / name);
  return bytes;
}

void expect_the_same_bytes(const std::string& scene) {
  const TemporaryFolder folder;
  folder.write("scene.toml", scene);
  folder.write("board.obj", kBoard);
  folder.write("board.mtl", "newmtl board\nKd 1 1 1\nmap_Kd board.png\n");
  write_texture(folder.path() / "board.png");
  folder.write("sky.exr", sky_exr(32, 16, [](int x, int y) {
                 return x == 7 && y == 3 ? Vec3f(90) : Vec3f(0.01F * static_cast<float>(x + y));
               }));
  const std::string one = pictures_with(folder, 1);
  ASSERT_GT(one.size(), 20000U);
  EXPECT_TRUE(one == pictures_with(folder, 2));
  EXPECT_TRUE(one == pictures_with(folder, 5));
}

TEST(Determinism, TheSameBytesForAnyNumberOfThreads) {
  expect_the_same_bytes(kScene);
}

TEST(Determinism, TheSameBytesWithAllThatIsDrawnAtRandom) {
  std::string scene = kScene;
  const std::string before = "look_at = [0, 0, 0]\n";
  scene.insert(scene.find(before), "aperture = 0.1\nfocus = 4\nrolling = 0.05\n");
  scene += "[exposure]\nshutter = 0.1\nopening = \"triangle\"\ncount = 2\ninterval = 0.2\n";
  expect_the_same_bytes(scene);
}

// The same scene lit by what glows in it, by its lattice of many velocities' lights and by a map.
TEST(Determinism, TheSameBytesWithLightTransport) {
  std::string scene = kScene;
  const std::string before = "samples = 3\n";
  scene.insert(scene.find(before), "integrator = \"path\"\nbeaming = true\ndepth = 4\n");
  scene +=
      "[[material]]\nname = \"rods\"\nobject = \"lattice\"\nemission = {formula = \"0.5 + "
      "0.5*sin(9*t)\", from = \"blue\", to = \"white\"}\n[[light]]\ntype = \"environment\"\n"
      "file = \"sky.exr\"\nvelocity = [0.3, 0, 0.4]\n[[light]]\ntype = \"point\"\nposition "
      "= [1, 3, 2]\n";
  expect_the_same_bytes(scene);
}

}  // namespace
}  // namespace restframe
