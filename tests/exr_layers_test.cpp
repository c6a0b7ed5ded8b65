// How layers go into files: their types, what compressions leave of them, views, windows, and what
// the headers say by OpenEXR's names.

#include <ImfMultiView.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "film/exr_file.h"
#include "support/exr_reader.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using testing::UnorderedElementsAre;

constexpr float inf = std::numeric_limits<float>::infinity();
const std::vector<Layer> layers = {Layer::beauty, Layer::z,  Layer::time, Layer::normal,
                                   Layer::id,     Layer::uv, Layer::depth};

// Numbers without a pattern: each compression that loses something would show it.
double jagged(int x, int y, int salt) {
  const double v = std::sin(12.9898 * x + 78.233 * y + 3.7 * salt) * 43758.5453;
  return v - std::floor(v);
}

Picture noise(int salt = 0, const PixelWindow& window = {0, 0, 70, 50},
              const std::vector<Layer>& of = layers) {
  Picture picture(window, of, {});
  for (int y = window.top; y < window.bottom(); ++y) {
    for (int x = window.left; x < window.right(); ++x) {
      const auto value = [&](int of_kind) { return jagged(x, y, 10 * salt + of_kind); };
      SurfaceData data;
      data.hit = value(0) > 0.1;
      data.object = static_cast<int>(1000 * value(1));
      data.distance = 1e3 * value(2);
      data.depth = 1e3 * value(3);
      data.time_proper = 500 * value(4);
      data.time_world = -500 * value(5);
      data.normal = {value(6), value(7), value(8)};
      data.uv = {static_cast<float>(value(9)), 0.1F};
      picture.set_data(x, y, data);
      picture.set_radiance(x, y, {0.2F + 0.1F * static_cast<float>(value(10)), 0.5F, 0.7F, 1.0F});
    }
  }
  return picture;
}

struct Written {
  WriteReport report;
  std::vector<ExrPicture> parts;
};

Written written(std::span<const Picture> views, const PictureInfo& info) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "picture.exr";
  const WriteReport report = write_exr(path, views, info);
  return {report, read_exr_parts(path)};
}

ExrPicture in_one_part(const Picture& picture, const PictureInfo& info = {}) {
  Written file = written({&picture, 1}, info);
  EXPECT_EQ(file.parts.size(), 1U);
  return file.parts.at(0);
}

std::set<std::string> channels_of(const ExrPicture& exr) {
  std::set<std::string> names;
  for (const auto& [name, values] : exr.channels) names.insert(name);
  return names;
}

bool is_data(const std::string& channel) {
  return channel != "R" && channel != "G" && channel != "B" && channel != "A";
}

TEST(ExrCompression, NeverTouchesData) {
  const std::array names = {"none",  "rle",  "zips", "zip", "piz",
                            "pxr24", "dwaa", "dwab", "b44", "b44a"};
  const Picture picture = noise();
  const ExrPicture exact = in_one_part(picture);
  for (std::size_t i = 0; i < names.size(); ++i) {
    SCOPED_TRACE(names[i]);
    PictureInfo info;
    info.compression = static_cast<Compression>(i);
    const Written file = written({&picture, 1}, info);
    const bool lossy = i >= 5;
    ASSERT_EQ(file.parts.size(), lossy ? 2U : 1U);
    EXPECT_EQ(file.parts[0].attributes.at("compression"), names[i]);
    std::size_t found = 0;
    for (const ExrPicture& part : file.parts) {
      for (const auto& [name, values] : part.channels) {
        ++found;
        if (is_data(name) || !lossy) {
          EXPECT_TRUE(values == exact.channel(name)) << name;
        } else {
          EXPECT_NEAR(part.at(name, 60, 40), exact.at(name, 60, 40), 0.02) << name;
        }
      }
    }
    EXPECT_EQ(found, exact.channels.size());
    if (!lossy) continue;
    EXPECT_EQ(file.parts[0].attributes.at("name"), "light");
    EXPECT_THAT(channels_of(file.parts[0]), UnorderedElementsAre("R", "G", "B", "A"));
    EXPECT_EQ(file.parts[1].attributes.at("name"), "data");
    EXPECT_EQ(file.parts[1].attributes.at("compression"), "zip");
  }
}

TEST(ExrCompression, OfOneKindOfLayersNeedsNoParts) {
  PictureInfo info;
  info.compression = Compression::dwaa;
  const std::vector<Layer> beauty = {Layer::beauty}, data = {Layer::z, Layer::id};
  EXPECT_EQ(in_one_part(noise(0, {0, 0, 8, 8}, beauty), info).attributes.at("compression"), "dwaa");
  EXPECT_EQ(in_one_part(noise(0, {0, 0, 8, 8}, data), info).attributes.at("compression"), "zip");
}

