// What a scene file means, in the scene's terms.

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SceneFile : public SceneReading {
 protected:
  // The material on the slot of that name of the object's asset, as long as the slots of the
  // generated lattice and ball are those that their header states.
  static const Material& slot(const Scene& scene, std::size_t object, std::size_t index) {
    return scene.materials.at(
        static_cast<std::size_t>(scene.objects.at(object).materials.at(index)));
  }
};

const std::string sphere = "[[object]]\nname = \"ball\"\nsphere = {fineness = 1}\n";
const std::string lattice =
    "[[object]]\nname = \"lattice\"\n"
    "lattice = {cells = [2, 2, 2], pitch = 1, ball = 0.15, rod = 0.05, fineness = 0}\n";
constexpr std::size_t balls = 0, rods = 1;

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(glm::length(a - b), 0, 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST_F(SceneFile, ReadsEverySection) {
  const Scene scene = read(R"(
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
)");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(scene.light_speed, 2);
  EXPECT_TRUE(scene.camera_given);
  expect_near(std::get<Worldline>(scene.camera.motion).reference.x, Vec3(0.15, 0, 2));
  EXPECT_EQ(std::get<Worldline>(scene.camera.motion).reference.t, 1.5);
  expect_near(std::get<Worldline>(scene.camera.motion).velocity.gamma_beta(), Vec3(0, 0, 0.75));
  expect_near(std::get<AimPoint>(scene.camera.aim).point, Vec3(0, 1, 0));
  expect_near(scene.camera.up, Vec3(0, 1, 0));
  EXPECT_NEAR(scene.camera.vertical_fov, std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(scene.animation.rate, 10);
  EXPECT_EQ(scene.animation.start, -0.5);
  EXPECT_EQ(scene.animation.pictures, 5);
  EXPECT_EQ(scene.render.width, 640);
  EXPECT_EQ(scene.render.height, 360);
  EXPECT_EQ(scene.render.samples, 4);
  EXPECT_EQ(scene.render.noise, 0.02);
  EXPECT_TRUE(scene.render.beaming);
  EXPECT_EQ(scene.render.seed, 7U);
  EXPECT_EQ(scene.output.path, "out/lattice.####.exr");
  EXPECT_THAT(scene.output.layers,
              ElementsAre(Layer::beauty, Layer::z, Layer::time, Layer::doppler, Layer::normal,
                          Layer::position, Layer::uv, Layer::id));
  EXPECT_EQ(scene.output.compression, Compression::dwab);
  EXPECT_EQ(scene.output.compression_level, 60);
  EXPECT_TRUE(scene.output.split);
  EXPECT_THAT(scene.output.half_layers, ElementsAre(Layer::z, Layer::normal));
  EXPECT_THAT(scene.output.float_layers, ElementsAre(Layer::beauty));
  EXPECT_EQ(scene.render.overscan, 8);
  EXPECT_EQ(scene.render.crop, (PixelWindow{-8, 0, 100, 360}));
  EXPECT_FALSE(scene.output.preview);
  EXPECT_EQ(scene.output.exposure, -1.5);
  EXPECT_EQ(scene.output.view, ViewTransform::filmic);
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
  const Scene scene = read(sphere);
  EXPECT_FALSE(scene.camera_given);
  EXPECT_EQ(scene.light_speed, 1);
  EXPECT_EQ(scene.animation.pictures, 1);
  EXPECT_EQ(scene.render.width, 1280);
  EXPECT_EQ(scene.objects[0].worldline.reference.t, 0);
  expect_near(scene.objects[0].worldline.velocity.gamma_beta(), Vec3(0));
}

TEST_F(SceneFile, ObjectsWithoutNamesAreNumbered) {
  const Scene scene = read(sphere + "[[object]]\nsphere = {}\n");
  EXPECT_EQ(scene.objects.at(1).name, "object_2");
}

TEST_F(SceneFile, GammaAndDirectionStandInForAVelocity) {
  const Scene scene = read(sphere + "gamma = 1000\ndirection = [0, 3, 4]\n");
  const double gamma_beta = std::sqrt(999.0 * 1001.0);
  expect_near(scene.objects[0].worldline.velocity.gamma_beta() / gamma_beta, Vec3(0, 0.6, 0.8));
  EXPECT_NEAR(scene.objects[0].worldline.velocity.gamma(), 1000, 1e-9);
}

TEST_F(SceneFile, AClockMayBeTheFrames) {
  EXPECT_TRUE(read(sphere + "clock = \"frame\"\n").objects[0].frame_clock);
}

TEST_F(SceneFile, RotatesAboutFixedAxesXFirst) {
  // x by 90 degrees takes y to z, z by 90 degrees then takes x to y and leaves z.
  const Scene scene =
      read("[scene]\nlight_speed = 2\n" + sphere + "rotation = [90, 0, 90]\nscale = 6\n");
  const Mat4& placed = scene.objects[0].parts.at(0).object_from_mesh;
  expect_near(Vec3(placed * glm::dvec4(1, 0, 0, 0)), Vec3(0, 3, 0));
  expect_near(Vec3(placed * glm::dvec4(0, 1, 0, 0)), Vec3(0, 0, 3));
  expect_near(Vec3(placed * glm::dvec4(0, 0, 1, 0)), Vec3(3, 0, 0));
  expect_near(Vec3(placed * glm::dvec4(0, 0, 0, 1)), Vec3(0));
}

TEST_F(SceneFile, CameraLooksAlongADirectionMadeUnitLength) {
  const Scene scene = read("[camera]\nposition = [1, 2, 3]\ndirection = [0, 0, -9]\n" + sphere);
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

TEST_F(SceneFile, MaterialsChangeThoseOfAssets) {
  const Scene scene = read(lattice + R"(
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

TEST_F(SceneFile, PatternsChangeSeveralMaterialsLaterOnesLast) {
  const Scene scene = read(lattice +
                           "[[material]]\nname = \"*s\"\nbase_color = \"red\"\nroughness = 0\n"
                           "[[material]]\nname = \"ro*\"\nbase_color = \"blue\"\n");
  EXPECT_EQ(slot(scene, 0, balls).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 0, rods).base_color.value, Vec3f(0, 0, 1));
  EXPECT_EQ(slot(scene, 0, rods).roughness.value, 0);
}

TEST_F(SceneFile, MaterialsOfOneObjectLeaveTheOthersAlone) {
  const std::string one = "[[object]]\nname = \"one\"\nsphere = {}\n";
  const std::string two = "[[object]]\nname = \"two\"\nsphere = {}\n";
  const Scene scene =
      read(one + two + "[[material]]\nname = \"ball\"\nobject = \"two\"\nbase_color = \"red\"\n");
  EXPECT_NE(slot(scene, 0, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 1, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 1, 0).name, "ball");
  EXPECT_EQ(scene.meshes.size(), 1U);
}

TEST_F(SceneFile, NewMaterialsReplaceAllSlotsOrOneByOne) {
  const std::string gold = "[[material]]\nname = \"gold\"\nbase_color = \"gold\"\n";
  const Scene all = read(lattice + "material = \"gold\"\n" + gold);
  EXPECT_EQ(slot(all, 0, balls).name, "gold");
  EXPECT_EQ(all.objects[0].materials.at(balls), all.objects[0].materials.at(rods));
  EXPECT_EQ(slot(all, 0, balls).metallic.value, 1) << "glTF's default";
  const Scene one = read(lattice + "materials = {balls = \"gold\"}\n" + gold);
  EXPECT_EQ(slot(one, 0, balls).name, "gold");
  EXPECT_EQ(slot(one, 0, rods).name, "rods");
  const Scene both = read(lattice + "material = \"gold\"\nmaterials = {balls = \"rods\"}\n" + gold);
  EXPECT_EQ(slot(both, 0, balls).name, "rods");
  EXPECT_EQ(slot(both, 0, rods).name, "gold");
}

TEST_F(SceneFile, AnObjectMayUseItsOwnOrAnothersAssetMaterial) {
  const Scene scene = read(lattice + "material = \"rods\"\n" + sphere + "material = \"balls\"\n" +
                           "[[material]]\nname = \"rods\"\nbase_color = \"red\"\n");
  EXPECT_EQ(slot(scene, 0, balls).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 1, 0).name, "balls");
}

TEST_F(SceneFile, ANewMaterialMayDifferOnOneObject) {
  const Scene scene =
      read(sphere + "material = \"gold\"\n" + lattice + "material = \"gold\"\n" + R"(
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

TEST_F(SceneFile, AMaterialThatShowsNowhereIsWarnedOf) {
  read(lattice + "materials = {balls = \"rods\"}\n[[material]]\nname = \"balls\"\nunlit = true\n");
  EXPECT_THAT(warnings,
              ElementsAre(HasSubstr("scene.toml:6:8: material \"balls\" is on no object")));
}

TEST_F(SceneFile, OpacityMakesMaterialsBlend) {
  const auto mode = [&](const std::string& opacity) {
    return slot(read(sphere + "[[material]]\nname = \"ball\"\nopacity = " + opacity), 0, 0)
        .alpha_mode;
  };
  EXPECT_EQ(mode("1"), AlphaMode::opaque);
  EXPECT_EQ(mode("0.5"), AlphaMode::blend);
  EXPECT_EQ(mode("{formula = \"abs(sin(t))\"}"), AlphaMode::blend);
}

TEST_F(SceneFile, PropertiesMayBeFunctionsOfTheClock) {
  folder.write("blink.txt", "% period 1.0\n% interval 0 0.5 Yellow\n");
  const Scene scene = read(lattice + R"toml(
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

TEST_F(SceneFile, AFunctionLeavesTheAssetsOwnValueForItsGaps) {
  const Scene scene =
      read(sphere +
           "[[material]]\nname = \"ball\"\nbase_color = \"red\"\n"
           "[[material]]\nname = \"ball\"\nbase_color = {intervals = [[0, 1, \"blue\"]]}\n");
  EXPECT_EQ(slot(scene, 0, 0).base_color.value, Vec3f(1, 0, 0));
  EXPECT_EQ(slot(scene, 0, 0).base_color.function, 0);
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
