// Objects that show some of an asset's nodes, and the lights that come with them.

#include <gmock/gmock.h>

#include "support/gltf_builder.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A street of two trams, each with wheels, a house and a lamp; another scene of a moon. All nodes
// place the one mesh, a triangle; x tells them apart.
GltfBuilder city() {
  GltfBuilder builder = test::one_triangle();
  const auto at = [](const char* name, double x, json more = json::object()) {
    json node = {{"name", name}, {"mesh", 0}, {"translation", {x, 0, 0}}};
    node.update(more);
    return node;
  };
  builder.json["nodes"] = {{{"name", "street"}, {"children", {1, 2, 5, 6}}},
                           at("tram.001", 10, {{"children", {3, 4}}}),
                           at("tram.002", 20),
                           at("wheel", 1),
                           at("wheel", 2),
                           at("house", 30),
                           {{"name", "lamp"},
                            {"translation", {0, 7, 0}},
                            {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
                           at("moon", 40)};
  builder.json["scenes"] = {{{"name", "day"}, {"nodes", {0}}}, {{"name", "night"}, {"nodes", {7}}}};
  builder.json["materials"] = {{{"name", "paint"}}};
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"intensity", 683}, {"spot", json::object()}}};
  return builder;
}

class SceneFileNodes : public SceneReading {
 protected:
  SceneFileNodes() { folder.write("city.glb", city().glb()); }

  // Where the object's parts are, by x.
  static std::vector<double> places(const Object& object) {
    std::vector<double> places;
    for (const PlacedMesh& part : object.parts) places.push_back(part.object_from_mesh[3].x);
    return places;
  }

  std::vector<double> picked(const std::string& keys) {
    return places(read("[[object]]\nasset = \"city.glb\"\n" + keys).objects.at(0));
  }

  // The one fault of an object, whose keys begin in line 4.
  std::string fault(const std::string& keys) {
    const auto lines = faults("[[object]]\nname = \"a\"\nasset = \"city.glb\"\n" + keys);
    EXPECT_THAT(lines, SizeIs(1));
    return lines.empty() ? "" : lines[0];
  }
};

TEST_F(SceneFileNodes, ArePickedWithAllBelowThem) {
  EXPECT_THAT(picked(""), ElementsAre(10, 11, 12, 20, 30));
  EXPECT_THAT(picked("node = \"tram*\""), ElementsAre(10, 11, 12, 20));
  EXPECT_THAT(picked("node = \"tram.002\""), ElementsAre(20));
  EXPECT_THAT(picked("node = [\"house\", \"*eel\"]"), ElementsAre(11, 12, 30));
  EXPECT_THAT(picked("node = [\"tram.001\", \"wheel\"]"), ElementsAre(10, 11, 12));
  EXPECT_THAT(picked("without = \"tram*\""), ElementsAre(30));
  EXPECT_THAT(picked("node = \"street\"\nwithout = [\"wheel\", \"house\"]"), ElementsAre(10, 20));
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(SceneFileNodes, AreOfOneScene) {
  EXPECT_THAT(picked("scene = \"night\""), ElementsAre(40));
  EXPECT_THAT(picked("scene = 1"), ElementsAre(40));
  EXPECT_THAT(picked("scene = 0\nnode = \"house\""), ElementsAre(30));
}

TEST_F(SceneFileNodes, ShareMeshesBetweenObjects) {
  const Scene scene = read(R"([[object]]
name = "rest"
asset = "city.glb"
without = "tram.001"
[[object]]
name = "tram"
asset = "city.glb"
node = "tram.001"
velocity = [0.5, 0, 0]
scale = 2
[[object]]
name = "moon"
asset = "city.glb"
scene = "night"
)");
  EXPECT_EQ(scene.meshes.size(), 1U);
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_THAT(places(scene.objects[0]), ElementsAre(20, 30));
  EXPECT_THAT(places(scene.objects[1]), ElementsAre(20, 22, 24));
  EXPECT_THAT(places(scene.objects[2]), ElementsAre(40));
  EXPECT_EQ(scene.objects[1].worldline.velocity, Velocity::from_beta({0.5, 0, 0}));
}

TEST_F(SceneFileNodes, MeshesThatNobodyPlacesAreDropped) {
  GltfBuilder builder = city();
  builder.json["meshes"].push_back(builder.json["meshes"][0]);
  builder.json["meshes"][1]["name"] = "other";
  builder.json["nodes"][5]["mesh"] = 1;
  folder.write("city.glb", builder.glb());
  const Scene scene = read("[[object]]\nasset = \"city.glb\"\nnode = \"house\"\n");
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.meshes[0].name, "other");
  EXPECT_EQ(scene.objects[0].parts.at(0).mesh, 0);
}

TEST_F(SceneFileNodes, MaterialsChangeOnOneObjectOnly) {
  const Scene scene = read(R"([[object]]
name = "rest"
asset = "city.glb"
[[object]]
name = "tram"
asset = "city.glb"
node = "tram*"
[[material]]
name = "pa*"
object = "tram"
base_color = [0, 1, 0]
)");
  const auto color = [&](std::size_t object) {
    const int material = scene.objects[object].materials.at(0);
    return scene.materials[static_cast<std::size_t>(material)].base_color.value;
  };
  EXPECT_EQ(color(0), Vec3f(1));
  EXPECT_EQ(color(1), Vec3f(0, 1, 0));
}

