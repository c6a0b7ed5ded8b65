// Cryptomatte's hash, ids, ranks and manifest.

#include "film/cryptomatte.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "film/aov.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;

// Published values of MurmurHash3_x86_32 with seed 0; lengths of all remainders by 4.
TEST(Murmur3, AgreesWithPublishedValues) {
  EXPECT_EQ(murmur3_32(""), 0U);
  EXPECT_EQ(murmur3_32("test"), 0xba6bd213U);
  EXPECT_EQ(murmur3_32("hello"), 0x248bfa47U);
  EXPECT_EQ(murmur3_32("hello, world"), 0x149bbb7fU);
  EXPECT_EQ(murmur3_32("Hello, world!"), 0xc0363e43U);
  EXPECT_EQ(murmur3_32("The quick brown fox jumps over the lazy dog"), 0x2e4ff723U);
}

// Blocks of zero bytes add nothing but mixing: of bytes from 0x80 on, the signs must not.
TEST(Murmur3, ReadsBytesWithoutSign) {
  EXPECT_EQ(murmur3_32(std::string_view("\0\0\0\0", 4)), 0x2362f9deU);
  EXPECT_EQ(murmur3_32("\xff\xff\xff\xff"), 0x76293b50U);
  EXPECT_EQ(murmur3_32("\x21\x43\x65\x87"), 0xf55b516bU);
  EXPECT_EQ(murmur3_32("\x21\x43\x65"), 0x7e4a8634U);
  EXPECT_EQ(murmur3_32("\x21\x43"), 0xa0f7b07aU);
  EXPECT_EQ(murmur3_32("\x21"), 0x72661cf4U);
}

// One hash in 128 is no normal float; its exponent's lowest bit is turned.
TEST(MatteId, IsANormalFloat) {
  int changed = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string name = "name " + std::to_string(i);
    const std::uint32_t hash = murmur3_32(name), id = matte_id(name);
    ASSERT_TRUE(std::isnormal(std::bit_cast<float>(id))) << name;
    if (std::isnormal(std::bit_cast<float>(hash))) {
      ASSERT_EQ(id, hash) << name;
    } else {
      ASSERT_EQ(id ^ hash, 0x00800000U) << name;
      ++changed;
    }
  }
  EXPECT_NEAR(changed, 20'000 / 128, 60);
  EXPECT_EQ(matte_id(""), 0x00800000U);
  EXPECT_EQ(matte_id("hello"), 0x248bfa47U);
}

TEST(MatteNames, AreUtf8) {
  EXPECT_EQ(utf8_name("B\xc3\xa4lle"), "B\xc3\xa4lle");
  EXPECT_EQ(utf8_name("B\xe4lle"), "B\xc3\xa4lle") << "Latin-1";
  EXPECT_EQ(utf8_name("\xff"), "\xc3\xbf");
  EXPECT_EQ(utf8_name(""), "");
}

// The 32 bits of ids that are no hashes, to see them.
CoverTable table_of(const std::vector<std::pair<std::uint32_t, float>>& covers) {
  CoverTable table;
  for (const auto& [id, weight] : covers) table.add(id, weight);
  return table;
}

std::vector<std::pair<std::uint32_t, float>> ranked(const CoverTable& table, int samples) {
  std::vector<std::pair<std::uint32_t, float>> all;
  for (const MatteRank& rank : matte_ranks(table.covers(), samples)) {
    all.emplace_back(std::bit_cast<std::uint32_t>(rank.id), rank.coverage);
  }
  return all;
}

TEST(MatteRanks, FallAndTiesAreById) {
  const CoverTable table =
      table_of({{7, 1}, {3, 1}, {9, 1}, {5, 1}, {9, 1}, {2, 0.25F}, {2, 0.25F}});
  EXPECT_THAT(ranked(table, 8),
              ElementsAre(std::pair(9U, 0.25F), std::pair(3U, 0.125F), std::pair(5U, 0.125F),
                          std::pair(7U, 0.125F), std::pair(2U, 0.0625F), std::pair(0U, 0.0F)));
}

TEST(MatteRanks, HoldTheLargestSix) {
  const CoverTable table =
      table_of({{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}, {8, 4}});
  EXPECT_THAT(ranked(table, 32), ElementsAre(std::pair(7U, 7 / 32.0F), std::pair(6U, 6 / 32.0F),
                                             std::pair(5U, 5 / 32.0F), std::pair(4U, 4 / 32.0F),
                                             std::pair(8U, 4 / 32.0F), std::pair(3U, 3 / 32.0F)));
  EXPECT_THAT(ranked({}, 1), testing::Each(std::pair(0U, 0.0F)));
}

