// Film samples, the table of layers, and pictures through EXR files and back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "film/exr_file.h"
#include "film/sample_sum.h"
#include "scene/error.h"
#include "support/exr_reader.h"
#include "support/temporary_folder.h"
#include "tracer/film_samples.h"

namespace restframe {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(FilmOffsets, BeginAtThePixelsCentre) {
  for (const int samples : {1, 2, 16, 1000}) {
    const std::vector<Vec2f> offsets = film_offsets(samples);
    ASSERT_EQ(offsets.size(), static_cast<std::size_t>(samples));
    EXPECT_EQ(offsets[0], Vec2f(0));
  }
}

TEST(FilmOffsets, AreDistributedAsATentOfRadiusOne) {
  constexpr int count = 4096;
  const std::vector<Vec2f> offsets = film_offsets(count);
  Vec2f sum(0), squares(0);
  float mixed = 0;
  int inner = 0;
  for (const Vec2f& o : offsets) {
    EXPECT_LT(std::max(std::abs(o.x), std::abs(o.y)), 1.0F);
    sum += o;
    squares += o * o;
    mixed += o.x * o.y;
    if (std::abs(o.x) < 0.5F) ++inner;
  }
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(sum[axis] / count, 0, 2e-3);
    EXPECT_NEAR(squares[axis] / count, 1.0 / 6, 2e-3);
  }
  EXPECT_NEAR(mixed / count, 0, 2e-3);
  // The integral of 1 - |x| from -1/2 to 1/2.
  EXPECT_NEAR(double(inner) / count, 0.75, 2e-3);
}

