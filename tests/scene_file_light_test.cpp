// Lights, glass and the integrator in scene files: what they mean, and what is wrong with them.

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/expect_near.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string path_and_ball =
    "[render]\nintegrator = \"path\"\n[[object]]\nname = \"ball\"\nsphere = {fineness = 0}\n";

class SceneFileLight : public SceneReading {
 protected:
  Scene read_light(const std::string& keys) { return read(path_and_ball + "[[light]]\n" + keys); }

  // One fault that begins at line 6 + `line` with all of the words.
  void expect_fault(const std::string& keys, const std::vector<std::string>& words) {
    const std::vector<std::string> lines = faults(path_and_ball + "[[light]]\n" + keys);
    ASSERT_THAT(lines, SizeIs(1)) << keys;
    EXPECT_THAT(lines[0], ::testing::StartsWith(words.at(0))) << keys;
    for (const std::string& word : words) EXPECT_THAT(lines[0], HasSubstr(word)) << keys;
  }
};

TEST_F(SceneFileLight, PointHasDefaults) {
  const Scene scene = read_light("type = \"point\"\n");
  ASSERT_EQ(scene.lights.size(), 1U);
  const Light& light = scene.lights[0];
  EXPECT_EQ(light.name, "light_1");
  EXPECT_EQ(light.kind, LightKind::point);
  EXPECT_EQ(light.worldline.reference.x, Vec3(0));
  EXPECT_EQ(light.worldline.reference.t, 0);
  EXPECT_EQ(light.worldline.velocity, Velocity());
  EXPECT_EQ(light.clock, 0);
  EXPECT_FALSE(light.frame_clock);
  EXPECT_FALSE(light.sweep);
  EXPECT_EQ(light.color.value, Vec3f(1));
  EXPECT_EQ(light.intensity.value, 1);
  EXPECT_EQ(light.group, "");
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(SceneFileLight, SpotReadsEveryKeyInSceneLengths) {
  const Scene scene = read("[scene]\nlight_speed = 2\n" + path_and_ball + R"([[light]]
name = "lamp"
type = "spot"
position = [2, 4, 6]
time = 3
velocity = [0, 0.6, 0]
clock = 7
direction = [0, 0, -5]
cone = [20, 90]
color = [0.5, 0.25, 2.0]
intensity = 12.5
sweep = {axis = [0, 2, 0], period = 0.033}
group = "key_2"
)");
  const Light& light = scene.lights.at(0);
  EXPECT_EQ(light.name, "lamp");
  EXPECT_EQ(light.kind, LightKind::spot);
  expect_near(light.worldline.reference.x, {1, 2, 3});
  EXPECT_EQ(light.worldline.reference.t, 3);
  expect_near(light.worldline.velocity.beta(), {0, 0.6, 0});
  EXPECT_EQ(light.clock, 7);
  expect_near(light.direction, {0, 0, -1});
  EXPECT_NEAR(light.inner_cone, std::numbers::pi / 9, 1e-12);
  EXPECT_NEAR(light.outer_cone, std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(light.color.value, Vec3f(0.5F, 0.25F, 2.0F));
  EXPECT_EQ(light.intensity.value, 12.5F);  // W/sr: not lengths of light
  ASSERT_TRUE(light.sweep);
  expect_near(light.sweep->axis, {0, 1, 0});
  EXPECT_EQ(light.sweep->period, 0.033);
  EXPECT_EQ(light.group, "key_2");
}

TEST_F(SceneFileLight, SunAndEnvironmentMayMove) {
  const Scene scene = read(path_and_ball + R"([[light]]
type = "sun"
direction = [3, -4, 0]
gamma = 5
motion = [0, 0, -2]
clock = "frame"
[[light]]
type = "environment"
color = "#ff0000"
velocity = [0.5, 0, 0]
time = 2
)");
  ASSERT_EQ(scene.lights.size(), 2U);
  const Light& sun = scene.lights[0];
  EXPECT_EQ(sun.kind, LightKind::sun);
  expect_near(sun.direction, {0.6, -0.8, 0});
  EXPECT_NEAR(sun.worldline.velocity.gamma(), 5, 1e-12);
  expect_near(sun.worldline.velocity.gamma_beta(), {0, 0, -std::sqrt(24.0)});
  EXPECT_TRUE(sun.frame_clock);
  const Light& sky = scene.lights[1];
  EXPECT_EQ(sky.name, "light_2");
  EXPECT_EQ(sky.kind, LightKind::environment);
  EXPECT_EQ(sky.color.value, Vec3f(1, 0, 0));
  expect_near(sky.worldline.velocity.beta(), {0.5, 0, 0});
  EXPECT_EQ(sky.worldline.reference.t, 2);
}

TEST_F(SceneFileLight, ColourAndIntensityChangeOverItsClock) {
  const Scene scene = read_light(R"(type = "point"
intensity = {period = 1, intervals = [[0, 0.1, 100]]}
color = {keys = [[0, "black"], [1, "white"]]}
)");
  const Light& light = scene.lights.at(0);
  const auto& color = scene.functions.at(static_cast<std::size_t>(light.color.function));
  const auto& intensity = scene.functions.at(static_cast<std::size_t>(light.intensity.function));
  EXPECT_EQ(std::get<KeyFunction>(color).keys.size(), 2U);
  EXPECT_EQ(std::get<IntervalFunction>(intensity).intervals.at(0).value.x, 100);
  EXPECT_EQ(light.intensity.value, 0);  // off in the gap
  EXPECT_THAT(scene.function_places.at(0), HasSubstr("light \"light_1\": color"));
}

// The ship, turned by 90 degrees about y, flies at 0.8c (gamma 5/3) along x; where it is at time 2
// its clock shows 7. A lamp is at [0, 0, 0.6] of its asset, which is placed 10 times as large: z
// turned to x, and 2 lengths a light-second, that is 3 in front of its origin in its own frame. In
// the world the lamp shows 7 gamma * 3 ahead, and gamma * 0.8 * 3 later.
TEST_F(SceneFileLight, RidesOnAnObject) {
  const Scene scene = read(R"([scene]
light_speed = 2
[render]
integrator = "path"
[[object]]
name = "ship"
sphere = {fineness = 0}
position = [2, 0, 0]
time = 2
clock = 7
velocity = [0.8, 0, 0]
rotation = [0, 90, 0]
scale = 10
[[light]]
type = "spot"
on = "ship"
position = [0, 0, 0.6]
direction = [0, 0, 1]
sweep = {axis = [1, 0, 0], period = 2}
)");
  const Light& light = scene.lights.at(0);
  expect_near(light.worldline.reference.x, {1 + 3 * 5.0 / 3, 0, 0});
  EXPECT_NEAR(light.worldline.reference.t, 2 + 0.8 * 3 * 5.0 / 3, 1e-12);
  EXPECT_EQ(light.worldline.velocity, scene.objects[0].worldline.velocity);
  EXPECT_EQ(light.clock, 7);
  EXPECT_FALSE(light.frame_clock);
  expect_near(light.direction, {1, 0, 0});
  expect_near(light.sweep->axis, {0, 0, -1});
}

TEST_F(SceneFileLight, RidesOnAnObjectWithTheFramesClock) {
  const Scene scene = read(path_and_ball + R"(clock = "frame"
velocity = [0, 0, 0.6]
[[light]]
type = "point"
on = "ball"
)");
  const Light& light = scene.lights.at(0);
  EXPECT_TRUE(light.frame_clock);
  expect_near(light.worldline.reference.x, {0, 0, 0});
}

TEST_F(SceneFileLight, PreviewSaysThatItDoesNotUseThem) {
  read("[[object]]\nsphere = {fineness = 0}\n[[light]]\ntype = \"point\"\n");
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_THAT(warnings[0],
              HasSubstr("scene.toml:3:1: lights are used by integrator = \"path\" only"));
}

TEST_F(SceneFileLight, KeysOfOtherTypes) {
  expect_fault("type = \"point\"\ncone = [10, 20]\n",
               {"8:1: ", "light \"light_1\"", "cone goes with a spot, not with type = \"point\""});
  expect_fault("type = \"sun\"\ncone = [10, 20]\n", {"8:1: ", "cone goes with a spot"});
  expect_fault("type = \"point\"\ndirection = [1, 0, 0]\n",
               {"8:1: ", "direction goes with a spot or sun"});
  expect_fault("type = \"point\"\nsweep = {period = 1}\n",
               {"8:1: ", "sweep goes with a spot, not"});
  expect_fault("type = \"sun\"\nsweep = {period = 1}\n", {"8:1: ", "sweep goes with a spot, not"});
  expect_fault(
      "type = \"environment\"\nposition = [1, 0, 0]\n",
      {"8:1: ", "position goes with a point, spot or sun, not with type = \"environment\""});
  expect_fault("type = \"environment\"\ndirection = [1, 0, 0]\n", {"8:1: ", "direction"});
}

TEST_F(SceneFileLight, WrongValues) {
  expect_fault("intensity = 1\n", {"6:1: ", "type is missing, must be one of point, spot, sun"});
  expect_fault("type = \"spto\"\n", {"7:8: ", "must be one of", "the nearest is \"spot\""});
  expect_fault("type = 3\n", {"7:8: ", "must be a text"});
  expect_fault("type = \"point\"\nintensty = 1\n", {"8:1: ", "\"intensty\"", "\"intensity\""});
  expect_fault("type = \"point\"\nintensity = -1\n",
               {"8:13: ", "intensity is -1, must be at least 0"});
  expect_fault("type = \"point\"\nintensity = 1e39\n", {"8:13: ", "too large"});
  expect_fault("type = \"point\"\nintensity = nan\n", {"8:13: ", "finite"});
  expect_fault("type = \"point\"\ncolor = \"yelow\"\n", {"8:9: ", "\"yellow\""});
  expect_fault("type = \"point\"\ncolor = [1, -1, 0]\n", {"8:13: ", "color[1] is -1"});
  expect_fault("type = \"point\"\ngroup = \"a b\"\n",
               {"8:9: ", "up to 64 letters, digits, _ and -"});
  expect_fault("type = \"point\"\nposition = [1, 0]\n", {"8:12: ", "2 elements"});
  expect_fault("type = \"point\"\nclock = \"fram\"\n", {"8:9: ", "\"frame\""});
  expect_fault("type = \"point\"\nvelocity = [0, 1, 0]\n", {"8:12: ", "|velocity| is 1"});
  expect_fault("type = \"spot\"\ndirection = [0, 0, 0]\n", {"8:13: ", "must point somewhere"});
}

TEST_F(SceneFileLight, WrongMotions) {
  expect_fault("type = \"sun\"\ngamma = 2\n", {"8:1: ", "gamma and motion go together"});
  expect_fault("type = \"sun\"\nmotion = [1, 0, 0]\n", {"8:1: ", "gamma and motion go together"});
  expect_fault("type = \"sun\"\nvelocity = [0, 0, 0]\ngamma = 2\nmotion = [1, 0, 0]\n",
               {"9:1: ", "velocity and gamma exclude each other"});
  expect_fault("type = \"sun\"\ngamma = 0.5\nmotion = [1, 0, 0]\n", {"8:9: ", "from 1 to"});
}

TEST_F(SceneFileLight, WrongCones) {
  expect_fault("type = \"spot\"\ncone = 30\n", {"8:8: ", "[inner, outer]"});
  expect_fault("type = \"spot\"\ncone = [1, 2, 3]\n", {"8:8: ", "[inner, outer]"});
  expect_fault("type = \"spot\"\ncone = [30, 20]\n",
               {"8:8: ", "cone is [30, 20]", "at most the outer"});
  expect_fault("type = \"spot\"\ncone = [-1, 20]\n", {"8:9: ", "inner angle is -1"});
  expect_fault("type = \"spot\"\ncone = [0, 0]\n", {"8:12: ", "outer angle is 0, must be above 0"});
  expect_fault("type = \"spot\"\ncone = [0, 91]\n", {"8:12: ", "outer angle is 91"});
}

TEST_F(SceneFileLight, WrongSweeps) {
  expect_fault("type = \"spot\"\nsweep = 1\n", {"8:9: ", "must be a table"});
  expect_fault("type = \"spot\"\nsweep = {}\n", {"8:9: ", "sweep: period is missing"});
  expect_fault("type = \"spot\"\nsweep = {period = 0}\n",
               {"8:19: ", "period is 0, must be above 0"});
  expect_fault("type = \"spot\"\nsweep = {period = 1, axis = [0, 0, 0]}\n",
               {"8:29: ", "somewhere"});
  expect_fault("type = \"spot\"\nsweep = {perod = 1, period = 1}\n", {"8:10: ", "\"perod\""});
}

TEST_F(SceneFileLight, WrongRides) {
  expect_fault("type = \"point\"\non = \"bal\"\n",
               {"8:6: ", "no object \"bal\"", "nearest is \"ball\""});
  for (const char* key : {"velocity = [0, 0, 0]", "time = 0", "clock = 0", "clock = \"frame\""}) {
    expect_fault(std::string("type = \"point\"\non = \"ball\"\n") + key + "\n",
                 {"9:1: ", "exclude each other: the light has the object's"});
  }
}

TEST_F(SceneFileLight, NamesAreUnique) {
  EXPECT_THAT(faults(path_and_ball + "[[light]]\ntype = \"point\"\nname = \"a\"\n"
                                     "[[light]]\nname = \"a\"\ntype = \"sun\"\n"),
              ElementsAre(HasSubstr("10:8: two lights have the name \"a\"")));
}

TEST_F(SceneFileLight, NoTables) {
  EXPECT_THAT(faults(path_and_ball + "[light]\ntype = \"point\"\n"),
              ElementsAre(HasSubstr("[[light]]")));
}

TEST_F(SceneFileLight, IntegratorAndDepth) {
  const Scene scene = read_light("type = \"sun\"\n");
  EXPECT_EQ(scene.render.integrator, IntegratorKind::path);
  EXPECT_EQ(scene.render.depth, 8);
  const Scene plain = read("[render]\ndepth = 64\n[[object]]\nsphere = {fineness = 0}\n");
  EXPECT_EQ(plain.render.integrator, IntegratorKind::preview);
  EXPECT_EQ(plain.render.depth, 64);
}

TEST_F(SceneFileLight, GlassKeys) {
  const Scene scene = read(path_and_ball + R"([[material]]
name = "ball"
ior = {keys = [[0, 1.0], [1, 2.4]]}
transmission = 0.75
attenuation_color = [0.5, 1, 0.25]
attenuation_distance = 3
)");
  const Material& glass = scene.materials.at(0);
  EXPECT_EQ(std::get<KeyFunction>(scene.functions.at(0)).keys.at(1).value.x, 2.4F);
  EXPECT_EQ(glass.ior.function, 0);
  EXPECT_EQ(glass.ior.value, 1.5F);
  EXPECT_EQ(glass.transmission.value, 0.75F);
  EXPECT_EQ(glass.attenuation_color.value, Vec3f(0.5F, 1, 0.25F));
  EXPECT_EQ(glass.attenuation_distance.value, 3);  // scene lengths
}

TEST_F(SceneFileLight, WrongGlass) {
  const auto fault = [&](const std::string& key, const std::string& words) {
    EXPECT_THAT(faults(path_and_ball + "[[material]]\nname = \"ball\"\n" + key + "\n"),
                ElementsAre(::testing::AllOf(::testing::StartsWith("8:"), HasSubstr(words))))
        << key;
  };
  fault("ior = 0.9", "ior is 0.9, must be at least 1");
  fault("ior = {keys = [[0, 0.5]]}", "at least 1");
  fault("transmission = 1.5", "transmission is 1.5, must be from 0 to 1");
  fault("transmission = \"red\"", "must be a number");
  fault("attenuation_color = [0, 0, 2]", "attenuation_color[2] is 2, must be from 0 to 1");
  fault("attenuation_distance = -1", "attenuation_distance is -1, must be at least 0");
  fault("attenuation_distance = inf", "finite");
}

}  // namespace
}  // namespace restframe
