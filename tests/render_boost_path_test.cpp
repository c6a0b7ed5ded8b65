// Closed form 11 with light transport: lights, mirrors and glass that move, boosted together with
// their camera, give the same pictures.

#include <gtest/gtest.h>

#include "importers/importers.h"
#include "support/boosted_scene.h"
#include "support/direct_render.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

const std::string kCamera = R"toml(
[camera]
position = [0.5, 0.8, 4]
time = 0.5
velocity = [0.2, -0.1, -0.3]
direction = [0, -0.15, -1]
up = [0.1, 1, 0]
fov = 60
[animation]
start = 0.7
[output]
layers = ["beauty", "id"]
[render]
resolution = [96, 72]
integrator = "path"
beaming = true
)toml";

const std::string kBalls = R"toml(
[[object]]
name = "back"
sphere = {radius = 6, fineness = 5}
position = [0, -2, -9]
velocity = [-0.3, 0, 0.2]
[[object]]
name = "fast"
sphere = {radius = 1, fineness = 5}
position = [1, 0.7, -1.4]
velocity = [0.1, -0.2, 0.8]
[[object]]
name = "left"
sphere = {radius = 1, fineness = 5}
position = [-1.5, 0.6, 0.2]
velocity = [0, 0.6, 0.3]
)toml";

// Each pixel is one path, and has no choice of direction that would depend on the axes.
const std::string kLit = kCamera + "samples = 1\ndepth = 1\n" + kBalls + R"toml(
[[material]]
name = "ball"
base_color = [0.8, 0.5, 0.3]
metallic = 0.3
roughness = 0.5
[[light]]
type = "point"
position = [2, 4, 3]
velocity = [0.5, -0.3, 0.6]
intensity = {formula = "30 + 20 * sin(5 * t)"}
[[light]]
type = "spot"
position = [-3, 3, 3]
velocity = [0.1, 0.7, 0]
direction = [1, -1, -1]
cone = [10, 60]
sweep = {axis = [0.3, 1, 0.2], period = 7}
intensity = 60
color = "cyan"
[[light]]
type = "sun"
direction = [0.2, -0.3, -1]
velocity = [0, 0, -0.7]
intensity = {formula = "2 + sin(3 * t)"}
color = "gold"
)toml";

const std::string kMirrors = kCamera + "samples = 16\ndepth = 6\n" + kBalls + R"toml(
[[material]]
name = "ball"
base_color = "white"
metallic = 1
roughness = 0
[[material]]
name = "ball"
object = "left"
metallic = 0
transmission = 1
ior = 1.4
attenuation_color = [0.5, 0.8, 0.9]
attenuation_distance = 0.8
[[object]]
name = "lamp"
sphere = {radius = 1, fineness = 5}
position = [3, 3, 5]
velocity = [-0.5, 0, 0.1]
material = "lamp"
[[material]]
name = "lamp"
unlit = true
base_color = "black"
emission = {formula = "0.5 + 0.5 * sin(4 * t)", from = "red", to = "blue"}
[[light]]
type = "environment"
velocity = [0.4, 0.2, 0]
color = [0.3, 0.5, 0.4]
)toml";

Scene load(const std::string& text) {
  const TemporaryFolder folder;
  Warnings warnings;
  return load_scene(folder.write("scene.toml", text), {}, warnings);
}

// The part of the pixels that see anything and whose colours differ by more than `tolerance`.
double part_changed(const Picture& before, const Picture& after, double tolerance) {
  int seen = 0, changed = 0;
  for (const char* channel : {"R", "G", "B"}) {
    const auto a = channel_of(before, channel), b = channel_of(after, channel);
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] == 0 && b[i] == 0) continue;
      ++seen;
      changed += std::abs(a[i] - b[i]) > tolerance * (0.01 + std::abs(a[i]));
    }
  }
  EXPECT_GT(seen, 5000);
  return static_cast<double>(changed) / seen;
}

void expect_unchanged(const std::string& text, double tolerance, double most_changed) {
  const Scene scene = load(text);
  const Picture before = first_picture(scene);
  for (const Vec3& beta : {Vec3(0.6, 0, 0), Vec3(-0.5, 0.6, 0.4)}) {
    const Picture after = first_picture(boosted(scene, Velocity::from_beta(beta)));
    EXPECT_LT(part_changed(before, after, tolerance), most_changed) << beta.x;
  }
}

// Only on outlines may rounding choose otherwise.
TEST(BoostedPath, LightsAreTheSame) {
  expect_unchanged(kLit, 1e-3, 0.01);
}

TEST(BoostedPath, MirrorsAndGlassAreTheSame) {
  expect_unchanged(kMirrors, 5e-3, 0.03);
}

}  // namespace
}  // namespace restframe
