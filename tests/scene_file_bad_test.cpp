// Broken scene files: every fault with its line and column, and the words that help.

#include <gmock/gmock.h>

#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

struct Broken {
  std::string text;
  std::vector<std::string> words;  // the first: where the fault stands
};

const std::string ball = "[[object]]\nname = \"a\"\nsphere = {}\n";  // three lines
std::string in_object(const std::string& line) {
  return ball + line;
}
std::string in_material(const std::string& line) {
  return ball + "[[material]]\nname = \"ball\"\n" + line;  // from line 6
}
std::string in_section(const std::string& section, const std::string& line) {
  return "[" + section + "]\n" + line + "\n" + ball;
}
std::string in_camera(const std::string& line) {
  return "[camera]\nposition = [0, 0, 4]\n" + line + "\n" + ball;
}

class BadScene : public SceneReading {
 protected:
  // Each text has exactly one fault.
  void check(const std::vector<Broken>& cases) {
    for (const Broken& broken : cases) {
      const std::vector<std::string> lines = faults(broken.text);
      EXPECT_THAT(lines, SizeIs(1)) << broken.text;
      if (lines.empty()) continue;
      EXPECT_THAT(lines[0], ::testing::StartsWith(broken.words.at(0))) << broken.text;
      for (const std::string& word : broken.words) EXPECT_THAT(lines[0], HasSubstr(word));
    }
  }
};

