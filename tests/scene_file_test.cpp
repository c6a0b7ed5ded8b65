// What a scene file means, in the scene's terms: its settings, its camera and where its objects are.

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/expect_near.h"
#include "support/surface_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using SceneFile = SceneReading;

// A file with every section and key.
const char* const every_section = R"(
[scene]
light_speed = 2.0
[camera]
position = [0.3, 0.0, 4.0]
time     = 1.5
velocity = [0, 0, 0.6]
look_at  = [0, 2, 0]
up       = [0, 2, 0]
fov      = 90
aperture = 0.0
rolling  = 0
[animation]
rate = 10
start = -0.5
pictures = 5
[exposure]
shutter = 0.0
count = 1
interval = 0.5
combine = "sum"
[render]
resolution = [640, 360]
samples = 4
noise = 0.02
overscan = 8
crop = [-8, 0, 100, 360]
integrator = "preview"
doppler = false
beaming = true
seed = 7
[output]
path = "out/lattice.####.exr"
layers = ["beauty", "Z", "time", "doppler", "N", "P", "UV", "id"]
compression = "dwab"
compression_level = 60
split = true
half = ["Z", "N"]
float = ["beauty"]
preview = false
exposure = -1.5
view = "filmic"
[[object]]
name = "lattice"
lattice = {cells = [2, 3, 4], pitch = 1, ball = 0.2, rod = 0.05, fineness = 1, instances = "none"}
position = [0, 0, -12]
time = 3.0
clock = 0.25
velocity = [0, 0, 0.99]
rotation = [0, 90, 0]
scale = 4.0
)";

class EverySection : public SceneReading {
 protected:
  const Scene scene = read(every_section);
};

TEST_F(EverySection, HasTheCamera) {
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(scene.light_speed, 2);
  EXPECT_TRUE(scene.camera_given);
  expect_near(std::get<Worldline>(scene.camera.motion).reference.x, Vec3(0.15, 0, 2));
  EXPECT_EQ(std::get<Worldline>(scene.camera.motion).reference.t, 1.5);
  expect_near(std::get<Worldline>(scene.camera.motion).velocity.gamma_beta(), Vec3(0, 0, 0.75));
  expect_near(std::get<AimPoint>(scene.camera.aim).point, Vec3(0, 1, 0));
  expect_near(scene.camera.up, Vec3(0, 1, 0));
  EXPECT_NEAR(scene.camera.vertical_fov, std::numbers::pi / 2, 1e-15);
}

TEST_F(EverySection, HasWhatIsRendered) {
  EXPECT_EQ(scene.animation.rate, 10);
  EXPECT_EQ(scene.animation.start, -0.5);
  EXPECT_EQ(scene.animation.pictures, 5);
  EXPECT_EQ(scene.render.width, 640);
  EXPECT_EQ(scene.render.height, 360);
  EXPECT_EQ(scene.render.samples, 4);
  EXPECT_EQ(scene.render.noise, 0.02);
  EXPECT_TRUE(scene.render.beaming);
  EXPECT_EQ(scene.render.seed, 7U);
  EXPECT_EQ(scene.render.overscan, 8);
  EXPECT_EQ(scene.render.crop, (PixelWindow{-8, 0, 100, 360}));
}

TEST_F(EverySection, HasTheOutput) {
  EXPECT_EQ(scene.output.path, "out/lattice.####.exr");
  EXPECT_THAT(scene.output.layers,
              ElementsAre(Layer::beauty, Layer::z, Layer::time, Layer::doppler, Layer::normal,
                          Layer::position, Layer::uv, Layer::id));
  EXPECT_EQ(scene.output.compression, Compression::dwab);
  EXPECT_EQ(scene.output.compression_level, 60);
  EXPECT_TRUE(scene.output.split);
  EXPECT_THAT(scene.output.half_layers, ElementsAre(Layer::z, Layer::normal));
  EXPECT_THAT(scene.output.float_layers, ElementsAre(Layer::beauty));
  EXPECT_FALSE(scene.output.preview);
  EXPECT_EQ(scene.output.exposure, -1.5);
  EXPECT_EQ(scene.output.view, ViewTransform::filmic);
}

TEST_F(EverySection, HasTheObject) {
  ASSERT_EQ(scene.objects.size(), 1U);
  const Object& object = scene.objects[0];
  EXPECT_EQ(object.name, "lattice");
  expect_near(object.worldline.reference.x, Vec3(0, 0, -6));
  EXPECT_EQ(object.worldline.reference.t, 3);
  EXPECT_NEAR(object.worldline.velocity.beta().z, 0.99, 1e-15);
  EXPECT_EQ(object.clock, 0.25);
  EXPECT_FALSE(object.frame_clock);
  EXPECT_FALSE(object.parts.empty());
  EXPECT_EQ(slot(scene, 0, balls).name, "balls");
  EXPECT_EQ(slot(scene, 0, rods).name, "rods");
}

