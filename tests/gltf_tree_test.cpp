// What an asset keeps of a glTF file besides its triangles: nodes, scenes, lights, cameras, extras.

#include <cmath>
#include <numbers>

#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::expect_damage;
using test::GltfBuilder;
using test::set;
using GltfTree = test::GltfReading;

std::vector<std::string> names(const AssetTree& tree) {
  std::vector<std::string> names;
  for (const AssetNode& node : tree.nodes) names.push_back(node.name);
  return names;
}

std::vector<int> parents(const AssetTree& tree) {
  std::vector<int> parents;
  for (const AssetNode& node : tree.nodes) parents.push_back(node.parent);
  return parents;
}

// city (2) holds tram (0), which holds wheel (3), and lamp (1).
GltfBuilder city() {
  GltfBuilder builder = test::one_triangle();
  builder.json["nodes"] = {
      {{"name", "tram"}, {"mesh", 0}, {"children", {3}}, {"translation", {0, 1, 0}}},
      {{"name", "lamp"}},
      {{"name", "city"}, {"children", {0, 1}}, {"translation", {10, 0, 0}}},
      {{"name", "wheel"}, {"mesh", 0}, {"scale", {2, 2, 2}}}};
  builder.json.erase("scenes");
  return builder;
}

json lights(const json& list) {
  return {{"KHR_lights_punctual", {{"lights", list}}}};
}

json light(int index) {
  return {{"KHR_lights_punctual", {{"light", index}}}};
}

TEST_F(GltfTree, NodesStandDepthFirstWithTheirPlaces) {
  const Asset asset = load(city());
  const AssetTree& tree = asset.tree;
  EXPECT_EQ(names(tree), (std::vector<std::string>{"city", "tram", "wheel", "lamp"}));
  EXPECT_EQ(parents(tree), (std::vector<int>{-1, 0, 1, 0}));
  EXPECT_EQ(place_of(tree, 0), "/nodes/2");
  EXPECT_EQ(place_of(tree, 2), "/nodes/3");
  EXPECT_EQ(Vec3(tree.nodes[2].asset_from_node[3]), Vec3(10, 1, 0));
  EXPECT_EQ(tree.nodes[2].asset_from_node[0].x, 2);
  EXPECT_EQ(subtree(tree, 0), (NodeRange{0, 4}));
  EXPECT_EQ(subtree(tree, 1), (NodeRange{1, 3}));
  EXPECT_EQ(subtree(tree, 3), (NodeRange{3, 4}));
  ASSERT_EQ(asset.parts.size(), 2U);
  EXPECT_EQ(asset.parts[0].node, 1);
  EXPECT_EQ(asset.parts[1].node, 2);
  EXPECT_EQ(nodes_of_default_scene(tree), (NodeRanges{{0, 4}}));
}

TEST_F(GltfTree, ScenesShareNodes) {
  GltfBuilder builder = city();
  builder.json["nodes"].push_back({{"name", "moon"}, {"mesh", 0}});
  builder.json["nodes"].push_back({{"name", "nowhere"}, {"mesh", 0}});
  builder.json["scenes"] = {{{"name", "day"}, {"nodes", {2}}}, {{"nodes", {4, 2}}}};
  builder.json["scene"] = 1;
  const Asset asset = load(builder);
  const AssetTree& tree = asset.tree;
  EXPECT_EQ(names(tree), (std::vector<std::string>{"city", "tram", "wheel", "lamp", "moon"}));
  ASSERT_EQ(tree.scenes.size(), 2U);
  EXPECT_EQ(tree.scenes[0].name, "day");
  EXPECT_EQ(tree.scenes[1].roots, (std::vector<int>{4, 0}));
  EXPECT_EQ(tree.default_scene, 1);
  EXPECT_EQ(nodes_of_scene(tree, 0), (NodeRanges{{0, 4}}));
  EXPECT_EQ(nodes_of_default_scene(tree), (NodeRanges{{0, 5}}));
  EXPECT_EQ(asset.meshes.size(), 1U);
  EXPECT_EQ(asset.parts.size(), 3U);
}

TEST(NodeRanges, AreSets) {
  EXPECT_EQ(united({{5, 7}, {1, 3}, {2, 4}, {4, 4}, {9, 9}}), (NodeRanges{{1, 4}, {5, 7}}));
  const NodeRanges all = {{0, 4}, {6, 10}};
  EXPECT_EQ(without(all, {{1, 2}, {3, 7}, {8, 9}}), (NodeRanges{{0, 1}, {2, 3}, {7, 8}, {9, 10}}));
  EXPECT_EQ(without(all, {{0, 20}}), NodeRanges{});
  EXPECT_EQ(without(all, {}), all);
  EXPECT_EQ(without(all, {{4, 6}}), all);
  EXPECT_EQ(common(all, {{3, 7}, {12, 13}}), (NodeRanges{{3, 4}, {6, 7}}));
}

