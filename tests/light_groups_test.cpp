// Layers of the light of groups of lights: each is the picture that its lights alone make.

#include "scene/light_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/loaded_scene.h"
#include "support/picture_parts.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const AssetFile kFloor = {"floor.obj", quad_obj({0, -0.5, -2}, {4, 0, 0}, {0, 0, -4})};
const AssetFile kLamp = {"lamp.obj", quad_obj({1, 2.2, -1}, {0.4, 0, 0}, {0, 0, 0.4})};

// Two points in a group, a sun in another, one lamp that glows, a sky, and a point in none.
Scene studio(const std::string& render_keys) {
  reference::ObserverCamera camera;
  camera.position = {0, 0.3, 3.5};
  camera.width = camera.height = 12;
  camera.vertical_fov = 0.9;
  return loaded_scene(
      camera_text(camera, "samples = 4\ndepth = 4\n" + render_keys) +
          "[[object]]\nname = \"floor\"\nasset = \"floor.obj\"\nmaterial = \"clay\"\n"
          "[[object]]\nname = \"lamp\"\nasset = \"lamp.obj\"\nmaterial = \"lamp\"\n"
          "[[object]]\nname = \"ball\"\nsphere = {radius = 0.6, fineness = 3}\nvelocity = [0.3, 0, "
          "0]\nmaterial = \"clay\"\n"
          "[[material]]\nname = \"clay\"\nbase_color = [0.8, 0.5, 0.2]\nmetallic = 0\nroughness = "
          "0.3\n"
          "[[material]]\nname = \"lamp\"\nemission = [8, 6, 4]\ngroup = \"lamp\"\n"
          "[[light]]\nname = \"a\"\ntype = \"point\"\nposition = [-2, 2, 1]\nintensity = 5\ngroup "
          "= "
          "\"points\"\n"
          "[[light]]\nname = \"b\"\ntype = \"point\"\nposition = [2, 1, 1]\nintensity = 4\ncolor = "
          "\"red\"\ngroup = \"points\"\n"
          "[[light]]\nname = \"c\"\ntype = \"sun\"\ndirection = [0.2, -1, -0.3]\ngroup = \"sun\"\n"
          "[[light]]\nname = \"d\"\ntype = \"environment\"\nintensity = 0.2\ngroup = \"sky\"\n"
          "[[light]]\nname = \"e\"\ntype = \"point\"\nposition = [0, 3, 1]\nintensity = 2\n",
      {kFloor, kLamp});
}

// With everything else dark.
Scene lit_by(Scene scene, const std::string& group) {
  std::erase_if(scene.lights, [&](const Light& light) { return light.group != group; });
  if (group != "lamp") material_of(scene, "lamp").emission.value = Vec3f(0);
  scene.output.layers = {Layer::beauty};
  return scene;
}

TEST(LightGroupLayers, AreThePicturesOfTheirLights) {
  for (const char* keys : {"", "beaming = true", "doppler = true"}) {
    const Scene scene = studio(keys);
    const Picture picture = first_picture(with_parts(scene));
    for (const std::string group : {"points", "sun", "sky", "lamp", ""}) {
      SCOPED_TRACE(keys + group);
      const std::string layer = "light_" + (group.empty() ? "rest" : group);
      const std::vector<Vec3> alone = beauty_of(first_picture(lit_by(scene, group)));
      EXPECT_GT(mean_of(alone).x, 1e-3);
      expect_same_colors(colors_of(picture, layer), alone, 1e-5);
    }
  }
}

TEST(LightGroups, AreNamedByLightsThenMaterials) {
  Scene scene = studio("");
  EXPECT_THAT(light_groups(scene), ElementsAre("points", "sun", "sky", "lamp"));
  scene.lights[4].group = "rest";
  EXPECT_THAT(light_groups(scene), ElementsAre("points", "sun", "sky", "lamp"));
  const LightGroups groups(scene);
  EXPECT_EQ(groups.count, 4);
  EXPECT_THAT(groups.of_light, ElementsAre(1, 1, 2, 3, 0));
}

TEST(LightGroups, BeyondTheMostBelongToTheRest) {
  Scene scene;
  for (int i = 0; i < 20; ++i) scene.lights.emplace_back().group = fmt::format("g{}", i);
  const LightGroups groups(scene);
  EXPECT_EQ(groups.count, static_cast<int>(most_light_groups));
  EXPECT_EQ(groups.of_light[15], 16);
  EXPECT_EQ(groups.of_light[16], 0);
  EXPECT_THAT(validate(scene), Not(Contains(HasSubstr("groups"))));
  scene.output.layers = {Layer::lights};
  EXPECT_THAT(validate(scene), Contains(HasSubstr("20 groups, at most 16")));
}

TEST(LightGroups, HavePlainNames) {
  Scene scene = studio("");
  EXPECT_THAT(validate(scene), ElementsAre());
  scene.lights[0].group = "a b";
  material_of(scene, "lamp").group = "c.d";
  EXPECT_THAT(validate(scene), ElementsAre(HasSubstr("light \"a\": group is \"a b\""),
                                           HasSubstr("material \"lamp\": group is \"c.d\"")));
}

TEST(LayersOfParts, AreNoneOfTheMaximumOfExposures) {
  Scene scene = with_parts(studio(""));
  scene.exposure.count = 2;
  scene.exposure.combine = Combine::max;
  EXPECT_THAT(validate(scene), ElementsAre(HasSubstr("\"max\"")));
  scene.output.layers = {Layer::beauty, Layer::albedo};
  EXPECT_THAT(validate(scene), ElementsAre());
}

using GroupReading = SceneReading;

TEST_F(GroupReading, MaterialsHaveGroups) {
  const std::string object = "[[object]]\nasset = \"paint.obj\"\n";
  const Scene scene =
      read(object + "[[material]]\nname = \"paint\"\nemission = \"white\"\ngroup = \"neon-1\"\n");
  EXPECT_EQ(scene.materials[0].group, "neon-1");
  EXPECT_THAT(faults(object + "[[material]]\nname = \"paint\"\ngroup = \"neon 1\"\n"),
              ElementsAre(HasSubstr("5:9: material \"paint\": group is \"neon 1\"")));
}

TEST_F(GroupReading, LayersAreReadByName) {
  const Scene scene = read(
      "[output]\nlayers = [\"emission\", \"direct\", \"indirect\", \"reflection\", "
      "\"transmission\", \"lights\", \"albedo\", \"motion\"]\n"
      "[[object]]\nasset = \"paint.obj\"\n");
  EXPECT_THAT(scene.output.layers,
              ElementsAre(Layer::emission, Layer::direct, Layer::indirect, Layer::reflection,
                          Layer::transmission, Layer::lights, Layer::albedo, Layer::motion));
}

}  // namespace
}  // namespace restframe
