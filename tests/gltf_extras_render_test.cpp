// Pictures of an asset that says all by itself: the same as those of a scene file that says it.

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "scene/generators.h"
#include "support/authored_asset.h"
#include "support/exr_reader.h"
#include "support/program.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::say;

// A ball of radius 1 with normals, and a material "paint".
GltfBuilder ball() {
  const Mesh mesh = make_ball({1.0, 3});
  std::vector<float> positions, normals;
  std::vector<std::uint32_t> indices;
  for (const Vec3f& p : mesh.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
  for (const Vec3f& n : mesh.normals) normals.insert(normals.end(), {n.x, n.y, n.z});
  for (const Triangle& t : mesh.triangles) indices.insert(indices.end(), {t[0], t[1], t[2]});
  GltfBuilder builder;
  const int p = builder.add_accessor(positions, "VEC3");
  const int n = builder.add_accessor(normals, "VEC3");
  const int i = builder.add_accessor(indices, "SCALAR");
  builder.add_mesh(
      {{"attributes", {{"POSITION", p}, {"NORMAL", n}}}, {"indices", i}, {"material", 0}});
  builder.json["materials"] = {{{"name", "paint"}}};
  return builder;
}

const std::string settings =
    "[animation]\nstart = 0.25\n[exposure]\nshutter = 0.1\n"
    "[render]\nresolution = [48, 32]\nsamples = 4\n"
    "[output]\nlayers = ['beauty', 'Z', 'time', 'doppler', 'N', 'P', 'id']\npreview = false\n";
const std::string blink = "period = 0.5\nintervals = [[0, 0.25, 'red'], [0.25, 0.4, 'blue']]\n";

// Three balls: one at rest, one that moves, and, below it, one that moves another way.
GltfBuilder authored() {
  GltfBuilder builder = ball();
  builder.json["nodes"] = {
      {{"name", "still"}, {"mesh", 0}, {"translation", {-3, 0, -10}}},
      {{"name", "first"}, {"mesh", 0}, {"children", {2}}, {"translation", {1, 1, -8}}},
      {{"name", "second"}, {"mesh", 0}, {"translation", {2, -3, 0}}},
      {{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 1}}}};
  builder.json["scenes"] = {{{"nodes", {0, 1, 3}}}};
  builder.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", std::numbers::pi / 3}}}}};
  say(builder, "/scenes/0", settings);
  say(builder, "/materials/0", "[base_color]\n" + blink);
  say(builder, "/nodes/0", {{"velocity", {0, 0, 0}}});
  say(builder, "/nodes/1", {{"velocity", {0.5, 0.25, 0.5}}, {"time", -6}, {"clock", 0.125}});
  say(builder, "/nodes/2", "gamma = 3\ndirection = [-1, 0, 1]\ntime = -10\nclock = 'frame'");
  say(builder, "/cameras/0", {{"velocity", {0, 0, -0.25}}, {"aperture", 0.0625}, {"focus", 8}});
  return builder;
}

std::string same_as_scene_file() {
  return settings +
         "[camera]\nposition = [0, 0, 1]\nvelocity = [0, 0, -0.25]\naperture = 0.0625\nfocus = 8\n"
         "[[object]]\nname = 'still'\nasset = 'ball.glb'\nposition = [-3, 0, -10]\n"
         "[[object]]\nname = 'first'\nasset = 'ball.glb'\nposition = [1, 1, -8]\ntime = -6\n"
         "clock = 0.125\nvelocity = [0.5, 0.25, 0.5]\n"
         "[[object]]\nname = 'second'\nasset = 'ball.glb'\nposition = [3, -2, -8]\ntime = -10\n"
         "clock = 'frame'\ngamma = 3\ndirection = [-1, 0, 1]\n"
         "[[material]]\nname = 'paint'\n[material.base_color]\n" +
         blink;
}

ExrPicture rendered(const TemporaryFolder& folder, const std::string& file) {
  const auto picture = folder.path() / (file + ".exr");
  const RunResult result = run_program(
      RESTFRAME_PROGRAM,
      {"render", (folder.path() / file).string(), "--output", picture.string(), "--quiet"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  return read_exr(picture);
}

TEST(GltfExtrasRender, PicturesAreThoseOfTheSceneFile) {
  const TemporaryFolder folder;
  folder.write("ball.glb", ball().glb());
  folder.write("scene.toml", same_as_scene_file());
  folder.write("authored.glb", authored().glb());
  const ExrPicture expected = rendered(folder, "scene.toml");
  const ExrPicture made = rendered(folder, "authored.glb");
  ASSERT_EQ(made.width, 48);
  EXPECT_EQ(made.channels, expected.channels);
  std::set<float> objects(made.channel("id_object.V").begin(), made.channel("id_object.V").end());
  EXPECT_EQ(objects, (std::set<float>{0, 1, 2, 3}));  // all three are to be seen
}

TEST(GltfExtrasRender, TheProgramNamesFaults) {
  const TemporaryFolder folder;
  GltfBuilder builder = authored();
  say(builder, "/nodes/1", {{"velocity", {0, 0, 1}}});
  const auto file = folder.write("authored.glb", builder.glb());
  const RunResult result = run_program(RESTFRAME_PROGRAM, {"check", file.string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.error, "error: " + file.string() +
                              ":/nodes/1/extras/restframe/velocity: node \"first\": |velocity| is "
                              "1, must be below 1\n");
}

}  // namespace
}  // namespace restframe