TEST_F(SceneFile, HasDefaults) {
  const Scene scene = read(sphere_text);
  EXPECT_FALSE(scene.camera_given);
  EXPECT_EQ(scene.light_speed, 1);
  EXPECT_EQ(scene.animation.pictures, 1);
  EXPECT_EQ(scene.render.width, 1280);
  EXPECT_EQ(scene.objects[0].worldline.reference.t, 0);
  expect_near(scene.objects[0].worldline.velocity.gamma_beta(), Vec3(0));
}

TEST_F(SceneFile, ObjectsWithoutNamesAreNumbered) {
  const Scene scene = read(sphere_text + "[[object]]\nsphere = {}\n");
  EXPECT_EQ(scene.objects.at(1).name, "object_2");
}

TEST_F(SceneFile, GammaAndDirectionStandInForAVelocity) {
  const Scene scene = read(sphere_text + "gamma = 1000\ndirection = [0, 3, 4]\n");
  const double gamma_beta = std::sqrt(999.0 * 1001.0);
  expect_near(scene.objects[0].worldline.velocity.gamma_beta() / gamma_beta, Vec3(0, 0.6, 0.8));
  EXPECT_NEAR(scene.objects[0].worldline.velocity.gamma(), 1000, 1e-9);
}

TEST_F(SceneFile, AClockMayBeTheFrames) {
  EXPECT_TRUE(read(sphere_text + "clock = \"frame\"\n").objects[0].frame_clock);
}

TEST_F(SceneFile, RotatesAboutFixedAxesXFirst) {
  // x by 90 degrees takes y to z, z by 90 degrees then takes x to y and leaves z.
  const Scene scene =
      read("[scene]\nlight_speed = 2\n" + sphere_text + "rotation = [90, 0, 90]\nscale = 6\n");
  const Mat4& placed = scene.objects[0].parts.at(0).object_from_mesh;
  expect_near(Vec3(placed * glm::dvec4(1, 0, 0, 0)), Vec3(0, 3, 0));
  expect_near(Vec3(placed * glm::dvec4(0, 1, 0, 0)), Vec3(0, 0, 3));
  expect_near(Vec3(placed * glm::dvec4(0, 0, 1, 0)), Vec3(3, 0, 0));
  expect_near(Vec3(placed * glm::dvec4(0, 0, 0, 1)), Vec3(0));
}

TEST_F(SceneFile, CameraLooksAlongADirectionMadeUnitLength) {
  const Scene scene =
      read("[camera]\nposition = [1, 2, 3]\ndirection = [0, 0, -9]\n" + sphere_text);
  expect_near(std::get<AimDirection>(scene.camera.aim).direction, Vec3(0, 0, -1));
  EXPECT_NEAR(scene.camera.vertical_fov, std::numbers::pi / 3, 1e-15);
}

TEST_F(SceneFile, AssetsAreSharedByObjects) {
  const std::string asset = "asset = \"paint.obj\"\n";
  const Scene scene = read("[[object]]\n" + asset + "[[object]]\n" + asset +
                           "[[object]]\nasset = \"./paint.obj\"\n");
  EXPECT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.objects[0].parts.at(0).mesh, scene.objects[2].parts.at(0).mesh);
  EXPECT_EQ(scene.objects[0].materials, scene.objects[1].materials);
}

TEST_F(SceneFile, AnAssetStandsInForAScene) {
  const Scene scene = load_scene(folder.path() / "paint.obj", {}, warnings);
  EXPECT_FALSE(scene.camera_given);
  EXPECT_EQ(scene.output.path, "out/paint.####.exr");
  EXPECT_EQ(scene.animation.pictures, 1);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].name, "paint");
  EXPECT_EQ(slot(scene, 0, 0).name, "paint");
  EXPECT_EQ(scene.sources.at(0).name, "paint.obj");
}

TEST_F(SceneFile, ExtensionsMayBeInUpperCase) {
  folder.write("UPPER.TOML", "[[object]]\nasset = \"UPPER.OBJ\"\n");
  folder.write("UPPER.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(load_scene(folder.path() / "UPPER.TOML", {}, warnings).objects.size(), 1U);
}

}  // namespace
}  // namespace restframe