TEST(FilmOffsets, NoTwoAreTheSame) {
  std::set<std::pair<float, float>> seen;
  for (const Vec2f& o : film_offsets(10'000)) seen.emplace(o.x, o.y);
  EXPECT_EQ(seen.size(), 10'000U);
}

const std::vector<Layer> all_layers = {Layer::beauty,
                                       Layer::z,
                                       Layer::time,
                                       Layer::doppler,
                                       Layer::normal,
                                       Layer::position,
                                       Layer::uv,
                                       Layer::id,
                                       Layer::variance,
                                       Layer::samples,
                                       Layer::crypto_object,
                                       Layer::crypto_material,
                                       Layer::crypto_asset,
                                       Layer::motion,
                                       Layer::emission,
                                       Layer::direct,
                                       Layer::indirect,
                                       Layer::reflection,
                                       Layer::transmission,
                                       Layer::lights,
                                       Layer::albedo,
                                       Layer::depth,
                                       Layer::apparent_normal};

// Added one by one, so many floats would be off by 6e-4.
TEST(SampleSum, KeepsDigitsOfManySamples) {
  constexpr int samples = 65'536;
  SampleSum subtotals;
  RadianceLanes sum;
  sum.fill(Vec4f(0));
  for (int i = 0; i < samples; ++i) {
    for (Vec4f& lane : sum.lane) lane += Vec4f(0.1F, 0.7F, 1e-3F, 1);
    subtotals.take_subtotal(i, sum);
  }
  subtotals.complete(sum);
  const double expected[4] = {0.1, 0.7, 1e-3, 1};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(static_cast<double>(sum[5][i]) / samples / expected[i], 1, 1e-6) << i;
  }
}

TEST(Layers, TheTableHasEachOnce) {
  std::set<Layer> layers;
  std::set<std::string> names, channels;
  std::size_t channel_count = 0;
  for (const LayerInfo& info : layer_table()) {
    layers.insert(info.layer);
    names.insert(info.scene_name);
    for (const DataChannel& channel : info.channels) channels.insert(channel.exr_name);
    for (const StatisticChannel& channel : info.statistics) channels.insert(channel.exr_name);
    channel_count += info.channels.size() + info.statistics.size();
  }
  EXPECT_EQ(layers, std::set<Layer>(all_layers.begin(), all_layers.end()));
  EXPECT_EQ(layer_table().size(), all_layers.size());
  EXPECT_EQ(names, (std::set<std::string>{"beauty",
                                          "Z",
                                          "time",
                                          "doppler",
                                          "N",
                                          "P",
                                          "UV",
                                          "id",
                                          "variance",
                                          "samples",
                                          "crypto_object",
                                          "crypto_material",
                                          "crypto_asset",
                                          "motion",
                                          "emission",
                                          "direct",
                                          "indirect",
                                          "reflection",
                                          "transmission",
                                          "lights",
                                          "albedo",
                                          "depth",
                                          "normal"}));
  EXPECT_EQ(channels, (std::set<std::string>{"Z",
                                             "time_proper.V",
                                             "time_world.V",
                                             "doppler.D",
                                             "N.X",
                                             "N.Y",
                                             "N.Z",
                                             "P.X",
                                             "P.Y",
                                             "P.Z",
                                             "UV.U",
                                             "UV.V",
                                             "UV.A",
                                             "id_object.V",
                                             "id_material.V",
                                             "variance.R",
                                             "variance.G",
                                             "variance.B",
                                             "samples.V",
                                             "motion.U",
                                             "motion.V",
                                             "motion.A",
                                             "depth_planar.Z",
                                             "normal.X",
                                             "normal.Y",
                                             "normal.Z"}));
  EXPECT_EQ(channels.size(), channel_count);
}

TEST(Layers, PartsAreNamedByTheTableAndByGroups) {
  const std::vector<std::string> groups = {"key", "fill"};
  std::map<std::string, int> columns;
  for (const PartLayer& part : part_layers(all_layers, groups))
    columns[part.exr_name] = part.column;
  const std::map<std::string, int> expected = {
      {"emission", 0}, {"direct", 1},     {"indirect", 2},  {"reflection", 3}, {"transmission", 4},
      {"albedo", 5},   {"light_rest", 6}, {"light_key", 7}, {"light_fill", 8}};
  EXPECT_EQ(columns, expected);
  const std::vector<Layer> one = {Layer::z, Layer::albedo};
  Picture picture({0, 0, 2, 1}, one, {}, groups);
  EXPECT_THAT(picture.part_columns(), testing::ElementsAre(5));
  const Vec3f color(1.5F, inf, nan);
  picture.set_parts(1, 0, {&color, 1});
  EXPECT_EQ(picture.planes()[1].name, "albedo.R");
  EXPECT_EQ(picture.planes()[1].values[1], 1.5F);
  EXPECT_EQ(picture.planes()[2].values[1], std::numeric_limits<float>::max());
  EXPECT_EQ(picture.planes()[3].values[1], 0.0F);
}

TEST(Layers, OnlyThoseAskedForHaveChannels) {
  const std::vector<Layer> two = {Layer::id, Layer::z};
  const std::vector<DataChannel> channels = data_channels(two);
  ASSERT_EQ(channels.size(), 3U);
  EXPECT_STREQ(channels[0].exr_name, "Z");
  EXPECT_STREQ(channels[1].exr_name, "id_object.V");
  const Picture picture({0, 0, 4, 3}, two, {});
  EXPECT_FALSE(picture.has_beauty());
  EXPECT_TRUE(picture.has_data());
  const std::vector<Layer> beauty = {Layer::beauty};
  EXPECT_FALSE(Picture({0, 0, 4, 3}, beauty, {}).has_data());
}

SurfaceData surface() {
  SurfaceData data;
  data.hit = true;
  data.object = 2;
  data.material = 4;
  data.distance = 3.5;
  data.time_proper = -1.25;
  data.time_world = 7.75;
  data.doppler = 1.5;
  data.position = {0.5, -0.25, 2};
  data.normal = {0, 0.6, -0.8};
  data.uv = {0.125, 0.875};
  data.depth = 3.25;
  data.apparent_normal = {0.8, 0, 0.6};
  data.motion = {1.5, -2.5};
  return data;
}

struct Written {
  WriteReport report;
  ExrPicture exr;
};

Written written(const Picture& picture, const PictureInfo& info = {}) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "picture.exr";
  const WriteReport report = write_exr(path, picture, info);
  return {report, read_exr(path)};
}

TEST(Exr, HoldsWhatWasSet) {
  Picture picture({0, 0, 3, 2}, all_layers, {2.0});  // lengths are twice as long in scene units
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) picture.set_data(x, y, {});
  }
  picture.set_radiance(2, 1, {0.5F, 0.25F, 2.0F, 1.0F});
  picture.set_data(2, 1, surface());
  picture.set_statistics(2, 1, {{0.25F, 0.5F, inf}, 48});
  picture.set_matte(2, 1, MatteKind::material, {{{0.5F, 0.75F}, {8.0F, 0.125F}}});
  std::vector<Vec3f> parts;
  for (const int column : picture.part_columns()) {
    parts.push_back(static_cast<float>(column) + Vec3f(1, 0.5F, 0.25F));
  }
  picture.set_parts(2, 1, parts);
  const ExrPicture exr = written(picture).exr;
  EXPECT_EQ(exr.width, 3);
  EXPECT_EQ(exr.height, 2);
  std::map<std::string, float> expected = {{"R", 0.5F},
                                           {"G", 0.25F},
                                           {"B", 2.0F},
                                           {"A", 1.0F},
                                           {"Z", 7.0F},
                                           {"time_proper.V", -1.25F},
                                           {"time_world.V", 7.75F},
                                           {"doppler.D", 1.5F},
                                           {"P.X", 1.0F},
                                           {"P.Y", -0.5F},
                                           {"P.Z", 4.0F},
                                           {"N.X", 0.0F},
                                           {"N.Y", 0.6F},
                                           {"N.Z", -0.8F},
                                           {"UV.U", 0.125F},
                                           {"UV.V", 0.875F},
                                           {"UV.A", 1.0F},
                                           {"id_object.V", 3.0F},
                                           {"id_material.V", 5.0F},
                                           {"variance.R", 0.25F},
                                           {"variance.G", 0.5F},
                                           {"variance.B", std::numeric_limits<float>::max()},
                                           {"motion.U", 1.5F},
                                           {"motion.V", -2.5F},
                                           {"motion.A", 1.0F},
                                           {"samples.V", 48.0F},
                                           {"depth_planar.Z", 6.5F},
                                           {"normal.X", 0.8F},
                                           {"normal.Y", 0.0F},
                                           {"normal.Z", 0.6F}};
  for (const PartLayer& part : part_layers(all_layers, {})) {
    const auto column = static_cast<float>(part.column);
    expected[part.exr_name + ".R"] = column + 1;
    expected[part.exr_name + ".G"] = column + 0.5F;
    expected[part.exr_name + ".B"] = column + 0.25F;
  }
  for (const char* layer : {"crypto_object", "crypto_material", "crypto_asset"}) {
    for (const std::string& channel : matte_channels(layer)) expected[channel] = 0;
  }
  expected["crypto_material00.R"] = 0.5F;
  expected["crypto_material00.G"] = 0.75F;
  expected["crypto_material00.B"] = 8.0F;
  expected["crypto_material00.A"] = 0.125F;
  EXPECT_EQ(exr.channels.size(), expected.size());
  for (const auto& [name, value] : expected) {
    EXPECT_EQ(exr.at(name, 2, 1), value) << name;
    EXPECT_EQ(exr.at(name, 0, 1), (name == "Z" || name == "depth_planar.Z") ? inf : 0.0F) << name;
  }
}