TEST(ExrCompression, LevelOfDwaSaysHowMuchIsLost) {
  const Picture picture = noise();
  const ExrPicture exact = in_one_part(picture);
  double before = 0;
  for (const double level : {0.0, 45.0, 450.0}) {
    PictureInfo info;
    info.compression = Compression::dwab;
    info.compression_level = level;
    const ExrPicture lossy = written({&picture, 1}, info).parts[0];
    EXPECT_EQ(std::stod(lossy.attributes.at("dwaCompressionLevel")), level);
    double sum = 0;
    for (std::size_t i = 0; i < exact.channel("R").size(); ++i) {
      sum += std::abs(static_cast<double>(lossy.channel("R")[i] - exact.channel("R")[i]));
    }
    EXPECT_GE(sum, before) << level;
    before = sum;
  }
  EXPECT_GT(before, 0);
  EXPECT_FALSE(exact.attributes.contains("dwaCompressionLevel"));
}

TEST(ExrTypes, AreHalfOrFloatByLayer) {
  const Picture picture = noise();
  PictureInfo info;
  info.half_layers = {"N", "depth"};
  const ExrPicture exr = in_one_part(picture, info);
  for (const auto& [name, type] : exr.types) {
    const bool half = !is_data(name) || name.starts_with("N.") || name.starts_with("depth_planar.");
    EXPECT_EQ(type, half ? "half" : "float") << name;
  }
  info.float_beauty = true;
  EXPECT_EQ(in_one_part(picture, info).types.at("R"), "float");
  const ExrPicture exact = in_one_part(picture);
  EXPECT_NEAR(exr.at("N.Y", 30, 20), exact.at("N.Y", 30, 20), 1e-3);
}

TEST(ExrTypes, HalfDataThatOverflowsIsClampedAndCounted) {
  Picture picture({0, 0, 3, 1}, std::vector<Layer>{Layer::z}, {});
  SurfaceData data;
  data.hit = true;
  data.distance = 65504;
  picture.set_data(0, 0, data);
  data.distance = 70000;
  picture.set_data(1, 0, data);
  picture.set_data(2, 0, {});
  PictureInfo info;
  info.half_layers = {"Z"};
  const Written file = written({&picture, 1}, info);
  EXPECT_EQ(file.report.clamped_data, 1U);
  EXPECT_EQ(file.report.clamped, 0U);
  EXPECT_EQ(file.parts[0].channel("Z"), (std::vector<float>{65504, 65504, inf}));
}

TEST(ExrFiles, OfOneLayerHoldNoOther) {
  PictureInfo info;
  info.only_layer = "time";
  EXPECT_THAT(channels_of(in_one_part(noise(), info)),
              UnorderedElementsAre("time_proper.V", "time_world.V"));
  info.only_layer = "beauty";
  EXPECT_THAT(channels_of(in_one_part(noise(), info)), UnorderedElementsAre("R", "G", "B", "A"));
}

TEST(ExrFiles, LayersOfChannels) {
  for (const auto& [channel, layer] :
       std::map<std::string, std::string>{{"R", "beauty"},
                                          {"A", "beauty"},
                                          {"Z", "Z"},
                                          {"depth_planar.Z", "depth"},
                                          {"time_world.V", "time"},
                                          {"id_material.V", "id"},
                                          {"N.X", "N"},
                                          {"normal.X", "normal"},
                                          {"crypto_object02.R", "crypto_object"},
                                          {"light_key2.R", "lights"},
                                          {"albedo.G", "albedo"}}) {
    EXPECT_EQ(layer_of_channel(channel), layer) << channel;
  }
}

TEST(ExrFiles, HaveWindowsForCropsAndOverscan) {
  const PixelWindow window{-3, 7, 20, 9};
  PictureInfo info;
  info.display = {0, 0, 64, 48};
  info.uncropped = {-4, -4, 72, 56};
  const Picture picture = noise(0, window);
  const ExrPicture exr = in_one_part(picture, info);
  EXPECT_EQ(exr.attributes.at("dataWindow"), "-3 7 16 15");
  EXPECT_EQ(exr.attributes.at("displayWindow"), "0 0 63 47");
  EXPECT_EQ(exr.attributes.at("originalDataWindow"), "-4 -4 67 51");
  EXPECT_EQ(exr.width, 20);
  EXPECT_EQ(exr.height, 9);
}

PictureInfo stereo() {
  PictureInfo info;
  info.views = {{"left", {}}, {"right", {}}};
  info.views[0].pose.event.x = {-1, 0, 0};
  info.views[1].pose.event.x = {1, 0, 0};
  return info;
}

// By the matrix of this name.
double moved_right_by(const ExrPicture& exr, const std::string& matrix) {
  std::istringstream text(exr.attributes.at(matrix));
  std::array<double, 16> m{};
  for (double& value : m) text >> value;
  return m[12];
}

