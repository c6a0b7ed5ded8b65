// What mattes call the things of a scene file, of assets, and of assets in place of scene files.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/cryptomatte.h"
#include "support/authored_asset.h"
#include "support/loaded_scene.h"
#include "support/matte_reader.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string layers =
    "[output]\npreview = false\nlayers = ['beauty', 'crypto_object', 'crypto_material', "
    "'crypto_asset']\n";
const std::string view =
    "[render]\nresolution = [16, 8]\nsamples = 4\n[camera]\nposition = [0, 0, 4]\ndirection = [0, "
    "0, -1]\nfov = 53.13010235415598\n";  // at z = 0: x from -4 to 4, y from -2 to 2

// Two squares, x from -3 to -1 and from 1 to 3.
const AssetFile pair{"pair.obj",
                     "v -3 -1 0\nv -1 -1 0\nv -1 1 0\nv -3 1 0\nv 1 -1 0\nv 3 -1 0\nv 3 1 0\n"
                     "v 1 1 0\no left\nf 1 2 3 4\no right\nf 5 6 7 8\n"};

ExrPicture shown_pair(const std::string& text) {
  return path_pictures(layers + view + text, {pair})[0];
}

TEST(MatteNames, NodesOfAnAssetAreObjectsOfTheirOwn) {
  const ExrPicture picture = shown_pair("[[object]]\nname = 'gate'\nasset = 'pair.obj'\n");
  const MatteReader objects(picture, "crypto_object"), assets(picture, "crypto_asset");
  EXPECT_THAT(objects.manifest(),
              ElementsAre(testing::Key("gate/left"), testing::Key("gate/right")));
  EXPECT_EQ(objects.coverage("gate/left", 3, 4), 1);
  EXPECT_EQ(objects.coverage("gate/right", 3, 4), 0);
  EXPECT_EQ(objects.coverage("gate/right", 12, 4), 1);
  EXPECT_THAT(assets.manifest(), ElementsAre(testing::Key("gate")));
  EXPECT_EQ(assets.coverage("gate", 3, 4), 1);
  EXPECT_EQ(assets.coverage("gate", 12, 4), 1);
  EXPECT_EQ(assets.sum(8, 0), 0);
}

TEST(MatteNames, ANodeThatIsPickedIsTheObject) {
  const ExrPicture picture = shown_pair(
      "[[object]]\nname = 'post'\nasset = 'pair.obj'\nnode = 'left'\n"
      "[[object]]\nname = 'other'\nasset = 'pair.obj'\nwithout = 'left'\n");
  const MatteReader objects(picture, "crypto_object");
  EXPECT_THAT(objects.manifest(), ElementsAre(testing::Key("other"), testing::Key("post")));
  EXPECT_EQ(objects.coverage("post", 3, 4), 1);
  EXPECT_EQ(objects.coverage("other", 12, 4), 1);
}

TEST(MatteNames, OddOnesComeBackFromTheFile) {
  const std::string odd = "a \"b\" \\ 'c'\n\tBälle \xe2\x98\x83/\xf0\x9f\x9a\x8b {}:,";
  const ExrPicture picture = shown_pair(
      "[[object]]\nname = \"a \\\"b\\\" \\\\ 'c'\\n\\tBälle \xe2\x98\x83/\xf0\x9f\x9a\x8b {}:,\"\n"
      "asset = 'pair.obj'\nnode = 'left'\n");
  const MatteReader objects(picture, "crypto_object");
  EXPECT_THAT(objects.manifest(), ElementsAre(testing::Pair(odd, matte_id(odd))));
  EXPECT_EQ(objects.coverage(odd, 3, 4), 1);
}

// In Latin-1, as old programs write it.
TEST(MatteNames, MaterialsOfOneNameShareAnId) {
  const AssetFile red{"red.obj", "mtllib red.mtl\nusemtl Lack gr\xfcn\n" + pair.content};
  const AssetFile lib{"red.mtl", "newmtl Lack gr\xfcn\nKd 1 0 0\n"};
  const std::string text =
      "[[object]]\nname = 'one'\nasset = 'red.obj'\nnode = 'left'\n"
      "[[object]]\nname = 'two'\nasset = 'copy.obj'\nnode = 'right'\n";
  const AssetFile copy{"copy.obj", red.content};
  const MatteReader materials(path_pictures(layers + view + text, {red, copy, lib})[0],
                              "crypto_material");
  EXPECT_EQ(materials.manifest().count("Lack gr\xc3\xbcn"), 1U);
  EXPECT_EQ(materials.coverage("Lack gr\xc3\xbcn", 3, 4), 1);
  EXPECT_EQ(materials.coverage("Lack gr\xc3\xbcn", 12, 4), 1);
}

// The names of an object's parts, in the order of the parts.
std::vector<std::string> names_of_parts(const Object& object) {
  std::vector<std::string> names;
  for (const PlacedMesh& part : object.parts) {
    names.push_back(part.name < 0 ? object.name
                                  : object.part_names[static_cast<std::size_t>(part.name)]);
  }
  return names;
}

class MatteNamesOfAssets : public test::AuthoredAsset {
 protected:
  // Its tram moves, and the wheel with it.
  static test::GltfBuilder moving_street() {
    test::GltfBuilder builder = test::street();
    test::say(builder, "/nodes/1", {{"velocity", {0.5, 0, 0}}});
    return builder;
  }
};

TEST_F(MatteNamesOfAssets, AreTheNodesInPlaceOfASceneFile) {
  test::GltfBuilder builder = moving_street();
  test::say(builder, "/scenes/0", {{"output", {{"layers", {"crypto_object", "crypto_asset"}}}}});
  const Scene scene = load(builder);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_THAT(names_of_parts(scene.objects[0]), ElementsAre("house"));
  EXPECT_THAT(names_of_parts(scene.objects[1]), ElementsAre("tram", "wheel"));
  EXPECT_EQ(scene.objects[0].name, "street");
  EXPECT_EQ(scene.objects[1].whole, "street");
  const MatteIds ids = matte_ids(scene);
  EXPECT_THAT(ids.assets, testing::Each(matte_id("street")));
}

TEST_F(MatteNamesOfAssets, FollowTheObjectInASceneFile) {
  const test::GltfBuilder builder = moving_street();
  load(builder);
  const std::string object = "[[object]]\nname = 'east'\nasset = 'street.glb'\n";
  const Scene scene = load_toml(layers + object);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_THAT(names_of_parts(scene.objects[0]), ElementsAre("east"));
  EXPECT_EQ(scene.objects[1].name, "east/tram");
  EXPECT_THAT(names_of_parts(scene.objects[1]), ElementsAre("east/tram", "east/wheel"));
  EXPECT_EQ(scene.objects[1].whole, "east");
  const Scene unnamed = load_toml(object);
  for (const Object& it : unnamed.objects) EXPECT_THAT(it.part_names, IsEmpty());
}

}  // namespace
}  // namespace restframe
