// Environments with maps in scene files: what their keys mean, and what is wrong with them.

#include <gmock/gmock.h>

#include "support/exr_writer.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string kScene =
    "[render]\nintegrator = \"path\"\n[[object]]\nname = \"ball\"\nsphere = {fineness = 0}\n"
    "rotation = [0, 90, 0]\nscale = 3\nvelocity = [0, 0.5, 0]\n[[light]]\n";

class SceneFileSky : public SceneReading {
 protected:
  SceneFileSky() {
    folder.write("skies/sky.exr",
                 sky_exr(4, 2, [](int x, int) { return Vec3f(static_cast<float>(x)); }));
  }
};

TEST_F(SceneFileSky, MapsAreReadOnceAndTurned) {
  const std::string sky = "type = \"environment\"\nfile = \"skies/sky.exr\"\n";
  const Scene scene = read(kScene + sky + "velocity = [0.1, 0, 0]\n[[light]]\n" + sky +
                           "rotation = [0, 90, 0]\n[[light]]\n" + sky + "on = \"ball\"\n");
  EXPECT_THAT(warnings, IsEmpty());
  ASSERT_EQ(scene.sky_maps.size(), 1U);
  EXPECT_EQ(scene.sky_maps[0].width, 4);
  EXPECT_EQ(scene.sky_maps[0].pixels[3], Vec3f(3));
  for (const Light& light : scene.lights) EXPECT_EQ(light.sky_map, 0);
  EXPECT_EQ(scene.lights[0].rest_from_map, Mat3(1));
  EXPECT_NEAR(scene.lights[0].worldline.velocity.beta().x, 0.1, 1e-15);
  // +X is brought to -Z, by the light's own rotation or that of what carries it.
  for (const std::size_t turned : {1, 2}) {
    const Vec3 x = scene.lights[turned].rest_from_map * Vec3(1, 0, 0);
    EXPECT_LT(glm::length(x - Vec3(0, 0, -1)), 1e-15);
  }
  EXPECT_NEAR(scene.lights[2].worldline.velocity.beta().y, 0.5, 1e-15);
  ASSERT_EQ(scene.sources.size(), 2U);
  EXPECT_EQ(scene.sources[1].name, "skies/sky.exr");
  EXPECT_EQ(scene.sources[1].hash.size(), scene.sources[0].hash.size());
}

TEST_F(SceneFileSky, BadKeysAreSaidWhereTheyStand) {
  EXPECT_THAT(faults(kScene + "type = \"sun\"\nfile = \"skies/sky.exr\"\n"),
              ElementsAre(HasSubstr("11:1: light \"light_1\": file goes with an environment")));
  EXPECT_THAT(faults(kScene + "type = \"environment\"\nrotation = [0, 1, 0]\n"),
              ElementsAre(HasSubstr("11:1: light \"light_1\": rotation goes with a file only")));
  EXPECT_THAT(faults(kScene + "type = \"environment\"\nfile = \"none.exr\"\n"),
              ElementsAre(HasSubstr("11:8: light \"light_1\": file \"none.exr\": no such file")));
  EXPECT_THAT(faults(kScene + "type = \"environment\"\nfile = 3\n"),
              ElementsAre(StartsWith("11:8: ")));
}

TEST_F(SceneFileSky, BadFilesAreSaidByTheirOwnNames) {
  folder.write("text.exr", "some text, longer than a magic number");
  const std::vector<std::string> said =
      faults(kScene + "type = \"environment\"\nfile = \"text.exr\"\n");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0], HasSubstr("text.exr: EXR file expected, this is none"));
}

TEST_F(SceneFileSky, IsWithinTheLimits) {
  ImportLimits limits;
  limits.image_pixels = 7;
  const auto scene = folder.write("limited.toml", kScene +
                                                      "type = \"environment\"\nfile = "
                                                      "\"skies/sky.exr\"\n");
  try {
    load_scene(scene, limits, warnings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("4 x 2 pixels, the limit is 7; --max-image-pixels"));
  }
}

}  // namespace
}  // namespace restframe
