// Coverages of Cryptomatte's layers in rendered pictures, against closed forms.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/picture_files.h"
#include "support/direct_render.h"
#include "support/exposed_scene.h"
#include "support/loaded_scene.h"
#include "support/matte_reader.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;

const std::string all_mattes = R"(["beauty", "crypto_object", "crypto_material", "crypto_asset"])";

std::string ball(const std::string& name, const Vec3& position, double radius,
                 const std::string& more = "") {
  return fmt::format(
      "[[object]]\nname = '{}'\nsphere = {{radius = {:.17g}, fineness = 5}}\nposition = {}\n{}\n",
      name, radius, toml(position), more);
}

// A camera at the origin that looks along -z.
std::string seen(const Film& film, int samples, const std::string& layers = all_mattes) {
  return film.text(samples, false, layers) +
         fmt::format("[camera]\nposition = [0, 0, 0]\ndirection = [0, 0, -1]\nfov = {:.17g}\n",
                     film.fov());
}

Scene scene_of(const std::string& text, IntegratorKind integrator = IntegratorKind::preview,
               const std::vector<AssetFile>& files = {}) {
  Scene scene = loaded_scene(text, files);
  scene.render.integrator = integrator;
  return scene;
}

ExrPicture written(const Scene& scene, const Picture& picture) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "picture.exr";
  write_exr(path, picture, picture_info(common_info(scene), scene, 0));
  return read_exr(path);
}

MatteReader mattes(const Scene& scene, const std::string& layer) {
  return {written(scene, first_picture(scene)), layer};
}

constexpr IntegratorKind both[] = {IntegratorKind::preview, IntegratorKind::path};

// Film pixels; y downwards.
struct Disk {
  double x = 0, y = 0, radius = 0;
};

// A ball of this radius, far away: at 1/100 of its distance from the axis its outline is round to 1e-4.
Disk disk_of(const Film& film, const Vec3& center, double radius) {
  const double distance = glm::length(center);
  return {0.5 * film.width - film.focal_length * center.x / center.z,
          0.5 * film.height + film.focal_length * center.y / center.z,
          film.focal_length * radius / std::sqrt(distance * distance - radius * radius)};
}

// Closed form: what a pixel sees of a disk through the tent filter, by the midpoint rule.
double tent_coverage(const Disk& disk, int x, int y, int steps = 40) {
  const double dx = x + 0.5 - disk.x, dy = y + 0.5 - disk.y;
  const double apart = std::hypot(dx, dy);
  if (apart > disk.radius + 1.5) return 0;
  if (apart < disk.radius - 1.5) return 1;
  double sum = 0;
  for (int i = 0; i < steps * steps; ++i) {
    const double u = (i % steps + 0.5) * 2 / steps - 1;
    const double v = (i / steps + 0.5) * 2 / steps - 1;
    if (std::hypot(dx + u, dy + v) > disk.radius) continue;
    sum += (1 - std::abs(u)) * (1 - std::abs(v));
  }
  return sum * 4 / (steps * steps);
}

// Of a picture's coverages by name from what they should be.
template <class Expected>
void expect_coverages(const MatteReader& matte, const std::string& name, const Expected& expected,
                      double largest, double mean_square) {
  double squares = 0;
  int partial = 0;
  for (int y = 0; y < matte.picture().height; ++y) {
    for (int x = 0; x < matte.picture().width; ++x) {
      const double truth = expected(x, y);
      const double error = matte.coverage(name, x, y) - truth;
      EXPECT_NEAR(error, 0, largest) << x << " " << y;
      if (truth == 0 || truth == 1) continue;
      squares += error * error;
      ++partial;
    }
  }
  ASSERT_GT(partial, 0);
  EXPECT_LT(std::sqrt(squares / partial), mean_square);
}

TEST(Mattes, EdgesAreFilteredAsTheBeautyIs) {
  const Film film{40, 36, 1000};
  const Vec3 center{0.23, 0.17, -100};
  for (const IntegratorKind integrator : both) {
    const Scene scene = scene_of(seen(film, 256) + ball("moon", center, 1), integrator);
    const MatteReader matte = mattes(scene, "crypto_object");
    const Disk disk = disk_of(film, center, 1);
    expect_coverages(
        matte, "moon", [&](int x, int y) { return tent_coverage(disk, x, y); }, 0.03, 0.01);
    EXPECT_NEAR(matte.area("moon") / (std::numbers::pi * disk.radius * disk.radius), 1, 5e-3);
    EXPECT_THAT(matte.manifest(), ElementsAre(testing::Key("moon")));
  }
}

