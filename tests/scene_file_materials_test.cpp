// What a scene file says of materials: whose it changes, in which slots, and as functions of time.

#include <gmock/gmock.h>

#include <optional>

#include "support/surface_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using SceneFileMaterials = SceneReading;

TEST_F(SceneFileMaterials, MaterialsChangeThoseOfAssets) {
  const Scene scene = read(lattice_text + R"(
[[material]]
name = "balls"
base_color = "red"
metallic = 0
roughness = 0.25
emission = [0, 2, 0]
emission_strength = 3
unlit = true
thin_walled = true
)");
  const Material& material = slot(scene, 0, balls);
  EXPECT_EQ(material.name, "balls");
  EXPECT_EQ(material.base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(material.metallic.value, 0);
  EXPECT_EQ(material.roughness.value, 0.25F);
  EXPECT_EQ(material.emission.value, Vec3f(0, 2, 0));
  EXPECT_EQ(material.emission_strength.value, 3);
  EXPECT_TRUE(material.unlit);
  EXPECT_TRUE(material.thin_walled);
  EXPECT_FALSE(slot(scene, 0, rods).unlit);
}

TEST_F(SceneFileMaterials, PatternsChangeSeveralMaterialsLaterOnesLast) {
  const Scene scene = read(lattice_text +
                           "[[material]]\nname = \"*s\"\nbase_color = \"red\"\nroughness = 0\n"
                           "[[material]]\nname = \"ro*\"\nbase_color = \"blue\"\n");
  EXPECT_EQ(slot(scene, 0, balls).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 0, rods).base_color.value, Vec3f(0, 0, 1));
  EXPECT_EQ(slot(scene, 0, rods).roughness.value, 0);
}

TEST_F(SceneFileMaterials, MaterialsOfOneObjectLeaveTheOthersAlone) {
  const std::string one = "[[object]]\nname = \"one\"\nsphere = {}\n";
  const std::string two = "[[object]]\nname = \"two\"\nsphere = {}\n";
  const Scene scene =
      read(one + two + "[[material]]\nname = \"ball\"\nobject = \"two\"\nbase_color = \"red\"\n");
  EXPECT_NE(slot(scene, 0, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 1, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 1, 0).name, "ball");
  EXPECT_EQ(scene.meshes.size(), 1U);
}

TEST_F(SceneFileMaterials, NewMaterialsReplaceAllSlotsOrOneByOne) {
  const std::string gold = "[[material]]\nname = \"gold\"\nbase_color = \"gold\"\n";
  const Scene all = read(lattice_text + "material = \"gold\"\n" + gold);
  EXPECT_EQ(slot(all, 0, balls).name, "gold");
  EXPECT_EQ(all.objects[0].materials.at(balls), all.objects[0].materials.at(rods));
  EXPECT_EQ(slot(all, 0, balls).metallic.value, 1) << "glTF's default";
  const Scene one = read(lattice_text + "materials = {balls = \"gold\"}\n" + gold);
  EXPECT_EQ(slot(one, 0, balls).name, "gold");
  EXPECT_EQ(slot(one, 0, rods).name, "rods");
  const Scene both =
      read(lattice_text + "material = \"gold\"\nmaterials = {balls = \"rods\"}\n" + gold);
  EXPECT_EQ(slot(both, 0, balls).name, "rods");
  EXPECT_EQ(slot(both, 0, rods).name, "gold");
}

TEST_F(SceneFileMaterials, AnObjectMayUseItsOwnOrAnothersAssetMaterial) {
  const Scene scene =
      read(lattice_text + "material = \"rods\"\n" + sphere_text + "material = \"balls\"\n" +
           "[[material]]\nname = \"rods\"\nbase_color = \"red\"\n");
  EXPECT_EQ(slot(scene, 0, balls).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 1, 0).name, "balls");
}

TEST_F(SceneFileMaterials, ANewMaterialMayDifferOnOneObject) {
  const Scene scene =
      read(sphere_text + "material = \"gold\"\n" + lattice_text + "material = \"gold\"\n" + R"(
[[material]]
name = "gold"
base_color = "red"
[[material]]
name = "gold"
object = "lattice"
roughness = 0
)");
  EXPECT_EQ(slot(scene, 0, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 0, 0).roughness.value, 1);
  EXPECT_EQ(slot(scene, 1, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 1, 0).roughness.value, 0);
}