TEST_F(BadScene, Syntax) {
  check({
      {"[camera\n", {"1:8: "}},
      {"a = \n", {"1:"}},
      {"[render]\nsamples = 16\nsamples = 17\n", {"3:", "samples"}},
      {"x = \"\xff\"", {"1:"}},
      {"x = " + std::string(1000, '['), {"1:"}},
      {"x" + std::string(100'000, '.') + " = 1", {"1:", "deeper"}},
      {"[a" +
           [] {
             std::string deep;
             for (int i = 0; i < 100'000; ++i) deep += ".a";
             return deep;
           }() +
           "]",
       {"1:1: ", "deeper"}},
  });
}

TEST_F(BadScene, EmptyOnes) {
  check({{"", {"1:1: ", "no [[object]]"}}, {"# nothing\n", {"1:1: ", "no [[object]]"}}});
}

TEST_F(BadScene, UnknownKeysNameTheNearest) {
  check({
      {"[camra]\n" + ball, {"1:2: ", "\"camra\"", "\"camera\""}},
      {in_camera("fvo = 3"), {"3:1: ", "camera: unknown key \"fvo\"", "\"fov\""}},
      {in_section("render", "sample = 3"), {"2:1: ", "\"samples\""}},
      {in_section("animation", "frames = 3"), {"2:1: ", "animation", "\"rate\""}},
      {in_object("positon = [0, 0, 0]"), {"4:1: ", "object \"a\"", "\"position\""}},
      {in_material("rougness = 1"), {"6:1: ", "material \"ball\"", "\"roughness\""}},
      {in_material("roughness = {intervls = [[0, 1, 1]], keys = [[0, 1]]}"),
       {"6:14: ", "\"intervals\""}},
      {"[[object]]\nsphere = {radus = 1}\n", {"2:11: ", "\"radius\""}},
      {"[[object]]\nlattice = {cell = [1, 1, 1]}\n", {"2:12: ", "\"cells\""}},
  });
}

TEST_F(BadScene, MattesAreFloat) {
  check({
      {in_section("output", "half = [\"crypto_object\"]\nlayers = [\"crypto_object\"]"),
       {"2:8: ", "\"crypto_object\" must stay float"}},
  });
}

TEST_F(BadScene, TypesAndRanges) {
  check({
      {in_section("scene", "light_speed = 0"), {"2:15: ", "light_speed is 0, must be above 0"}},
      {in_section("scene", "light_speed = \"fast\""), {"2:15: ", "is a text, must be a number"}},
      {in_section("scene", "light_speed = nan"), {"2:15: ", "finite"}},
      {in_section("scene", "light_speed = inf"), {"2:15: ", "finite"}},
      {in_section("animation", "rate = -1"), {"2:8: ", "rate is -1"}},
      {in_section("animation", "pictures = 0"), {"2:12: ", "pictures is 0, must be from 1"}},
      {in_section("animation", "pictures = 1.5"), {"2:12: ", "1.5, must be a whole number"}},
      {in_section("animation", "start = 2020-01-01"), {"2:9: ", "a date or time"}},
      {in_section("render", "resolution = [0, 10]"),
       {"2:15: ", "width is 0, must be from 1 to 32768"}},
      {in_section("render", "resolution = [10]"), {"2:14: ", "[width, height]"}},
      {in_section("render", "samples = 65537"), {"2:11: ", "must be from 1 to 65536"}},
      {in_section("render", "noise = 1.5"), {"2:9: ", "noise is 1.5, must be from 0 to 1"}},
      {in_section("output", "exposure = 100"), {"2:12: ", "exposure is 100"}},
      {in_section("output", "view = \"aces\""), {"2:8: ", "srgb, filmic"}},
      {in_section("render", "seed = -1"), {"2:8: ", "seed is -1"}},
      {in_section("render", "beaming = 1"), {"2:11: ", "true or false"}},
      {in_section("render", "integrator = \"preveiw\""), {"2:14: ", "\"preview\""}},
      {in_section("render", "depth = 0"), {"2:9: ", "depth is 0, must be from 1 to 64"}},
      {in_section("render", "depth = 65"), {"2:9: ", "depth is 65, must be from 1 to 64"}},
      {in_section("output", "compression = \"zlib\""), {"2:15: ", "nearest"}},
      {in_section("output", "split = 1"), {"2:9: ", "true or false"}},
      {in_section("output", "compression_level = 10001"), {"2:21: ", "must be from 0 to 10000"}},
      {in_section("output", "half = []"), {"2:8: ", "half must be an array"}},
      {in_section("output", "float = [\"N\"]"), {"2:9: ", "\"N\" is not among"}},
      {in_section("output", "layers = [\"beuty\"]"), {"2:11: ", "\"beauty\""}},
      {in_section("output", "layers = [\"Z\", \"Z\"]"), {"2:16: ", "twice"}},
      {in_section("output", "layers = []"), {"2:10: ", "at least one"}},
      {in_section("output", "path = \"out/a.png\""), {"2:8: ", ".exr"}},
      {in_section("output", "path = \"out/##a##.exr\""), {"2:8: ", "one run of #"}},
      {"[animation]\npictures = 2\n[output]\npath = \"a.exr\"\n" + ball, {"4:8: ", "2 pictures"}},
      {"render = 3\n" + ball, {"1:10: ", "must be a table"}},
      {"[object]\n", {"1:1: ", "[[object]]"}},
  });
}

TEST_F(BadScene, Cameras) {
  check({
      {"[camera]\nfov = 60\n" + ball, {"1:1: ", "position is missing"}},
      {in_camera("fov = 180"), {"3:7: ", "above 0 and below 180"}},
      {in_camera("fov = 0"), {"3:7: ", "above 0 and below 180"}},
      {in_camera("velocity = [0, 1, 0]"), {"3:12: ", "camera: |velocity| is 1, must be below 1"}},
      {in_camera("velocity = [0, 1]"), {"3:12: ", "2 elements"}},
      {in_camera("velocity = [0, \"1\", 0]"), {"3:16: ", "velocity[1] is a text"}},
      {in_camera("look_at = [0, 0, 0]\ndirection = [0, 0, -1]"), {"4:1: ", "exclude each other"}},
      {in_camera("direction = [0, 0, 0]"), {"3:13: ", "must point somewhere"}},
      {in_camera("direction = [0, 7, 0]"), {"3:13: ", "along up"}},
      {in_camera("up = [0, 0, 0]"), {"3:6: ", "must point somewhere"}},
  });
}

TEST_F(BadScene, Objects) {
  check({
      {in_object("velocity = [0, 0, 1.2]"),
       {"4:12: object \"a\": |velocity| is 1.2, must be below 1"}},
      {in_object("velocity = [1e300, 1e300, 1e300]"), {"4:12: "}},
      {in_object("gamma = 0.5\ndirection = [0, 0, 1]"), {"4:9: ", "gamma is 0.5, must be from 1"}},
      {in_object("gamma = 2"), {"4:1: ", "go together"}},
      {in_object("direction = [0, 0, 1]"), {"4:1: ", "go together"}},
      {in_object("velocity = [0, 0, 0]\ngamma = 2\ndirection = [0, 0, 1]"), {"5:1: ", "exclude"}},
      {in_object("clock = \"world\""), {"4:9: ", "\"frame\""}},
      {in_object("scale = 0"), {"4:9: ", "above 0"}},
      {in_object("rotation = 90"), {"4:12: ", "[x, y, z]"}},
      {ball + ball, {"5:8: ", "two objects have the name \"a\""}},
      {"[[object]]\nname = \"a\"\n", {"1:1: ", "an asset, a lattice or a sphere"}},
      {in_object("asset = \"paint.obj\""), {"4:1: ", "exclude each other"}},
      {"[[object]]\nname = \"\"\nsphere = {}\n", {"2:8: ", "empty"}},
      {"[[object]]\nsphere = {radius = 0}\n", {"2:20: ", "above 0"}},
      {"[[object]]\nlattice = {ball = 0.1, rod = 0.2}\n", {"2:11: ", "object_1", "rod"}},
      {"[[object]]\nlattice = {cells = [0, 1, 1]}\n", {"2:21: ", "cells[0] is 0"}},
      {"[[object]]\nlattice = {instances = \"gpu\"}\n", {"2:24: ", "nodes, none"}},
      {in_object("material = \"rde\""), {"4:12: ", "no material \"rde\"", "\"ball\""}},
      {in_object("materials = {bal = \"ball\"}"), {"4:14: ", "no material \"bal\"", "\"ball\""}},
  });
}

TEST_F(BadScene, Assets) {
  check({
      {"[[object]]\nasset = \"missing.obj\"\n", {"2:9: ", "\"missing.obj\": no such file"}},
      {"[[object]]\nasset = \".\"\n", {"2:9: ", "is a folder"}},
      {"[[object]]\nasset = \"/dev/zero\"\n", {"2:9: ", "not a regular file"}},
      {"[[object]]\nasset = \"a\\u0000b\"\n", {"2:9: ", "NUL"}},
  });
  const std::vector<std::string> lines = faults("[[object]]\nasset = \"scene.toml\"\n");
  EXPECT_THAT(lines, ElementsAre(HasSubstr("must be .gltf, .glb, .obj, .ply, .stl or .off")));
}

TEST_F(BadScene, Materials) {
  check({
      {ball + "[[material]]\nbase_color = \"red\"\n", {"4:1: ", "name is missing"}},
      {ball + "[[material]]\nname = \"bal\"\n", {"5:8: ", "\"bal\"", "nearest is \"ball\""}},
      {ball + "[[material]]\nname = \"x*\"\n", {"5:8: ", "nearest is \"ball\""}},
      {in_material("object = \"b\""), {"6:10: ", "no object \"b\"", "\"a\""}},
      {in_material("base_color = \"yelow\""), {"6:14: ", "\"yelow\"", "nearest is \"yellow\""}},
      {in_material("base_color = \"#12\""), {"6:14: ", "hexadecimal"}},
      {in_material("base_color = [0, 2, 0]"),
       {"6:18: ", "base_color[1] is 2, must be from 0 to 1"}},
      {in_material("base_color = 1"), {"6:14: ", "must be a colour"}},
      {in_material("emission = [0, -1, 0]"), {"6:16: ", "at least 0"}},
      {in_material("emission_strength = 1e300"), {"6:21: ", "too large"}},
      {in_material("emission = [0, 0, 1e300]"), {"6:12: ", "too large"}},
      {in_material("roughness = 2"), {"6:13: ", "from 0 to 1"}},
      {in_material("specular = 1.5"), {"6:12: ", "specular is 1.5, must be from 0 to 1"}},
      {in_material("specular_color = [1, -1, 0]"), {"6:22: ", "at least 0"}},
      {in_material("clearcoat = -0.5"), {"6:13: ", "clearcoat is -0.5, must be from 0 to 1"}},
      {in_material("clearcoat_roughness = 2"), {"6:23: ", "from 0 to 1"}},
      {in_material("sheen_color = [0, 0, 2]"), {"6:22: ", "from 0 to 1"}},
      {in_material("sheen_roughness = -1"), {"6:19: ", "from 0 to 1"}},
      {in_material("normal_scale = \"much\""), {"6:16: ", "must be a number"}},
      {in_material("normal_scale = nan"), {"6:16: ", "finite"}},
      {in_material("clearcote = 1"), {"6:1: ", "\"clearcoat\""}},
      {in_material("opacity = true"), {"6:11: ", "must be a number"}},
      {in_material("unlit = 1"), {"6:9: ", "true or false"}},
      {in_material("thin_walled = \"yes\""), {"6:15: ", "true or false"}},
  });
}

TEST_F(BadScene, TemporalFunctions) {
  check({
      {in_material("roughness = {}"),
       {"6:13: ", "material \"ball\": roughness: must have intervals"}},
      {in_material("roughness = {period = 0, keys = [[0, 1]]}"), {"6:23: ", "period is 0"}},
      {in_material("roughness = {period = 1, intervals = [[0, 0.6, 0], [0.5, 1, 1]]}"),
       {"6:52: ", "overlaps"}},
      {in_material("roughness = {period = 1, intervals = [[0, 1.5, 0]]}"),
       {"6:39: ", "leaves the period"}},
      {in_material("roughness = {intervals = [[1, 1, 0]]}"), {"6:27: ", "empty"}},
      {in_material("roughness = {intervals = []}"), {"6:26: ", "array of [begin, end, value]"}},
      {in_material("roughness = {intervals = [[0, 1]]}"), {"6:27: ", "[begin, end, value]"}},
      {in_material("roughness = {intervals = [[0, inf, 0]]}"), {"6:31: ", "finite"}},
      {in_material("roughness = {intervals = [[0, 1, 2]]}"), {"6:34: ", "from 0 to 1"}},
      {in_material("roughness = {keys = [[1, 0], [0, 1]]}"), {"6:30: ", "out of order"}},
      {in_material("roughness = {keys = [[1, 0], [1, 1], [1, 0.5]]}"), {"6:38: ", "third"}},
      {in_material("roughness = {keys = [[1, \"red\"]]}"), {"6:26: ", "must be a number"}},
      {in_material("roughness = {keys = [[0, 1]], formula = \"t\"}"),
       {"6:31: ", "exclude each other"}},
      {in_material("roughness = {formula = \"t=5\"}"), {"6:24: ", "\"t=5\"", "assign"}},
      {in_material("roughness = {formula = \"1,2,3\"}"), {"6:24: ", "list of 3"}},
      {in_material("roughness = {formula = \"sin(\"}"), {"6:24: ", "can not be used"}},
      {in_material("roughness = {formula = \"t\", period = 1}"), {"6:29: ", "period goes with"}},
      {in_material("roughness = {formula = [\"t\", \"t\", \"t\"]}"), {"6:24: ", "one formula"}},
      {in_material("roughness = {formula = \"t\", from = 0, to = 1}"),
       {"6:36: ", "of a colour only"}},
      {in_material("base_color = {formula = \"t\"}"), {"6:25: ", "needs from and to"}},
      {in_material("base_color = {formula = [\"t\", \"t\"]}"), {"6:25: ", "one formula or three"}},
      {in_material("base_color = {intervals = [[0, 1, \"bleu\"]]}"), {"6:35: ", "\"blue\""}},
      {in_material("base_color = {file = \"none.txt\"}"), {"6:22: ", "no such file"}},
  });
  folder.write("bad.txt", "% interval 0 1 redd\n");
  EXPECT_THAT(faults(in_material("base_color = {file = \"bad.txt\"}")),
              ElementsAre(HasSubstr("bad.txt:1:16: ")));
}

TEST_F(BadScene, AllFaultsAreListedInTheFilesOrder) {
  const std::vector<std::string> lines = faults(R"([scene]
light_speed = -1
[camera]
position = [0, 0]
fov = 200
colour = "red"
[[object]]
name = "one"
asset = "missing.glb"
velocity = [0, 0, 2]
[[material]]
name = "paint"
roughness = {period = 1, intervals = [[0, 2, 0], [0.5, 0.4, 0]]}
)");
  using ::testing::StartsWith;
  EXPECT_THAT(
      lines, ElementsAre(StartsWith("2:15: scene: "), StartsWith("4:12: camera: "),
                         StartsWith("5:7: camera: "), StartsWith("6:1: camera: "),
                         StartsWith("9:9: object \"one\": "), StartsWith("10:12: object \"one\": "),
                         StartsWith("13:39: material \"paint\": "),
                         StartsWith("13:50: material \"paint\": ")));
}

TEST_F(BadScene, FilesThatAreNone) {
  const auto fault = [&](const Path& path) {
    try {
      load_scene(path, {}, warnings);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(fault(folder.path() / "none.toml"), HasSubstr("none.toml: no such file"));
  EXPECT_THAT(fault(folder.path() / "none.glb"), HasSubstr("none.glb: no such file"));
  std::filesystem::create_directories(folder.path() / "folder.toml");
  EXPECT_THAT(fault(folder.path() / "folder.toml"), HasSubstr("folder"));
  EXPECT_THAT(fault(folder.write("scene.txt", "x")), HasSubstr(".gltf, .glb, .obj, .ply"));
  EXPECT_THAT(fault(folder.write("scene", "x")), HasSubstr(".gltf, .glb, .obj, .ply"));
}

TEST_F(BadScene, NamesWithLineBreaksStayOnOneLine) {
  EXPECT_THAT(faults(in_object("\"x\\ny\" = 1")), ElementsAre(HasSubstr("\"x?y\"")));
}

}  // namespace
}  // namespace restframe
