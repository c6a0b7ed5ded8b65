// The table of layers, and the channels that pictures have of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "film/picture.h"
#include "support/all_layers.h"

namespace restframe {
namespace {

std::set<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(Layers, TheTableHasEachOnce) {
  std::set<Layer> layers;
  std::set<std::string> names;
  for (const LayerInfo& info : layer_table()) {
    layers.insert(info.layer);
    names.insert(info.scene_name);
  }
  EXPECT_EQ(layers, std::set<Layer>(all_layers.begin(), all_layers.end()));
  EXPECT_EQ(layer_table().size(), all_layers.size());
  EXPECT_EQ(names, words("beauty Z time doppler N P UV id variance samples crypto_object "
                         "crypto_material crypto_asset motion emission direct indirect reflection "
                         "transmission lights albedo depth normal"));
}

TEST(Layers, TheTableHasEachChannelOnce) {
  std::set<std::string> channels;
  std::size_t count = 0;
  for (const LayerInfo& info : layer_table()) {
    for (const DataChannel& channel : info.channels) channels.insert(channel.exr_name);
    for (const StatisticChannel& channel : info.statistics) channels.insert(channel.exr_name);
    count += info.channels.size() + info.statistics.size();
  }
  EXPECT_EQ(channels,
            words("Z time_proper.V time_world.V doppler.D N.X N.Y N.Z P.X P.Y P.Z UV.U UV.V UV.A "
                  "id_object.V id_material.V variance.R variance.G variance.B samples.V motion.U "
                  "motion.V motion.A depth_planar.Z normal.X normal.Y normal.Z"));
  EXPECT_EQ(channels.size(), count);
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
  const Vec3f color(1.5F, std::numeric_limits<float>::infinity(),
                    std::numeric_limits<float>::quiet_NaN());
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

}  // namespace
}  // namespace restframe
