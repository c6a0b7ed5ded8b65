// A scene that an asset makes of itself, by what it says in extras.restframe.

#include <gmock/gmock.h>

#include "support/authored_asset.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::say;
using test::street;
using test::street_lamp;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using GltfExtras = test::AuthoredAsset;

std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  return names;
}

Vec3 place_of_first_part(const Object& object) {
  return Vec3(object.parts.at(0).object_from_mesh[3]);
}

// One light-second along x at 0.6c is a gamma beta of 0.75.
const Vec3 fast(0.75, 0, 0);

TEST_F(GltfExtras, WithoutWordsAllNodesAreOneObjectAtRest) {
  const Scene scene = load(street());
  EXPECT_THAT(names(scene), ElementsAre("street"));
  EXPECT_EQ(scene.objects[0].parts.size(), 3U);
  EXPECT_EQ(scene.objects[0].worldline.velocity, Velocity());
  EXPECT_EQ(scene.objects[0].materials.size(), 2U);
  EXPECT_THAT(scene.output.path, "out/street.####.exr");
}

TEST_F(GltfExtras, AVelocityTakesTheSubtreeAlong) {
  for (const json& spelling : {json{{"velocity", {0.6, 0, 0}}, {"time", 4}, {"clock", 7}},
                               json("velocity = [0.6, 0, 0]\ntime = 4\nclock = 7"),
                               json("gamma = 1.25\ndirection = [3, 0, 0]\ntime = 4\nclock = 7")}) {
    GltfBuilder builder = street();
    say(builder, "/nodes/1", spelling);
    const Scene scene = load(builder);
    ASSERT_THAT(names(scene), ElementsAre("street", "tram")) << spelling;
    EXPECT_EQ(scene.objects[0].parts.size(), 1U);
    const Object& tram = scene.objects[1];
    EXPECT_NEAR(glm::distance(tram.worldline.velocity.gamma_beta(), fast), 0, 1e-15);
    EXPECT_EQ(tram.worldline.reference.x, Vec3(1, 2, 3));
    EXPECT_EQ(tram.worldline.reference.t, 4);
    EXPECT_EQ(tram.clock, 7);
    ASSERT_EQ(tram.parts.size(), 2U);  // around the tram's origin
    EXPECT_EQ(place_of_first_part(tram), Vec3(0));
    EXPECT_EQ(Vec3(tram.parts[1].object_from_mesh[3]), Vec3(0, -1, 0));
    EXPECT_EQ(tram.materials, scene.objects[0].materials);
  }
}

TEST_F(GltfExtras, AVelocityBelowOneIsAnObjectOfItsOwn) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {0.6, 0, 0}}});
  say(builder, "/nodes/2", {{"velocity", {0, 0, -0.6}}, {"clock", "frame"}, {"time", -1}});
  const Scene scene = load(builder);
  ASSERT_THAT(names(scene), ElementsAre("street", "tram", "wheel"));
  const Object& wheel = scene.objects[2];
  EXPECT_EQ(wheel.worldline.reference.x, Vec3(1, 1, 3));  // its place in the asset, at its time
  EXPECT_EQ(wheel.worldline.reference.t, -1);
  EXPECT_NEAR(wheel.worldline.velocity.gamma_beta().z, -0.75, 1e-15);
  EXPECT_TRUE(wheel.frame_clock);
  EXPECT_EQ(place_of_first_part(wheel), Vec3(0));
  EXPECT_EQ(scene.objects[1].parts.size(), 1U);
}

TEST_F(GltfExtras, APositionReplacesTheNodes) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {0.6, 0, 0}}, {"position", {10, 20, 30}}});
  const Scene scene = load(builder);
  EXPECT_EQ(object(scene, "tram").worldline.reference.x, Vec3(10, 20, 30));
  EXPECT_EQ(Vec3(object(scene, "tram").parts.at(1).object_from_mesh[3]), Vec3(0, -1, 0));
}

TEST_F(GltfExtras, AClockAloneMakesAnObjectAtRest) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"clock", 3}});
  const Scene scene = load(builder);
  EXPECT_EQ(object(scene, "tram").worldline.velocity, Velocity());
  EXPECT_EQ(object(scene, "tram").clock, 3);
}

