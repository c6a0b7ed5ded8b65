// Pictures through EXR files and back.

#include "film/exr_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <sstream>

#include "scene/error.h"
#include "support/all_layers.h"
#include "support/exr_reader.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

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

using ChannelValues = std::map<std::string, float>;

// Of a picture whose lengths are twice as long in scene units.
ChannelValues channels_of_surface() {
  return {
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
      {"motion.U", 1.5F},
      {"motion.V", -2.5F},
      {"motion.A", 1.0F},
      {"depth_planar.Z", 6.5F},
      {"normal.X", 0.8F},
      {"normal.Y", 0.0F},
      {"normal.Z", 0.6F},
  };
}

// A colour of its own for each part.
void set_parts(Picture& picture, int x, int y) {
  std::vector<Vec3f> parts;
  for (const int column : picture.part_columns()) {
    parts.push_back(static_cast<float>(column) + Vec3f(1, 0.5F, 0.25F));
  }
  picture.set_parts(x, y, parts);
}

ChannelValues channels_of_parts() {
  ChannelValues values;
  for (const PartLayer& part : part_layers(all_layers, {})) {
    const auto column = static_cast<float>(part.column);
    values[part.exr_name + ".R"] = column + 1;
    values[part.exr_name + ".G"] = column + 0.5F;
    values[part.exr_name + ".B"] = column + 0.25F;
  }
  return values;
}

ChannelValues channels_of_mattes() {
  ChannelValues values;
  for (const char* layer : {"crypto_object", "crypto_material", "crypto_asset"}) {
    for (const std::string& channel : matte_channels(layer)) values[channel] = 0;
  }
  values["crypto_material00.R"] = 0.5F;
  values["crypto_material00.G"] = 0.75F;
  values["crypto_material00.B"] = 8.0F;
  values["crypto_material00.A"] = 0.125F;
  return values;
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
  set_parts(picture, 2, 1);
  const ExrPicture exr = written(picture).exr;
  EXPECT_EQ(exr.width, 3);
  EXPECT_EQ(exr.height, 2);
  ChannelValues expected = {
      {"R", 0.5F},
      {"G", 0.25F},
      {"B", 2.0F},
      {"A", 1.0F},
      {"variance.R", 0.25F},
      {"variance.G", 0.5F},
      {"variance.B", std::numeric_limits<float>::max()},
      {"samples.V", 48.0F},
  };
  for (ChannelValues more : {channels_of_surface(), channels_of_parts(), channels_of_mattes()}) {
    expected.merge(more);
  }
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