// At a thousandth of c: the disk moves 16 pixels while the shutter is open.
TEST(Mattes, MotionBlurSpreadsThem) {
  const Film film{48, 32, 1000};
  const Vec3 start{-0.7, 0.11, -100}, velocity{1e-3, 0, 0};
  const double shutter = 1600;
  const std::string text = seen(film, 256) + fmt::format("[exposure]\nshutter = {}\n", shutter) +
                           ball("moon", start, 0.8, "velocity = " + toml(velocity));
  constexpr int times = 200;
  std::vector<Disk> disks;
  for (int i = 0; i < times; ++i) {
    const Vec3 center = seen_at(start, velocity, shutter * (i + 0.5) / times);
    disks.push_back(disk_of(film, center, 0.8));
  }
  const auto expected = [&](int x, int y) {
    double sum = 0;
    for (const Disk& disk : disks) sum += tent_coverage(disk, x, y);
    return sum / times;
  };
  for (const IntegratorKind integrator : both) {
    expect_coverages(mattes(scene_of(text, integrator), "crypto_asset"), "moon", expected, 0.05,
                     0.015);
  }
}

// A pane before a wall, larger than the picture.
const std::string pane_and_wall =
    "[[object]]\nname = 'pane'\nasset = 'quad.obj'\nposition = [0, 0, -5]\nmaterial = 'film'\n"
    "[[object]]\nname = 'wall'\nasset = 'quad.obj'\nposition = [0, 0, -9]\nmaterial = 'paint'\n"
    "[[material]]\nname = 'film'\nopacity = 0.25\n[[material]]\nname = 'paint'\n";
const std::vector<AssetFile> quad = {
    {"quad.obj", quad_obj({0, 0, 0}, {9, 0, 0}, {0, 9, 0}) + "vn 0 0 1\n"}};

TEST(Mattes, ThePreviewSplitsTransparencyExactly) {
  const Scene scene = scene_of(seen({8, 8, 8}, 4) + pane_and_wall, IntegratorKind::preview, quad);
  const MatteReader objects = mattes(scene, "crypto_object");
  const MatteReader materials = mattes(scene, "crypto_material");
  for (int i = 0; i < 64; ++i) {
    EXPECT_NEAR(objects.coverage("pane", i % 8, i / 8), 0.25, 1e-6);
    EXPECT_NEAR(objects.coverage("wall", i % 8, i / 8), 0.75, 1e-6);
    ASSERT_EQ(objects.ranks(i % 8, i / 8).size(), 2U);
    EXPECT_EQ(objects.ranks(i % 8, i / 8)[0].id, objects.manifest().at("wall"));
    EXPECT_NEAR(materials.coverage("film", i % 8, i / 8), 0.25, 1e-6);
  }
}

// Each path meets one of the two: a binomial of 16 * 24 * 24 throws.
TEST(Mattes, PathsMeetTransparencyByChance) {
  const Film film{24, 24, 24};
  const Scene scene = scene_of(seen(film, 16) + pane_and_wall, IntegratorKind::path, quad);
  const MatteReader objects = mattes(scene, "crypto_object");
  const double throws = 16.0 * 24 * 24;
  EXPECT_NEAR(objects.area("pane") / (24 * 24), 0.25, 5 * std::sqrt(0.25 * 0.75 / throws));
  for (int i = 0; i < 24 * 24; ++i) EXPECT_NEAR(objects.sum(i % 24, i / 24), 1, 1e-6);
}

// Lens, motion, transparency, a hole to the background: a few things in a pixel.
const std::string busy =
    "[camera]\nposition = [0, 0, 6]\ndirection = [0, 0, -1]\naperture = 0.2\nfocus = 6\n"
    "[exposure]\nshutter = 3\n"
    "[[material]]\nname = 'film'\nopacity = 0.4\n" +
    ball("near", {0.4, 0, 2}, 0.5, "material = 'film'") + ball("middle", {-0.3, 0, 0}, 0.8) +
    ball("far", {0.5, 0.4, -2}, 1, "velocity = [0.2, 0, 0]");

std::string busy_settings(const std::string& layers, int samples) {
  return Film{24, 20, 20}.text(samples, false, layers);
}

void expect_sums_of_alpha(const Scene& scene) {
  const Picture picture = first_picture(scene);
  const ExrPicture file = written(scene, picture);
  double covered = 0;
  for (const char* layer : {"crypto_object", "crypto_material", "crypto_asset"}) {
    const MatteReader matte(file, layer);
    for (int i = 0; i < 24 * 20; ++i) {
      const double alpha = static_cast<double>(picture.rgba()[static_cast<std::size_t>(i)].w);
      EXPECT_NEAR(matte.sum(i % 24, i / 24), alpha, 1e-5) << layer << " " << i;
      if (alpha > 0 && alpha < 1) ++covered;
    }
  }
  EXPECT_GT(covered, 100);
}

TEST(Mattes, AddUpToAlpha) {
  for (const IntegratorKind integrator : both) {
    expect_sums_of_alpha(scene_of(busy_settings(all_mattes, 24) + busy, integrator));
  }
}