TEST_F(GltfExtras, NamesAreMadeUnique) {
  GltfBuilder builder = street();
  builder.json["nodes"][0].erase("name");
  builder.json["nodes"][2]["name"] = "tram";
  for (const char* node : {"/nodes/0", "/nodes/1", "/nodes/2"}) {
    say(builder, node, {{"velocity", {0, 0, 0}}});
  }
  EXPECT_THAT(names(load(builder)), ElementsAre("node_0", "tram", "tram_2"));
}

TEST_F(GltfExtras, LengthsAreDividedByTheLightSpeed) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {0.6, 0, 0}}});
  say(builder, "/scenes/0", {{"scene", {{"light_speed", 2}}}});
  const Scene scene = load(builder);
  EXPECT_EQ(object(scene, "tram").worldline.reference.x, Vec3(0.5, 1, 1.5));
  EXPECT_EQ(Vec3(object(scene, "tram").parts.at(1).object_from_mesh[3]), Vec3(0, -0.5, 0));
}

TEST_F(GltfExtras, MaterialsTakeConstantsAndFunctions) {
  GltfBuilder builder = street();
  say(builder, "/materials/0",
      "roughness = 0.25\n[base_color]\nperiod = 1\nintervals = [[0, 0.5, 'red']]");
  say(builder, "/materials/1", {{"emission", "#ffffff"}, {"unlit", true}});
  const Scene scene = load(builder);
  ASSERT_EQ(scene.materials.size(), 2U);
  EXPECT_EQ(scene.materials[0].roughness.value, 0.25F);
  const int function = scene.materials[0].base_color.function;
  ASSERT_NE(function, no_function);
  const auto& blink =
      std::get<IntervalFunction>(scene.functions.at(static_cast<std::size_t>(function)));
  EXPECT_EQ(*blink.period, 1);
  EXPECT_EQ(blink.intervals.at(0).value, Vec3f(1, 0, 0));
  EXPECT_EQ(without_folder(scene.function_places.at(0)),
            "street.glb:/materials/0/extras/restframe:2:1: material \"paint\": base_color");
  EXPECT_EQ(scene.materials[1].emission.value, Vec3f(1));
  EXPECT_TRUE(scene.materials[1].unlit);
}

TEST_F(GltfExtras, FunctionsMayStandInFilesBesideTheAsset) {
  folder_.write("blink.txt", "% period 1\n% interval 0 0.5 Yellow\n");
  GltfBuilder builder = street();
  say(builder, "/materials/0", {{"base_color", {{"file", "blink.txt"}}}});
  const Scene scene = load(builder);
  EXPECT_EQ(scene.functions.size(), 1U);
  ASSERT_EQ(scene.sources.size(), 2U);
  EXPECT_EQ(scene.sources[1].name, "blink.txt");
}

TEST_F(GltfExtras, TheSceneHasTheTablesOfASceneFile) {
  const json tables = {
      {"animation", {{"rate", 25}, {"start", -1}, {"pictures", 3}}},
      {"exposure", {{"shutter", 0.5}, {"count", 2}, {"combine", "max"}}},
      {"render", {{"resolution", {32, 16}}, {"samples", 4}, {"integrator", "path"}}},
      {"output", {{"path", "there/a.##.exr"}, {"layers", {"beauty", "doppler"}}}},
      {"light", json::array({{{"type", "environment"}, {"name", "sky"}}})},
      {"material", json::array({{{"name", "p*"}, {"metallic", 0.5}}})}};
  const std::string toml =
      "[animation]\nrate = 25\nstart = -1\npictures = 3\n"
      "[exposure]\nshutter = 0.5\ncount = 2\ncombine = 'max'\n"
      "[render]\nresolution = [32, 16]\nsamples = 4\nintegrator = 'path'\n"
      "[output]\npath = 'there/a.##.exr'\nlayers = ['beauty', 'doppler']\n"
      "[[light]]\ntype = 'environment'\nname = 'sky'\n[[material]]\nname = 'p*'\nmetallic = 0.5\n";
  for (const json& spelling : {tables, json(toml)}) {
    GltfBuilder builder = street();
    say(builder, "/scenes/0", spelling);
    const Scene scene = load(builder);
    EXPECT_EQ(scene.animation.rate, 25);
    EXPECT_EQ(scene.animation.pictures, 3);
    EXPECT_EQ(scene.exposure.count, 2);
    EXPECT_EQ(scene.exposure.combine, Combine::max);
    EXPECT_EQ(scene.render.width, 32);
    EXPECT_EQ(scene.render.integrator, IntegratorKind::path);
    EXPECT_EQ(scene.output.path, "there/a.##.exr");
    EXPECT_THAT(scene.output.layers, ElementsAre(Layer::beauty, Layer::doppler));
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.lights[1].name, "sky");
    EXPECT_EQ(scene.materials.at(0).metallic.value, 0.5F);
    EXPECT_TRUE(warnings_.empty());
  }
}