TEST_F(SceneFileMaterials, AMaterialThatShowsNowhereIsWarnedOf) {
  read(lattice_text +
       "materials = {balls = \"rods\"}\n[[material]]\nname = \"balls\"\nunlit = true\n");
  EXPECT_THAT(warnings,
              ElementsAre(HasSubstr("scene.toml:6:8: material \"balls\" is on no object")));
}

TEST_F(SceneFileMaterials, OpacityMakesMaterialsBlend) {
  const auto mode = [&](const std::string& opacity) {
    return slot(read(sphere_text + "[[material]]\nname = \"ball\"\nopacity = " + opacity), 0, 0)
        .alpha_mode;
  };
  EXPECT_EQ(mode("1"), AlphaMode::opaque);
  EXPECT_EQ(mode("0.5"), AlphaMode::blend);
  EXPECT_EQ(mode("{formula = \"abs(sin(t))\"}"), AlphaMode::blend);
}

TEST_F(SceneFileMaterials, PropertiesMayBeFunctionsOfTheClock) {
  folder.write("blink.txt", "% period 1.0\n% interval 0 0.5 Yellow\n");
  const Scene scene = read(lattice_text + R"toml(
[[material]]
name = "balls"
emission = {file = "blink.txt"}
emission_strength = {formula = "1 + sin(2*pi*t)"}
roughness = {keys = [[0, 0.0], [1, 1.0]]}
opacity = {period = 2, intervals = [[1.5, 2, 0.5], [0, 1, 0.25]]}
[material.base_color]
period = 1.0
keys = [[0.0, "black"], [0.3, "#f00"], [1.0, [0, 0, 0.5]]]
[[material]]
name = "rods"
base_color = {formula = "t", from = "red", to = "blue"}
emission = {formula = ["t", "2*t", "0"]}
)toml");
  const auto function = [&](FunctionIndex index) {
    return scene.functions.at(static_cast<std::size_t>(index));
  };
  const Material& first = slot(scene, 0, balls);
  EXPECT_EQ(std::get<IntervalFunction>(function(first.emission.function)).period, 1);
  EXPECT_THAT(std::get<FormulaFunction>(function(first.emission_strength.function)).formulas,
              ElementsAre("1 + sin(2*pi*t)"));
  EXPECT_EQ(std::get<KeyFunction>(function(first.roughness.function)).period, std::nullopt);
  const auto opacity = std::get<IntervalFunction>(function(first.opacity.function));
  ASSERT_EQ(opacity.intervals.size(), 2U);
  EXPECT_EQ(opacity.intervals[0].end, 1);
  EXPECT_EQ(opacity.intervals[1].value.x, 0.5F);
  const auto color = std::get<KeyFunction>(function(first.base_color.function));
  ASSERT_EQ(color.keys.size(), 3U);
  EXPECT_EQ(color.keys[1].value, Vec3f(1, 0, 0));
  EXPECT_EQ(color.keys[2].value, Vec3f(0, 0, 0.5F));
  const Material& second = slot(scene, 0, rods);
  const auto mixed = std::get<FormulaFunction>(function(second.base_color.function));
  EXPECT_EQ(mixed.from, Vec3f(1, 0, 0));
  EXPECT_EQ(mixed.to, Vec3f(0, 0, 1));
  EXPECT_EQ(std::get<FormulaFunction>(function(second.emission.function)).formulas.size(), 3U);
}

TEST_F(SceneFileMaterials, AFunctionLeavesTheAssetsOwnValueForItsGaps) {
  const Scene scene =
      read(sphere_text +
           "[[material]]\nname = \"ball\"\nbase_color = \"red\"\n"
           "[[material]]\nname = \"ball\"\nbase_color = {intervals = [[0, 1, \"blue\"]]}\n");
  EXPECT_EQ(slot(scene, 0, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 0, 0).base_color.function, 0);
}

}  // namespace
}  // namespace restframe
