// Closed form 11: a whole scene boosted together with its camera gives the same pictures.

#include <gtest/gtest.h>

#include "importers/importers.h"
#include "support/boosted_scene.h"
#include "support/direct_render.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

// Lattices show how they are turned.
constexpr const char* kScene = R"(
[camera]
position = [0.5, 0.8, 3.2]
time = 0.5
velocity = [0.2, -0.1, -0.3]
direction = [0, -0.1, -1]
up = [0.1, 1, 0]
fov = 80
[animation]
start = 0.7
[render]
resolution = [160, 120]
samples = 1
[output]
layers = ["beauty", "Z", "time", "doppler", "id"]
[[object]]
lattice = {cells = [4, 4, 4], ball = 0.3, rod = 0.1, fineness = 2}
position = [0, 0, 0]
[[object]]
lattice = {cells = [4, 4, 4], ball = 0.3, rod = 0.1, fineness = 2}
position = [4, 0, -1]
rotation = [10, 20, 30]
clock = 0.2
velocity = [0, 0.9, 0]
[[object]]
lattice = {cells = [4, 4, 4], ball = 0.3, rod = 0.1, fineness = 2}
position = [-6, 0, -9]
velocity = [0.5, 0.1, 0.8]
[[object]]
sphere = {radius = 1, fineness = 4}
position = [0, 3, -2]
gamma = 20
direction = [1, 0.2, -1]
clock = "frame"
[[material]]
name = "*"
base_color = {period = 1.0, intervals = [[0.0, 0.5, "yellow"], [0.5, 1.0, "blue"]]}
)";

Scene load() {
  const TemporaryFolder folder;
  Warnings warnings;
  return load_scene(folder.write("scene.toml", kScene), {}, warnings);
}

double relative_difference(double a, double b) {
  return std::abs(a - b) / (1 + std::abs(a));
}

struct Compared {
  int hits = 0;
  int others = 0;  // pixels that show another place
  int colors = 0;  // pixels that show another colour
};

// Counts pixels that differ; where the same is seen, Z, D and the clock must agree.
Compared compare(const Picture& before, const Picture& after) {
  const auto id = channel_of(before, "id_object.V"), other_id = channel_of(after, "id_object.V");
  const auto z = channel_of(before, "Z"), other_z = channel_of(after, "Z");
  Compared counts;
  std::vector<std::size_t> same;
  for (std::size_t i = 0; i < id.size(); ++i) {
    // Another part of the same lattice may be seen near an edge.
    const bool other =
        id[i] != other_id[i] || (id[i] != 0 && relative_difference(z[i], other_z[i]) > 1e-3);
    counts.others += other;
    if (id[i] != 0 && !other) same.push_back(i);
    counts.colors += glm::length(before.rgba()[i] - after.rgba()[i]) > 0.01F;
  }
  for (const char* name : {"Z", "doppler.D", "time_proper.V"}) {
    const auto a = channel_of(before, name), b = channel_of(after, name);
    double worst = 0;
    for (const std::size_t i : same) worst = std::max(worst, relative_difference(a[i], b[i]));
    EXPECT_LE(worst, 1e-5) << name;
  }
  counts.hits = static_cast<int>(same.size());
  return counts;
}

TEST(BoostedPicture, IsTheSame) {
  const Scene scene = load();
  const Picture picture = first_picture(scene);
  for (const Velocity& new_world :
       {std::get<Worldline>(scene.camera.motion).velocity, Velocity::from_beta({0.6, 0, 0}),
        Velocity::from_beta({0, 0.9, 0}), Velocity::from_beta({-0.5, 0.7, 0.2}),
        Velocity::from_gamma(10, {1, 2, -2})}) {
    const Vec3 beta = new_world.beta();
    SCOPED_TRACE(testing::Message() << beta.x << ' ' << beta.y << ' ' << beta.z);
    const Compared counts = compare(picture, first_picture(boosted(scene, new_world)));
    EXPECT_GT(counts.hits, 160 * 120 / 4);
    EXPECT_LE(counts.others, 160 * 120 / 1000);
    EXPECT_LE(counts.colors, 160 * 120 / 1000);
  }
}

}  // namespace
}  // namespace restframe
