// Cameras and lights of an asset that stands in for a scene file.

#include <gmock/gmock.h>

#include <numbers>

#include "support/authored_asset.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::say;
using test::street;
using test::street_lamp;
using ::testing::ElementsAre;

using GltfExtrasView = test::AuthoredAsset;

const Vec3 fast(0.75, 0, 0);  // 0.6c

const Worldline& path_of(const Scene& scene) {
  return std::get<Worldline>(scene.camera.motion);
}

Vec3 direction_of(const Scene& scene) {
  return std::get<AimDirection>(scene.camera.aim).direction;
}

// About y by 90 degrees: -Z turns to -X.
const json turned = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};

TEST_F(GltfExtrasView, TheFirstCameraIsTheScenes) {
  GltfBuilder builder = street();
  builder.json["nodes"][4]["rotation"] = turned;
  const Scene scene = load(builder);
  EXPECT_TRUE(scene.camera_given);
  EXPECT_EQ(path_of(scene).reference.x, Vec3(0, 0, 9));
  EXPECT_NEAR(glm::distance(direction_of(scene), Vec3(-1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(scene.camera.up, Vec3(0, 1, 0)), 0, 1e-12);
  EXPECT_EQ(scene.camera.vertical_fov, 0.5);
}

TEST_F(GltfExtrasView, ACameraSaysWhatSceneFilesSay) {
  GltfBuilder builder = street();
  say(builder, "/cameras/0", {{"velocity", {0.6, 0, 0}}, {"time", 2}, {"look_at", {0, 1, 0}}});
  say(builder, "/scenes/0", {{"camera", {{"fov", 90}, {"aperture", 0.5}, {"focus", 3}}}});
  const Scene scene = load(builder);
  EXPECT_EQ(path_of(scene).reference.x, Vec3(0, 0, 9));
  EXPECT_EQ(path_of(scene).reference.t, 2);
  EXPECT_NEAR(glm::distance(path_of(scene).velocity.gamma_beta(), fast), 0, 1e-15);
  EXPECT_EQ(std::get<AimPoint>(scene.camera.aim).point, Vec3(0, 1, 0));
  EXPECT_DOUBLE_EQ(scene.camera.vertical_fov, std::numbers::pi / 2);
  EXPECT_EQ(scene.camera.aperture, 0.5);
}

TEST_F(GltfExtrasView, ACameraBelowAMovingNodeRides) {
  GltfBuilder builder = street();
  builder.json["nodes"][1]["children"] = {2, 4};
  builder.json["scenes"][0]["nodes"] = {0, 1, 3};
  say(builder, "/nodes/1", {{"velocity", {0.6, 0, 0}}, {"time", 4}});
  const Scene scene = load(builder);
  // The tram's rest frame is where the camera rests, 9 ahead of the tram's origin across its motion:
  // its clock agrees with the tram's.
  EXPECT_NEAR(glm::distance(path_of(scene).reference.x, Vec3(1, 2, 12)), 0, 1e-12);
  EXPECT_NEAR(path_of(scene).reference.t, 4, 1e-12);
  EXPECT_NEAR(glm::distance(path_of(scene).velocity.gamma_beta(), fast), 0, 1e-15);
}

TEST_F(GltfExtrasView, TheSceneMayNameItsCamera) {
  GltfBuilder builder = street();
  builder.json["cameras"].push_back(
      {{"type", "perspective"}, {"name", "Tele"}, {"perspective", {{"yfov", 0.1}}}});
  builder.json["nodes"].push_back({{"name", "far"}, {"camera", 1}});
  builder.json["scenes"][0]["nodes"].push_back(5);
  EXPECT_EQ(load(builder).camera.vertical_fov, 0.5);
  for (const char* name : {"far", "Tele"}) {
    say(builder, "/scenes/0", {{"camera", name}});
    EXPECT_EQ(load(builder).camera.vertical_fov, 0.1);
  }
  say(builder, "/scenes/0", {{"camera", "fat"}});
  EXPECT_THAT(faults(builder), ElementsAre("street.glb:/scenes/0/extras/restframe/camera: there is "
                                           "no camera \"fat\", the nearest is \"far\""));
}

TEST_F(GltfExtrasView, WithoutACameraTheTableIsASceneFiles) {
  GltfBuilder builder = street();
  builder.json["nodes"][4].erase("camera");
  EXPECT_FALSE(load(builder).camera_given);
  say(builder, "/scenes/0", "[camera]\nposition = [1, 2, 3]");
  EXPECT_EQ(path_of(load(builder)).reference.x, Vec3(1, 2, 3));
}

TEST_F(GltfExtrasView, LightsAreTheScenes) {
  GltfBuilder builder = street();
  const Scene scene = load(builder);
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].name, "lamp");
  EXPECT_EQ(scene.lights[0].kind, LightKind::point);
  EXPECT_EQ(scene.lights[0].worldline.reference.x, Vec3(0, 5, 0));
  EXPECT_EQ(scene.lights[0].intensity.value, 2);  // 1366 cd
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_EQ(without_folder(warnings_[0]),
            "street.glb:/extensions/KHR_lights_punctual: lights are used by integrator = \"path\" "
            "only, see [render]");
}