Picture one_row(const std::vector<Vec4f>& pixels) {
  Picture picture({0, 0, static_cast<int>(pixels.size()), 1}, std::vector<Layer>{Layer::beauty},
                  {});
  for (int x = 0; x < picture.width(); ++x) {
    picture.set_radiance(x, 0, pixels[static_cast<std::size_t>(x)]);
  }
  return picture;
}

TEST(Exr, ABeautyOfHalvesClampsAndCounts) {
  const Written out = written(one_row({{65504, 65505, 1e30F, inf}, {-inf, -1e5F, nan, 0.1F}}));
  EXPECT_EQ(out.report.clamped, 6U);
  EXPECT_EQ(out.exr.at("R", 0, 0), 65504.0F);
  EXPECT_EQ(out.exr.at("G", 0, 0), 65504.0F);
  EXPECT_EQ(out.exr.at("B", 0, 0), 65504.0F);
  EXPECT_EQ(out.exr.at("A", 0, 0), 65504.0F);
  EXPECT_EQ(out.exr.at("R", 1, 0), -65504.0F);
  EXPECT_EQ(out.exr.at("G", 1, 0), -65504.0F);
  EXPECT_EQ(out.exr.at("B", 1, 0), 0.0F);
  EXPECT_NEAR(out.exr.at("A", 1, 0), 0.1F, 1e-4);
}