// 683 lm/W: 1366 cd are 2 W/sr, 68.3 lx 0.1 W/m^2.
TEST_F(GltfTree, LightsAreInWatts) {
  GltfBuilder builder = city();
  builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
  builder.json["extensions"] =
      lights({{{"type", "point"}, {"name", "bulb"}, {"intensity", 1366}},
              {{"type", "directional"}, {"intensity", 68.3}, {"color", {1, 0.5, 0.25}}},
              {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
              {{"type", "spot"}, {"spot", json::object()}}});
  builder.json["nodes"][1]["extensions"] = light(2);
  const Asset asset = load(builder);
  EXPECT_TRUE(warnings_.empty());
  const std::vector<Light>& read = asset.tree.lights;
  ASSERT_EQ(read.size(), 4U);
  EXPECT_EQ(read[0].name, "bulb");
  EXPECT_EQ(read[0].kind, LightKind::point);
  EXPECT_FLOAT_EQ(read[0].intensity.value, 2);
  EXPECT_EQ(read[0].color.value, Vec3f(1));
  EXPECT_EQ(read[1].kind, LightKind::sun);
  EXPECT_FLOAT_EQ(read[1].intensity.value, 0.1F);
  EXPECT_EQ(read[1].color.value, Vec3f(1, 0.5F, 0.25F));
  EXPECT_EQ(read[2].kind, LightKind::spot);
  EXPECT_FLOAT_EQ(read[2].intensity.value, 1 / 683.0F);
  EXPECT_EQ(read[2].inner_cone, 0.25);
  EXPECT_EQ(read[2].outer_cone, 0.5);
  EXPECT_EQ(read[3].inner_cone, 0);
  EXPECT_EQ(read[3].outer_cone, std::numbers::pi / 4);
  EXPECT_EQ(asset.tree.nodes[3].light, 2);
  EXPECT_EQ(asset.tree.nodes[0].light, -1);
}

TEST_F(GltfTree, RangeIsLeftOutWithAWarning) {
  GltfBuilder builder = city();
  builder.json["extensions"] = lights({{{"type", "point"}},
                                       {{"type", "point"}, {"range", 5}},
                                       {{"type", "directional"}, {"range", 5}}});
  load(builder);
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_TRUE(warned(
      "asset.glb:/extensions/KHR_lights_punctual/lights/1: range is left out: light falls off with "
      "distance alone, here and 1 more"));
}

TEST_F(GltfTree, CamerasKeepTheirFieldOfView) {
  GltfBuilder builder = city();
  builder.json["cameras"] = {
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 9}}}},
      {{"type", "perspective"}, {"name", "eye"}, {"perspective", {{"yfov", 0.8}, {"znear", 1}}}}};
  builder.json["nodes"][1]["camera"] = 1;
  const AssetTree tree = load(builder).tree;
  ASSERT_EQ(tree.cameras.size(), 2U);
  EXPECT_FALSE(tree.cameras[0].is_perspective);
  EXPECT_TRUE(tree.cameras[1].is_perspective);
  EXPECT_EQ(tree.cameras[1].name, "eye");
  EXPECT_EQ(tree.cameras[1].vertical_fov, 0.8);
  EXPECT_EQ(tree.nodes[3].camera, 1);
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_TRUE(warned("asset.glb:/cameras/0: orthographic cameras are not supported, left out"));
}

TEST_F(GltfTree, KeepsWhatIsSaidToRestframe) {
  GltfBuilder builder = city();
  const json said = {{"velocity", {0, 0, 0.5}}, {"extras", {{"deep", "\u00e9"}}}};
  builder.json["nodes"][2]["extras"] = {{"other", {1, 2}}, {"restframe", said}};
  builder.json["nodes"][0]["extras"] = {{"restframe", "velocity = [0, 0, 0.5]"}};
  builder.json["nodes"][1]["extras"] = {{"another", {{"restframe", 1}}}};
  builder.json["nodes"][3]["extras"] = "restframe";
  builder.json["materials"] = {json::object(), {{"extras", {{"restframe", 1.5}}}}};
  builder.json["scenes"] = {{{"nodes", {2}}, {"extras", {{"restframe", {{"render", 1}}}}}}};
  builder.json["extensions"] = lights({{{"type", "point"}, {"extras", {{"restframe", {}}}}}});
  builder.json["meshes"][0]["extras"] = {{"restframe", true}};
  builder.json["nodes"].push_back({{"extras", {{"restframe", 1}}}});
  const AssetTree tree = load(builder).tree;
  std::vector<std::string> found;
  for (const AssetExtras& extras : tree.extras) {
    found.push_back(std::to_string(static_cast<int>(extras.of)) + " " +
                    std::to_string(extras.index) + " " + extras.place + " " + extras.text);
  }
  const std::vector<std::string> expected = {
      R"(0 0 /scenes/0/extras/restframe {"render":1})",
      "1 0 /nodes/2/extras/restframe {\"extras\":{\"deep\":\"\u00e9\"},\"velocity\":[0,0,0.5]}",
      R"(1 1 /nodes/0/extras/restframe "velocity = [0, 0, 0.5]")",
      R"(2 1 /materials/1/extras/restframe 1.5)",
      R"(3 0 /extensions/KHR_lights_punctual/lights/0/extras/restframe null)"};
  EXPECT_EQ(found, expected);
  EXPECT_TRUE(warned("asset.glb:/meshes/0/extras/restframe: is not read"));
  EXPECT_TRUE(warned("asset.glb:/nodes/4/extras/restframe: is left out: no scene has this node"));
}