TEST_F(GltfExtrasView, ALightSaysWhatSceneFilesSay) {
  GltfBuilder builder = street();
  say(builder, street_lamp,
      {{"gamma", 1.25},
       {"motion", {1, 0, 0}},
       {"clock", 3},
       {"group", "key"},
       {"type", "spot"},
       {"direction", {0, -2, 0}},
       {"cone", {10, 20}},
       {"intensity", {{"formula", "1 + t"}}}});
  const Scene scene = load(builder);
  const Light& light = scene.lights.at(0);
  EXPECT_EQ(light.kind, LightKind::spot);
  EXPECT_EQ(light.worldline.reference.x, Vec3(0, 5, 0));
  EXPECT_NEAR(glm::distance(light.worldline.velocity.gamma_beta(), fast), 0, 1e-15);
  EXPECT_EQ(light.clock, 3);
  EXPECT_EQ(light.group, "key");
  EXPECT_EQ(light.direction, Vec3(0, -1, 0));
  EXPECT_DOUBLE_EQ(light.outer_cone, std::numbers::pi / 9);
  EXPECT_EQ(light.intensity.function, 0);
}

TEST_F(GltfExtrasView, ALightBelowAMovingNodeRides) {
  GltfBuilder builder = street();
  builder.json["nodes"][1]["children"] = {2, 3};
  builder.json["scenes"][0]["nodes"] = {0, 1, 4};
  say(builder, "/nodes/1", {{"velocity", {0.6, 0, 0}}, {"clock", 8}});
  const Scene scene = load(builder);
  const Light& light = scene.lights.at(0);
  EXPECT_NEAR(glm::distance(light.worldline.reference.x, Vec3(1, 7, 3)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(light.worldline.velocity.gamma_beta(), fast), 0, 1e-15);
  EXPECT_EQ(light.clock, 8);
  say(builder, street_lamp, {{"velocity", {0.1, 0, 0}}});
  EXPECT_THAT(faults(builder),
              ElementsAre("street.glb:/extensions/KHR_lights_punctual/lights/0/extras/restframe/"
                          "velocity: light \"lamp\": velocity goes with a light at rest only: this "
                          "one is carried by a node or object that has a motion"));
}

// Turned by 90 degrees about y, x goes to -z.
TEST_F(GltfExtrasView, InASceneFileALightsMotionTurnsWithItsObject) {
  GltfBuilder builder = street();
  say(builder, street_lamp,
      {{"velocity", {0.6, 0, 0}}, {"time", 1}, {"type", "spot"}, {"direction", {1, 0, 0}}});
  folder_.write("street.glb", builder.glb());
  const Scene scene = load_toml(
      "[[object]]\nname = 'city'\nasset = 'street.glb'\nposition = [10, 0, 0]\ntime = 2\n"
      "rotation = [0, 90, 0]\nscale = 3\n");
  const Light& light = scene.lights.at(0);
  EXPECT_EQ(light.name, "city/lamp");
  EXPECT_NEAR(glm::distance(light.worldline.reference.x, Vec3(10, 15, 0)), 0, 1e-12);
  EXPECT_EQ(light.worldline.reference.t, 3);
  EXPECT_NEAR(glm::distance(light.worldline.velocity.gamma_beta(), Vec3(0, 0, -0.75)), 0, 1e-15);
  EXPECT_NEAR(glm::distance(light.direction, Vec3(0, 0, -1)), 0, 1e-15);
  EXPECT_THAT(
      faults_of([&] {
        load_toml("[[object]]\nname = 'city'\nasset = 'street.glb'\nvelocity = [0, 0, 0.5]\n");
      }),
      ::testing::SizeIs(2));
}

TEST_F(GltfExtrasView, ALightAtTwoNodesIsTwoLights) {
  GltfBuilder builder = street();
  builder.json["nodes"][0]["extensions"] = builder.json["nodes"][3]["extensions"];
  builder.json["nodes"][0]["name"] = "lamp";
  const Scene scene = load(builder);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].worldline.reference.x, Vec3(0));
  EXPECT_EQ(scene.lights[1].name, "lamp_2");
}

}  // namespace
}  // namespace restframe