TEST(Exr, ABeautyOfFloatsKeepsWhatHalvesCannot) {
  PictureInfo info;
  info.float_beauty = true;
  const Written out = written(one_row({{39600.25F, 1e30F, inf, nan}}), info);
  EXPECT_EQ(out.report.clamped, 2U);
  EXPECT_EQ(out.exr.at("R", 0, 0), 39600.25F);
  EXPECT_EQ(out.exr.at("G", 0, 0), 1e30F);
  EXPECT_EQ(out.exr.at("B", 0, 0), std::numeric_limits<float>::max());
  EXPECT_EQ(out.exr.at("A", 0, 0), 0.0F);
}

// Two hits whose clocks are these; the third pixel hits nothing.
ExrPicture with_clocks(double a, double b) {
  Picture picture({0, 0, 3, 1}, std::vector<Layer>{Layer::time}, {});
  SurfaceData data = surface();
  data.time_proper = a;
  picture.set_data(0, 0, data);
  data.time_proper = b;
  picture.set_data(1, 0, data);
  picture.set_data(2, 0, {});
  return written(picture).exr;
}

TEST(Exr, LargeTimesHaveAnOrigin) {
  const ExrPicture exr = with_clocks(1e9 + 0.125, 1e9 + 10.25);
  std::istringstream origins(exr.attributes.at("timeOrigin"));
  double proper = 0;
  double world = 0;
  ASSERT_TRUE(origins >> proper >> world);
  EXPECT_EQ(proper + static_cast<double>(exr.at("time_proper.V", 0, 0)), 1e9 + 0.125);
  EXPECT_EQ(proper + static_cast<double>(exr.at("time_proper.V", 1, 0)), 1e9 + 10.25);
  EXPECT_EQ(exr.at("time_proper.V", 2, 0), 0.0F);
  EXPECT_EQ(world, 0.0);  // those are small
  EXPECT_EQ(exr.at("time_world.V", 0, 0), 7.75F);
}

TEST(Exr, SmallTimesHaveNone) {
  const ExrPicture exr = with_clocks(-3.5, 100.25);
  EXPECT_EQ(exr.attributes.at("timeOrigin"), "0 0");
  EXPECT_EQ(exr.at("time_proper.V", 0, 0), -3.5F);
  EXPECT_EQ(exr.at("time_proper.V", 1, 0), 100.25F);
}

TEST(Exr, TheHeaderSaysWhatMadeIt) {
  PictureInfo info;
  info.number = 7;
  info.camera_time = 0.75;
  info.pose.world_from_camera =
      Boost<in::Camera, in::World>(Velocity::from_beta({0, 0, -0.5})).inverse();
  info.object_names = {"one", "Zwei Bälle"};
  info.material_names = {"paint"};
  info.texts = {{"samples", "16"}, {"longer", "two\nlines"}};
  const auto attributes = written(one_row({Vec4f(0)}), info).exr.attributes;
  EXPECT_EQ(attributes.at("pictureNumber"), "7");
  EXPECT_EQ(attributes.at("cameraTime"), "0.75");
  std::istringstream velocity(attributes.at("cameraVelocity"));
  double x = 1, y = 1, z = 1;
  velocity >> x >> y >> z;
  EXPECT_NEAR(glm::length(Vec3(x, y, z) - Vec3(0, 0, -0.5)), 0, 1e-15);
  EXPECT_EQ(attributes.at("depthType"), "distance");
  EXPECT_EQ(attributes.at("objectNames"), "one\nZwei Bälle");
  EXPECT_EQ(attributes.at("materialNames"), "paint");
  EXPECT_EQ(attributes.at("samples"), "16");
  EXPECT_EQ(attributes.at("longer"), "two\nlines");
  for (const char* name : {"framesPerSecond", "worldToCamera", "worldToNDC", "chromaticities"}) {
    EXPECT_TRUE(attributes.contains(name)) << name;
  }
}

TEST(Exr, AFolderThatIsNotThereIsAnOutputError) {
  const TemporaryFolder folder;
  folder.write("file", "x");
  EXPECT_THROW(write_exr(folder.path() / "file" / "picture.exr", one_row({Vec4f(0)}), {}),
               OutputError);
}

}  // namespace
}  // namespace restframe