TEST(Mattes, AddUpToAlphaWhereSamplesStopEarly) {
  for (const IntegratorKind integrator : both) {
    Scene scene = scene_of(busy_settings(all_mattes, 96) + busy, integrator);
    scene.render.noise = 0.1;
    expect_sums_of_alpha(scene);
  }
}

TEST(Mattes, LeaveTheBeautyAlone) {
  for (const IntegratorKind integrator : both) {
    for (const double noise : {0.0, 0.1}) {
      Scene with = scene_of(busy_settings(all_mattes, 16) + busy, integrator);
      with.render.noise = noise;
      Scene without = with;
      without.output.layers = {Layer::beauty};
      EXPECT_EQ(first_picture(with).rgba(), first_picture(without).rgba());
    }
  }
}

// The centre's ray tells Z alone; a matte's edges take all samples.
TEST(Mattes, NeedNoBeauty) {
  const std::string layers = R"(["crypto_object", "Z"])";
  const Scene with = scene_of(busy_settings(all_mattes, 16) + busy);
  const Scene alone = scene_of(busy_settings(layers, 16) + busy);
  const Picture first = first_picture(with), second = first_picture(alone);
  for (const std::string& channel : matte_channels("crypto_object")) {
    EXPECT_EQ(channel_of(first, channel), channel_of(second, channel)) << channel;
  }
  Scene beside = with;
  beside.output.layers = {Layer::z};
  EXPECT_EQ(channel_of(second, "Z"), channel_of(first_picture(beside), "Z"));
}

TEST(Mattes, AreThoseOfTheWholeInAPart) {
  const Scene scene = scene_of(busy_settings(all_mattes, 8) + busy);
  const FrameSet frames(scene, 1);
  const Integrator integrator = make_integrator(scene, frames);
  EvaluatorPool evaluators(scene.functions);
  Picture part({5, 3, 11, 9}, scene.output.layers, {scene.light_speed});
  render_picture({scene, integrator, evaluators, {}}, 0, part);
  const Picture whole = first_picture(scene);
  for (const std::string& channel : matte_channels("crypto_object")) {
    const auto of_part = channel_of(part, channel), of_whole = channel_of(whole, channel);
    for (std::size_t i = 0; i < of_part.size(); ++i) {
      EXPECT_EQ(of_part[i], of_whole[(i / 11 + 3) * 24 + i % 11 + 5]) << channel;
    }
  }
}

// Gone in the second exposure: half of each pixel's samples, but all of the alpha where light adds up.
TEST(Mattes, FitTheAlphaOfExposures) {
  const Film film{32, 32, 1000};
  for (const char* combine : {"sum", "mean", "max"}) {
    const std::string text =
        seen(film, 4) +
        fmt::format("[exposure]\ncount = 2\ninterval = 1000\ncombine = '{}'\n", combine) +
        ball("moon", {0, 0, -100}, 1, "velocity = [0.01, 0, 0]\ntime = -100");
    const MatteReader matte = mattes(scene_of(text), "crypto_object");
    const bool mean = std::string(combine) == "mean";
    EXPECT_EQ(matte.coverage("moon", 16, 16), mean ? 0.5 : 1.0) << combine;
  }
}

// Nine balls in one pixel: the six largest of their disks.
TEST(Mattes, RanksHoldTheLargestSix) {
  const Film film{1, 1, 100};  // 10 lengths a pixel at a distance of 1000
  const double radii[9] = {0.7, 1.2, 0.5, 1.3, 1.5, 1.1, 0.3, 1.0, 0.9};
  std::string text = seen(film, 4096);
  std::vector<std::pair<double, std::string>> expected;
  for (int i = 0; i < 9; ++i) {
    const double x = 3 * (i % 3 - 1), y = 3 * (i / 3 - 1);
    const std::string name = fmt::format("ball {}", i);
    text += ball(name, {x, y, -1000}, radii[i]);
    const Disk disk = disk_of(film, {x, y, -1000}, radii[i]);
    expected.emplace_back(tent_coverage(disk, 0, 0, 400), name);
  }
  std::sort(expected.rbegin(), expected.rend());
  const Scene scene = scene_of(text);
  const Picture picture = first_picture(scene);
  const MatteReader matte(written(scene, picture), "crypto_object");
  const auto ranks = matte.ranks(0, 0);
  ASSERT_EQ(ranks.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(ranks[i].id, matte.manifest().at(expected[i].second)) << i;
    EXPECT_NEAR(static_cast<double>(ranks[i].coverage), expected[i].first, 3e-3) << i;
  }
  EXPECT_LT(matte.sum(0, 0), static_cast<double>(picture.rgba()[0].w) - 5e-3);
  EXPECT_EQ(matte.manifest().size(), 9U);
}

}  // namespace
}  // namespace restframe
