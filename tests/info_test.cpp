// `restframe info`: what it says of assets, as text and as JSON.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/node_folding.h"
#include "scene/generators.h"
#include "support/gltf_builder.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

// A street of three trams alike, the third of another mesh, a lamp with a range, and two cameras.
GltfBuilder street() {
  GltfBuilder builder = test::one_triangle();
  json& root = builder.json;
  root["meshes"][0]["name"] = "tram";
  root["meshes"][0]["primitives"][0]["material"] = 0;
  root["meshes"].push_back(root["meshes"][0]);
  root["meshes"][1]["name"] = "old";
  root["materials"] = {
      {{"name", "paint"},
       {"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {1, 0.5, 0, 1}}}}}};
  root["textures"] = {{{"source", 0}}};
  const std::string png = test::png(2, 1, std::string(8, '\xff'));
  const int view = builder.add_view(png.data(), png.size());
  root["images"] = {{{"name", "wood"}, {"bufferView", view}, {"mimeType", "image/png"}}};
  root["nodes"] = {{{"name", "street"}, {"children", {1, 2, 3, 4, 5, 6}}},
                   {{"name", "tram.001"}, {"mesh", 0}, {"translation", {10, 0, 0}}},
                   {{"name", "tram.002"}, {"mesh", 0}, {"translation", {20, 0, 0}}},
                   {{"name", "tram.003"}, {"mesh", 1}, {"translation", {30, 0, 0}}},
                   {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
                   {{"name", "eye"}, {"camera", 0}},
                   {{"name", "plan"}, {"camera", 1}}};
  root["scenes"] = {{{"name", "day"}, {"nodes", {0}}}, {{"nodes", {0}}}};
  root["scene"] = 0;
  root["cameras"] = {{{"type", "perspective"}, {"name", "main"}, {"perspective", {{"yfov", 0.5}}}},
                     {{"type", "orthographic"}, {"orthographic", json::object()}}};
  root["extensionsUsed"] = {"KHR_lights_punctual", "EXT_of_nobody"};
  root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"},
       {"name", "lamp"},
       {"intensity", 1366},
       {"range", 3},
       {"spot", {{"innerConeAngle", 0}, {"outerConeAngle", 0.5235987755982988}}}}};
  return builder;
}

RunResult info(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"info"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  RunOptions options;
  options.folder = folder.path();
  return run_program(RESTFRAME_PROGRAM, all, options);
}

// A triangle of 3 vertices: 36 bytes of positions, 36 of normals, 12 of indices, 8 of its range.
constexpr const char* street_text = R"(
  7 nodes, 2 meshes placed 3 times, 3 triangles (2 stored)
  1 material, 1 texture, 1 light, 2 cameras
  from [10, 0, 0] to [31, 1, 0], size [21, 1, 0]
  extensions: KHR_lights_punctual, EXT_of_nobody
scenes:
  day: 7 nodes, shown
  scene 1: 7 nodes
nodes:
  street
    tram.00* x 2: mesh tram (1 triangle)
    tram.003: mesh old (1 triangle)
    node 4: light lamp
    eye: camera main
    plan: camera camera 1
meshes:
  tram: 1 triangle, 3 vertices, open, 56 bytes, placed 2 times, of paint
  old: 1 triangle, 3 vertices, open, 56 bytes, of paint
materials:
  paint: base color [1, 0.5, 0], textured
textures:
  wood: 2 x 1 pixels, PNG, 8 bytes
lights:
  lamp: spot, color [1, 1, 1], 2 W/sr, cone 0 to 30 degrees
cameras:
  main: field of view 28.65 degrees
  camera 1: orthographic, not supported
memory: meshes 112 bytes, images 8 bytes, Embree )";

TEST(Info, PrintsAnAssetAsATree) {
  const TemporaryFolder folder;
  const std::string glb = street().glb();
  folder.write("street.glb", glb);
  const RunResult result = info(folder, {"street.glb"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  ASSERT_GT(glb.size(), 1000U);
  const std::string kilobytes = std::to_string(glb.size() / 1000);
  ASSERT_TRUE(result.out.starts_with("street.glb: " + kilobytes)) << result.out;
  const std::string tree = result.out.substr(result.out.find('\n'));
  EXPECT_EQ(tree.substr(0, std::string(street_text).size()), street_text);
  EXPECT_NE(
      result.out.find("\nwarnings:\n"
                      "  street.glb:/extensionsUsed/1: extension \"EXT_of_nobody\" is left out\n"
                      "  street.glb:/extensions/KHR_lights_punctual/lights/0: range is left out"),
      std::string::npos)
      << result.out;
}

TEST(Info, PrintsAnAssetAsJson) {
  const TemporaryFolder folder;
  const std::string glb = street().glb();
  folder.write("street.glb", glb);
  const RunResult result = info(folder, {"--json", "street.glb"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const json document = json::parse(result.out);
  EXPECT_EQ(document["file"], "street.glb");
  EXPECT_NE(document["warnings"].dump().find("range is left out"), std::string::npos);
  ASSERT_EQ(document["assets"].size(), 1U);
  const json& asset = document["assets"][0];
  EXPECT_EQ(asset["bytes"], glb.size());
  EXPECT_EQ(asset["node_count"], 7);
  EXPECT_EQ(asset["triangles"], 3);
  EXPECT_EQ(asset["bounds"], json::parse(R"({"lower": [10, 0, 0], "upper": [31, 1, 0]})"));
  EXPECT_EQ(asset["scenes"], json::parse(R"([{"name": "day", "shown": true},
                                             {"name": "", "shown": false}])"));
  EXPECT_EQ(asset["nodes"], json::parse(R"([{"name": "street", "count": 1, "children": [
      {"name": "tram.00*", "count": 2, "meshes": [{"mesh": 0, "count": 1}]},
      {"name": "tram.003", "count": 1, "meshes": [{"mesh": 1, "count": 1}]},
      {"name": "node 4", "count": 1, "light": 0},
      {"name": "eye", "count": 1, "camera": 0},
      {"name": "plan", "count": 1, "camera": 1}]}])"));
  EXPECT_EQ(asset["meshes"][0]["placed"], 2);
  EXPECT_EQ(asset["meshes"][0]["closed"], false);
  EXPECT_EQ(asset["textures"][0]["format"], "PNG");
  EXPECT_EQ(asset["lights"][0]["intensity"], 2);
  EXPECT_EQ(asset["cameras"][1]["type"], "orthographic");
  EXPECT_EQ(document["scene"]["rest_frames"].size(), 1U);
  EXPECT_EQ(document["scene"]["rest_frames"][0]["objects"][0]["triangles"], 3);
  EXPECT_GT(document["scene"]["memory"]["embree"], 0);
}

TEST(Info, OfASceneFilePrintsItsAssetsToo) {
  const TemporaryFolder folder;
  folder.write("models/street.glb", street().glb());
  folder.write("scene.toml", R"([[object]]
name = "fast"
asset = "models/street.glb"
node = "tram.003"
velocity = [0.6, 0, 0]
[[object]]
name = "ball"
sphere = {}
)");
  const std::string text = info(folder, {"scene.toml"}).out;
  for (const char* part :
       {"scene.toml: 2 rest frames, 2 objects, 2 materials", "velocity [0.6, 0, 0] c, gamma 1.25\n",
        "  fast: 1 mesh placed, 1 triangle, open, [30, 0, 0] to [31, 1, 0]",
        "\nmodels/street.glb: ", "\n    tram.00* x 2: mesh tram (1 triangle)\n",
        "\nmemory: ", "\nwarnings:\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
  const json document = json::parse(info(folder, {"scene.toml", "--json"}).out);
  EXPECT_EQ(document["assets"].size(), 1U);
  EXPECT_EQ(document["assets"][0]["file"], "models/street.glb");
  EXPECT_EQ(document["scene"]["rest_frames"].size(), 2U);
}

TEST(Info, NamesThatAreNoUtf8DoNoHarm) {
  const TemporaryFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no a\xff\x1b[31m\nf 1 2 3\n");
  const RunResult result = info(folder, {"a.obj", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(json::parse(result.out)["assets"][0]["meshes"].size(), 1U);
  EXPECT_EQ(info(folder, {"a.obj"}).out.find('\x1b'), std::string::npos);
}

TEST(NodeFolding, FoldsWhatIsAlike) {
  const Asset lattice = make_lattice({7, 7, 20}, false);
  const FoldedNode folded = folded_nodes(lattice, nodes_of_default_scene(lattice.tree));
  ASSERT_EQ(folded.children.size(), 4U);
  EXPECT_EQ(folded.children[0].name, "ball_*");
  EXPECT_EQ(folded.children[0].count, 980U);
  EXPECT_EQ(folded.children[1].name, "rod_x_*");
  EXPECT_EQ(folded.children[1].count, 6U * 7 * 20);
  EXPECT_EQ(folded.children[3].count, 7U * 7 * 19);
}

// A node of another shape below, or with other things, is another kind.
TEST(NodeFolding, KeepsApartWhatDiffersBelow) {
  Asset asset;
  const auto add = [&](const char* name, int parent) {
    AssetNode node;
    node.name = name;
    node.parent = parent;
    asset.tree.nodes.push_back(node);
    return static_cast<int>(asset.tree.nodes.size()) - 1;
  };
  for (int i = 0; i < 3; ++i) {
    const int car = add("car", -1);
    add("wheel.1", car);
    add("wheel.2", car);
    if (i == 1) add("flag", car);
  }
  const FoldedNode folded = folded_nodes(asset, {{0, 10}});
  ASSERT_EQ(folded.children.size(), 2U);
  EXPECT_EQ(folded.children[0].name, "car");
  EXPECT_EQ(folded.children[0].count, 2U);
  ASSERT_EQ(folded.children[0].children.size(), 1U);
  EXPECT_EQ(folded.children[0].children[0].name, "wheel.*");
  EXPECT_EQ(folded.children[1].count, 1U);
  EXPECT_EQ(folded.children[1].children.size(), 2U);
}

TEST(NodeFolding, StaysReadable) {
  Asset deep, wide;
  for (int i = 0; i < 5'000; ++i) {
    AssetNode node;
    node.parent = i - 1;
    deep.tree.nodes.push_back(node);
    node.name = std::to_string(i) + "x";
    node.parent = -1;
    wide.tree.nodes.push_back(node);
  }
  FoldedNode folded = folded_nodes(wide, {{0, 5'000}});
  EXPECT_EQ(folded.children.size(), 25U);
  EXPECT_EQ(folded.more, 4'975U);
  folded = folded_nodes(deep, {{0, 5'000}});
  std::size_t levels = 0;
  const FoldedNode* node = &folded;
  for (; !node->children.empty(); node = &node->children[0]) ++levels;
  EXPECT_EQ(levels, 12U);
  EXPECT_EQ(node->more, 4'988U);
}

}  // namespace
}  // namespace restframe