TEST_F(SceneFileNodes, BadNamesNameTheNearest) {
  EXPECT_EQ(fault("node = \"tarm.001\""),
            "4:8: object \"a\": no node of the asset is called \"tarm.001\", the nearest is "
            "\"tram.001\"");
  EXPECT_EQ(
      fault("node = [\"house\", \"moon\"]"),
      "4:18: object \"a\": no node of the asset is called \"moon\", the nearest is \"house\"");
  EXPECT_EQ(fault("without = \"lamps*\""),
            "4:11: object \"a\": no node of the asset is called \"lamps*\", the nearest is "
            "\"lamp\"");
  EXPECT_EQ(fault("node = []"), "4:8: object \"a\": node is an empty list, name at least one node");
  EXPECT_EQ(fault("node = 3"),
            "4:8: object \"a\": node is a whole number, must be a text in quotes");
  EXPECT_EQ(fault("scene = \"nigth\""),
            "4:9: object \"a\": the asset has no scene \"nigth\", the nearest is \"night\"");
  EXPECT_EQ(fault("scene = 2"), "4:9: object \"a\": scene is 2, must be from 0 to 1");
  EXPECT_EQ(fault("lights = 1"),
            "4:10: object \"a\": lights is a whole number, must be true or false");
}

TEST_F(SceneFileNodes, OfAssetsWithoutScenesAndNames) {
  folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(faults("[[object]]\nasset = \"bare.obj\"\nscene = 0\n"),
              ElementsAre("3:9: object \"object_1\": the asset has no scenes to choose from, leave "
                          "out scene"));
  EXPECT_THAT(
      faults("[[object]]\nasset = \"bare.obj\"\nnode = \"x\"\n"),
      ElementsAre("3:8: object \"object_1\": no node of the asset is called \"x\", its nodes "
                  "have no names"));
  folder.write("groups.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng left\nf 1 2 3\ng right\nf 1 3 2\n");
  const Scene scene = read("[[object]]\nasset = \"groups.obj\"\nnode = \"l*\"\n");
  EXPECT_THAT(scene.objects[0].parts, SizeIs(1));
}

TEST_F(SceneFileNodes, WithoutTrianglesAreWarnedOf) {
  EXPECT_THAT(picked("node = \"lamp\""), IsEmpty());
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_THAT(warnings[0],
              ::testing::EndsWith("scene.toml:1:1: object \"object_1\": the nodes that "
                                  "it picks hold no triangles"));
}

// The lamp hangs 7 above the origin and shines along -z, 683 cd: 1 W/sr. Turned by 90 degrees about
// z its place is (-7, 0, 0), twice as far with the scale; about y its -z becomes -x.
TEST_F(SceneFileNodes, LightsRideTheirObject) {
  const Scene scene = read(R"([scene]
light_speed = 2
[render]
integrator = "path"
[[object]]
name = "tram"
asset = "city.glb"
position = [1, 2, 3]
time = 5
clock = 4
velocity = [0, 0, 0.6]
rotation = [0, 90, 90]
scale = 2
[[light]]
type = "point"
)");
  EXPECT_THAT(warnings, IsEmpty());
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].name, "light_1");
  const Light& lamp = scene.lights[1];
  EXPECT_EQ(lamp.name, "tram/lamp");
  EXPECT_EQ(lamp.kind, LightKind::spot);
  EXPECT_FLOAT_EQ(lamp.intensity.value, 1);
  EXPECT_EQ(lamp.clock, 4);
  EXPECT_EQ(lamp.worldline.velocity, Velocity::from_beta({0, 0, 0.6}));
  // Across the motion lengths are kept, and the clocks agree; light-seconds.
  EXPECT_NEAR(lamp.worldline.reference.t, 5, 1e-12);
  EXPECT_LT(glm::length(lamp.worldline.reference.x - Vec3(0.5 - 7, 1, 1.5)), 1e-12);
  // -z is turned to -x by y, and then to -y by z.
  EXPECT_LT(glm::length(lamp.direction - Vec3(0, -1, 0)), 1e-12);
}

TEST_F(SceneFileNodes, LightsStayOutOnRequestAndWithTheirNodes) {
  const auto count = [&](const std::string& keys) {
    return read("[[object]]\nasset = \"city.glb\"\n" + keys).lights.size();
  };
  EXPECT_EQ(count(""), 1U);
  EXPECT_EQ(count("lights = true"), 1U);
  EXPECT_EQ(count("lights = false"), 0U);
  EXPECT_EQ(count("node = \"tram*\""), 0U);
  EXPECT_EQ(count("without = \"lamp\""), 0U);
  EXPECT_EQ(count("node = \"street\""), 1U);
}

TEST_F(SceneFileNodes, LightsHaveNamesOfTheirOwn) {
  GltfBuilder builder = city();
  builder.json["nodes"][3]["extensions"] = builder.json["nodes"][6]["extensions"];
  builder.json["nodes"][4]["extensions"] = builder.json["nodes"][6]["extensions"];
  builder.json["nodes"][6].erase("name");
  folder.write("city.glb", builder.glb());
  const Scene scene = read("[[object]]\nname = \"a\"\nasset = \"city.glb\"\n");
  ASSERT_EQ(scene.lights.size(), 3U);
  EXPECT_EQ(scene.lights[0].name, "a/wheel");
  EXPECT_EQ(scene.lights[1].name, "a/wheel_2");
  EXPECT_EQ(scene.lights[2].name, "a/node_6");
}

TEST_F(SceneFileNodes, FlattenedLightsAreLeftOut) {
  GltfBuilder builder = city();
  builder.json["nodes"][6]["scale"] = {1, 1, 0};
  folder.write("city.glb", builder.glb());
  EXPECT_THAT(read("[[object]]\nname = \"a\"\nasset = \"city.glb\"\n").lights, IsEmpty());
  EXPECT_THAT(warnings,
              ElementsAre("city.glb:/nodes/6: light \"a/lamp\" is left out: its transform is "
                          "singular"));
}

}  // namespace
}  // namespace restframe