TEST(GltfTreeFaults, OfLights) {
  const std::string at = "/extensions/KHR_lights_punctual/lights";
  const auto with = [&](const json& light) {
    return set("/extensions", lights(json::array({light})));
  };
  expect_damage(with({{"intensity", 1}}), at + "/0: type is missing");
  expect_damage(with({{"type", "area"}}), at + "/0/type: is \"area\"",
                "must be one of point, spot, directional");
  expect_damage(with({{"type", "point"}, {"intensity", -1}}), at + "/0/intensity: is -1");
  expect_damage(with({{"type", "point"}, {"color", {1, 1}}}), at + "/0/color: has 2 numbers");
  expect_damage(with({{"type", "point"}, {"color", {1, 1, -1}}}), at + "/0/color/2: is -1");
  expect_damage(with({{"type", "spot"}}), at + "/0: spot is missing");
  expect_damage(with({{"type", "spot"}, {"spot", {{"outerConeAngle", 2}}}}),
                at + "/0/spot/outerConeAngle: is 2");
  expect_damage(with({{"type", "spot"}, {"spot", {{"innerConeAngle", 1}}}}),
                at + "/0/spot: innerConeAngle is 1.0, must be at most outerConeAngle, 0.785");
  expect_damage(with({{"type", "spot"}, {"spot", {{"outerConeAngle", 0}}}}),
                at + "/0/spot: innerConeAngle is 0.0, must be at most outerConeAngle, 0.0, which");
  expect_damage(set("/extensions", {{"KHR_lights_punctual", json::object()}}),
                "/extensions/KHR_lights_punctual: lights is missing");
  expect_damage(set("/nodes/0/extensions", light(0)),
                "/nodes/0/extensions/KHR_lights_punctual/light: is 0, but there is nothing");
  expect_damage(set("/nodes/0/extensions", {{"KHR_lights_punctual", json::object()}}),
                "/nodes/0/extensions/KHR_lights_punctual: light is missing");
}

TEST(GltfTreeFaults, OfCameras) {
  const auto with = [&](const json& camera) { return set("/cameras", json::array({camera})); };
  expect_damage(with({{"name", "eye"}}), "/cameras/0: type is missing");
  expect_damage(with({{"type", "fisheye"}}), "/cameras/0/type: is \"fisheye\"",
                "must be one of perspective, orthographic");
  expect_damage(with({{"type", "perspective"}}), "/cameras/0: perspective is missing");
  expect_damage(with({{"type", "perspective"}, {"perspective", json::object()}}),
                "/cameras/0/perspective: yfov is missing");
  for (const double yfov : {-1.0, 0.0, 3.5}) {
    expect_damage(
        with({{"type", "perspective"}, {"perspective", {{"yfov", yfov}}}}),
        "/cameras/0/perspective/yfov: is " + json(yfov).dump() + ", must be above 0 and below pi");
  }
}

TEST(GltfTreeFaults, OfExtras) {
  expect_damage(
      [](GltfBuilder& b) {
        set("/nodes/0/extras", {{"restframe", 1}})(b);
        set("/nodes/0/scale", {1e200, 1, 1})(b);
        b.json["nodes"][0].erase("mesh");
      },
      "/nodes/0: its transform is not finite");
  std::string text = test::one_triangle().json.dump();
  text.replace(text.find("\"mesh\":0"), 8, R"("mesh":0,"extras":{"restframe":{"a":1,"a":2}})");
  test::expect_fault(test::fault_of_bytes(text), "/nodes/0/extras/restframe: key \"a\" is there");
}

}  // namespace
}  // namespace restframe