// OpenEXR's own functions tell which channel is whose.
TEST(ExrViews, AreTwoInOneFile) {
  const std::vector<Picture> views = {noise(1), noise(2)};
  const Written file = written(views, stereo());
  ASSERT_EQ(file.parts.size(), 1U);
  const ExrPicture& exr = file.parts[0];
  EXPECT_EQ(exr.attributes.at("multiView"), "left\nright");
  const Imf::StringVector names = {"left", "right"};
  for (std::size_t view = 0; view < 2; ++view) {
    const ExrPicture alone = in_one_part(views[view]);
    std::size_t found = 0;
    for (const auto& [name, values] : alone.channels) {
      const std::string in_file = Imf::insertViewName(name, names, static_cast<int>(view));
      EXPECT_EQ(Imf::viewFromChannelName(in_file, names), names[view]) << in_file;
      EXPECT_TRUE(exr.channel(in_file) == values) << in_file;
      ++found;
    }
    EXPECT_EQ(2 * found, exr.channels.size());
  }
  EXPECT_TRUE(exr.channels.contains("R"));
  EXPECT_TRUE(exr.channels.contains("right.R"));
  EXPECT_TRUE(exr.channels.contains("N.left.X"));
  EXPECT_TRUE(exr.channels.contains("N.right.X"));
  EXPECT_EQ(moved_right_by(exr, "worldToCamera"), 1);
  EXPECT_EQ(moved_right_by(exr, "right.worldToCamera"), -1);
}

TEST(ExrViews, HavePartsWhereLightIsCompressedWithLoss) {
  const std::vector<Picture> views = {noise(1), noise(2)};
  PictureInfo info = stereo();
  info.compression = Compression::dwaa;
  const Written file = written(views, info);
  ASSERT_EQ(file.parts.size(), 4U);
  const std::array names = {"left.light", "right.light", "left.data", "right.data"};
  const std::array of = {"left", "right", "left", "right"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(file.parts[i].attributes.at("name"), names[i]);
    EXPECT_EQ(file.parts[i].attributes.at("view"), of[i]);
    EXPECT_EQ(file.parts[i].attributes.at("type"), "scanlineimage");
  }
  EXPECT_TRUE(file.parts[3].channel("N.X") == in_one_part(views[1]).channel("N.X"));
  EXPECT_EQ(moved_right_by(file.parts[1], "worldToCamera"), -1);
}

TEST(ExrHeaders, SayTheStandardsNames) {
  PictureInfo info;
  info.number = 24 * 3661 + 5;
  info.rate = 24;
  info.shutter = 0.5;
  info.focus = 10.0;
  const auto attributes = in_one_part(noise(), info).attributes;
  EXPECT_EQ(attributes.at("timeCode"), "01:01:01:05");
  EXPECT_EQ(attributes.at("imageCounter"), std::to_string(info.number));
  EXPECT_EQ(attributes.at("expTime"), "0.5");
  EXPECT_EQ(attributes.at("framesPerSecond"), "24/1");
  EXPECT_FALSE(attributes.contains("focus"));  // is in metres
  info.light_speed = 299'792'458;
  info.focus = 2.5 / info.light_speed;
  EXPECT_EQ(in_one_part(noise(), info).attributes.at("focus"), "2.5");
  for (const double rate : {29.97, 60.0, 0.5}) {
    info.rate = rate;
    EXPECT_FALSE(in_one_part(noise(), info).attributes.contains("timeCode")) << rate;
  }
  const auto still = in_one_part(noise()).attributes;
  for (const char* name : {"expTime", "focus", "originalDataWindow", "multiView"}) {
    EXPECT_FALSE(still.contains(name)) << name;
  }
}

// Right of the middle by 0.1 of the distance: a film whose middle is there shows it in its own middle.
TEST(ExrHeaders, MatricesKnowAShiftedFilm) {
  PictureInfo info;
  info.pose.film_shift = 0.1;
  info.pose.vertical_fov = 1;
  const auto attributes = in_one_part(noise(), info).attributes;
  std::istringstream text(attributes.at("worldToNDC"));
  std::array<double, 16> m{};
  for (double& value : m) text >> value;
  const std::array<double, 4> point = {1, 0, -10, 1};
  std::array<double, 4> film{};
  for (std::size_t i = 0; i < 16; ++i) film[i % 4] += point[i / 4] * m[i];
  EXPECT_NEAR(film[0] / film[3], 0.5, 1e-6);
  EXPECT_NEAR(film[1] / film[3], 0.5, 1e-6);
  EXPECT_EQ(attributes.at("screenWindowCenter"), "0.1 0");
  EXPECT_NEAR(std::stod(attributes.at("screenWindowWidth")), 2 * std::tan(0.5) * 70 / 50, 1e-6);
}

TEST(ExrHeaders, HoldNoCryptomatteWithoutItsChannels) {
  PictureInfo info;
  info.texts = {{"cryptomatte/0123456/name", "crypto_object"},
                {"cryptomatte/0123456/manifest", "{}"},
                {"other", "stays"}};
  const auto attributes = in_one_part(noise(), info).attributes;
  EXPECT_TRUE(attributes.contains("other"));
  EXPECT_FALSE(attributes.contains("cryptomatte/0123456/name"));
  EXPECT_FALSE(attributes.contains("cryptomatte/0123456/manifest"));
  info.texts[0].second = "depth";
  EXPECT_TRUE(in_one_part(noise(), info).attributes.contains("cryptomatte/0123456/manifest"));
}

}  // namespace
}  // namespace restframe