TEST_F(GltfExtras, OnlyTheDefaultSceneSpeaks) {
  GltfBuilder builder = street();
  builder.json["scenes"].push_back({{"nodes", {0}}});
  say(builder, "/scenes/0", {{"render", {{"samples", 4}}}});
  say(builder, "/scenes/1", {{"render", {{"samples", 5}}}});
  EXPECT_EQ(load(builder).render.samples, 4);
  builder.json["scene"] = 1;
  EXPECT_EQ(load(builder).render.samples, 5);
}

TEST_F(GltfExtras, UnderAnObjectAtRestNodesMove) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {0.6, 0, 0}}, {"time", 1}});
  say(builder, "/nodes/2", {{"velocity", {0, 0, 0}}, {"clock", 5}});
  say(builder, "/scenes/0", {{"render", {{"samples", 4}}}});
  folder_.write("street.glb", builder.glb());
  const Scene scene = load_toml(
      "[[object]]\nname = 'city'\nasset = 'street.glb'\nposition = [100, 0, 0]\ntime = 10\n"
      "clock = 'frame'\nrotation = [0, 90, 0]\nscale = 2\nmaterials = {paint = 'gold'}\n"
      "[[object]]\nsphere = {}\n"
      "[[material]]\nname = 'gold'\n[[material]]\nname = 'gold'\nobject = 'city'\nmetallic = 0\n"
      "[[material]]\nname = 'gold'\nobject = 'city/tram'\nroughness = 0\n");
  ASSERT_THAT(names(scene), ElementsAre("city", "city/tram", "city/wheel", "object_2"));
  const Object& tram = scene.objects[1];
  // About y by 90 degrees, x goes to -z and z to x.
  EXPECT_NEAR(glm::distance(tram.worldline.reference.x, Vec3(106, 4, -2)), 0, 1e-12);
  EXPECT_EQ(tram.worldline.reference.t, 11);
  EXPECT_NEAR(glm::distance(tram.worldline.velocity.gamma_beta(), Vec3(0, 0, -0.75)), 0, 1e-15);
  EXPECT_TRUE(tram.frame_clock);
  EXPECT_FALSE(scene.objects[2].frame_clock);
  EXPECT_EQ(scene.objects[2].clock, 5);
  EXPECT_NEAR(glm::length(Vec3(tram.parts.at(0).object_from_mesh[0])), 2, 1e-12);
  const auto material = [&](std::size_t i) {
    return scene.materials.at(static_cast<std::size_t>(scene.objects[i].materials.at(0)));
  };
  EXPECT_EQ(material(0).metallic.value, 0);
  EXPECT_EQ(material(0).roughness.value, 1);
  EXPECT_EQ(material(1).roughness.value, 0);
  EXPECT_EQ(scene.objects[2].materials, scene.objects[0].materials);
  EXPECT_EQ(scene.render.samples, 16);
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_EQ(without_folder(warnings_[0]),
            "street.glb:/scenes/0/extras/restframe: is left out: the scene file says it, which "
            "names this asset");
}

TEST_F(GltfExtras, ACameraRidesAndTracksMovingNodes) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {0.6, 0, 0}}});
  folder_.write("street.glb", builder.glb());
  const Scene scene = load_toml(
      "[[object]]\nname = 'city'\nasset = 'street.glb'\n"
      "[camera]\non = 'city/tram'\nposition = [0, 1, 0]\n");
  const auto& path = std::get<Worldline>(scene.camera.motion);
  EXPECT_EQ(path.reference.x, Vec3(1, 3, 3));
  EXPECT_NEAR(glm::distance(path.velocity.gamma_beta(), fast), 0, 1e-15);
}

}  // namespace
}  // namespace restframe