// One that covers half comes after so many small ones that they alone fill the table.
TEST(CoverTable, KeepsWhatIsMetAgainAndAgain) {
  CoverTable table;
  for (std::uint32_t i = 1; i <= CoverTable::capacity + 8; ++i) table.add(i, 1);
  EXPECT_EQ(table.covers().size(), CoverTable::capacity);
  for (std::uint32_t i = 0; i < 100; ++i) {
    table.add(1000, 1);
    table.add(2000 + i, 1);
  }
  EXPECT_EQ(table.covers().size(), CoverTable::capacity);
  const auto [id, coverage] = ranked(table, 1)[0];
  EXPECT_EQ(id, 1000U);
  EXPECT_LE(coverage, 100);
  EXPECT_GE(coverage, 100 - (CoverTable::capacity + 8 + 200.0) / CoverTable::capacity);
}

Scene named_scene() {
  Scene scene;
  scene.objects.resize(3);
  scene.objects[0].name = "ball";
  scene.objects[0].parts = {{0, Mat4(1)}};
  scene.objects[1].name = "tram";
  scene.objects[1].parts = {{0, Mat4(1), 0}, {0, Mat4(1), 1}};
  scene.objects[1].part_names = {"tram/body", "ball"};
  scene.objects[2].name = "tram/wheel";
  scene.objects[2].whole = "tram";
  scene.objects[2].parts = {{0, Mat4(1)}};
  scene.materials.resize(3);
  scene.materials[0].name = scene.materials[1].name = "a \"b\" \\ \n B\xe4lle";
  scene.output.layers = {Layer::crypto_object, Layer::crypto_material, Layer::crypto_asset};
  return scene;
}

std::map<std::string, std::string> manifest_of(const Scene& scene, const std::string& layer) {
  std::string key;
  for (const auto& [name, text] : cryptomatte_texts(scene)) {
    if (name.ends_with("/name") && text == layer) key = name.substr(0, name.size() - 4);
    if (!key.empty() && name == key + "manifest") return nlohmann::json::parse(text);
  }
  return {};
}

TEST(Manifest, NamesWhatAPictureMayShow) {
  const Scene scene = named_scene();
  const auto hex = [](const std::string& name) { return fmt::format("{:08x}", matte_id(name)); };
  using Manifest = std::map<std::string, std::string>;
  EXPECT_EQ(manifest_of(scene, "crypto_object"), (Manifest{{"ball", hex("ball")},
                                                           {"tram/body", hex("tram/body")},
                                                           {"tram/wheel", hex("tram/wheel")}}));
  EXPECT_EQ(manifest_of(scene, "crypto_asset"),
            (Manifest{{"ball", hex("ball")}, {"tram", hex("tram")}}));
  const std::string odd = "a \"b\" \\ \n B\xc3\xa4lle";
  EXPECT_EQ(manifest_of(scene, "crypto_material"),
            (Manifest{{odd, hex(odd)}, {"material 3", hex("material 3")}}));
}

TEST(Manifest, KeysAreTheHashesOfLayers) {
  const auto texts = cryptomatte_texts(named_scene());
  ASSERT_EQ(texts.size(), 12U);
  EXPECT_EQ(
      texts[0].first,
      "cryptomatte/" + fmt::format("{:08x}", matte_id("crypto_object")).substr(0, 7) + "/name");
  Scene scene = named_scene();
  scene.output.layers = {Layer::beauty, Layer::id};
  EXPECT_TRUE(cryptomatte_texts(scene).empty());
}

TEST(MatteIds, AreThoseOfNames) {
  const MatteIds ids = matte_ids(named_scene());
  EXPECT_THAT(ids.objects, ElementsAre(matte_id("ball"), matte_id("tram"), matte_id("tram/body"),
                                       matte_id("ball"), matte_id("tram/wheel")));
  EXPECT_THAT(ids.first, ElementsAre(0U, 1U, 4U));
  EXPECT_THAT(ids.assets, ElementsAre(matte_id("ball"), matte_id("tram"), matte_id("tram")));
  ASSERT_EQ(ids.materials.size(), 3U);
  EXPECT_EQ(ids.materials[0], ids.materials[1]);
  EXPECT_EQ(ids.materials[2], matte_id("material 3"));
  Scene scene = named_scene();
  scene.output.layers = {Layer::beauty, Layer::crypto_asset};
  const MatteIds of_assets = matte_ids(scene);
  EXPECT_TRUE(of_assets.objects.empty());
  EXPECT_TRUE(of_assets.materials.empty());
  EXPECT_EQ(of_assets.assets.size(), 3U);
}

TEST(MatteChannels, AreTwoRanksInFour) {
  EXPECT_THAT(
      matte_channels("crypto_asset"),
      ElementsAre("crypto_asset00.R", "crypto_asset00.G", "crypto_asset00.B", "crypto_asset00.A",
                  "crypto_asset01.R", "crypto_asset01.G", "crypto_asset01.B", "crypto_asset01.A",
                  "crypto_asset02.R", "crypto_asset02.G", "crypto_asset02.B", "crypto_asset02.A"));
}

}  // namespace
}  // namespace restframe
