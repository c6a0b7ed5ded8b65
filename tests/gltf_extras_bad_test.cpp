// Faults in what an asset says to restframe: every one with its place and the words that help.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "support/authored_asset.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::say;
using test::street;
using test::street_lamp;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class BadExtras : public test::AuthoredAsset {
 protected:
  // The one fault of saying this there; "street.glb:POINTER/extras/restframe" is left off.
  std::string fault(const std::string& pointer, const json& what) {
    GltfBuilder builder = street();
    say(builder, pointer, what);
    return only_fault(faults(builder), "street.glb:" + pointer + "/extras/restframe");
  }

  static std::string only_fault(const std::vector<std::string>& lines, const std::string& begin) {
    EXPECT_EQ(lines.size(), 1U) << testing::PrintToString(lines);
    if (lines.empty()) return "";
    EXPECT_EQ(lines[0].rfind(begin, 0), 0U) << lines[0];
    return lines[0].substr(std::min(begin.size(), lines[0].size()));
  }
};

TEST_F(BadExtras, Nodes) {
  const auto of_tram = [&](const json& what) { return fault("/nodes/1", what); };
  EXPECT_EQ(of_tram({{"velocity", {0, 1.2, 0}}}),
            "/velocity: node \"tram\": |velocity| is 1.2, must be below 1");
  EXPECT_EQ(of_tram("\nvelocity = [0, 1.2, 0]"),
            ":2:12: node \"tram\": |velocity| is 1.2, must be below 1");
  EXPECT_EQ(of_tram({{"velocty", {0, 0, 0}}}),
            "/velocty: node \"tram\": unknown key \"velocty\", the nearest known one is "
            "\"velocity\" (known here: position, time, velocity, gamma, direction, clock)");
  EXPECT_EQ(of_tram({{"gamma", 0.5}, {"direction", {1, 0, 0}}}),
            "/gamma: node \"tram\": gamma is 0.5, must be from 1 to 100000000");
  EXPECT_EQ(of_tram({{"gamma", 2}}), "/gamma: node \"tram\": gamma and direction go together");
  EXPECT_EQ(of_tram({{"gamma", 2}, {"direction", {0, 0, 0}}}),
            "/direction: node \"tram\": direction is [0, 0, 0], must point somewhere");
  EXPECT_EQ(of_tram({{"clock", "fame"}}),
            "/clock: node \"tram\": clock is \"fame\", must be a number or \"frame\"");
  EXPECT_EQ(of_tram({{"time", nullptr}}), "/time: node \"tram\": time is null, must be a number");
  EXPECT_EQ(of_tram("velocity = "),
            ":1:12: Error while parsing key-value pair: encountered "
            "end-of-file");
  EXPECT_EQ(of_tram(3), ": is a whole number, must be an object, or TOML in a string");
  EXPECT_THAT(of_tram("time = nan"),
              HasSubstr("1:8: node \"tram\": time is nan, must be a finite"));
}

TEST_F(BadExtras, HugeOnes) {
  EXPECT_EQ(fault("/nodes/1", fmt::format("#{:x>4000000}", "")),
            ": more than 4000000 characters of TOML in all");
  const std::string key(100'000, 'k'), shown = key.substr(0, 80);
  EXPECT_THAT(
      fault("/nodes/1", {{key, 1}}),
      StartsWith(fmt::format("/{}...: node \"tram\": unknown key \"{}...\", the nearest known "
                             "one is",
                             shown, shown)));
}

TEST_F(BadExtras, VelocityTwiceInASpelling) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", "gamma = 2\nvelocity = [0, 0, 0.5]\ndirection = [0, 0, 1]");
  EXPECT_THAT(faults(builder),
              ElementsAre("street.glb:/nodes/1/extras/restframe:2:1: node \"tram\": gamma and "
                          "velocity exclude each other"));
}

TEST_F(BadExtras, AClockBelowAMovingNodeNeedsAVelocity) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {0.5, 0, 0}}});
  say(builder, "/nodes/2", {{"clock", 1}});
  EXPECT_THAT(
      faults(builder),
      ElementsAre("street.glb:/nodes/2/extras/restframe: node \"wheel\": position, time and "
                  "clock need a velocity here, since node \"tram\" above it has one"));
}

TEST_F(BadExtras, Materials) {
  const auto of_paint = [&](const json& what) { return fault("/materials/0", what); };
  EXPECT_THAT(
      of_paint({{"base_colour", "red"}}),
      HasSubstr("/base_colour: material \"paint\": unknown key \"base_colour\", the nearest "
                "known one is \"base_color\""));
  EXPECT_THAT(of_paint({{"name", "gold"}}), HasSubstr("/name: material \"paint\": unknown key"));
  EXPECT_EQ(of_paint({{"metallic", 2}}),
            "/metallic: material \"paint\": metallic is 2, must be "
            "from 0 to 1");
  EXPECT_EQ(of_paint({{"base_color", {{"period", 1}, {"intervals", {{0, 2, "red"}}}}}}),
            "/base_color/intervals/0: material \"paint\": base_color: the interval from 0 to 2 "
            "leaves the period, 0 to 1");
  EXPECT_EQ(of_paint("[opacity]\nformula = '1+'"),
            ":2:11: material \"paint\": opacity: formula \"1+\" can not be used: Unexpected end of "
            "expression at position 3");
}

TEST_F(BadExtras, FilesOfAStrangerLieBesideIt) {
  folder_.write("blink.txt", "% interval 0 1 red\n");
  const auto of_file = [&](const std::string& name) {
    return fault("/materials/0", {{"base_color", {{"file", name}}}});
  };
  for (const char* name : {"../blink.txt", "/etc/passwd", "C:\\blink.txt"}) {
    const std::string line = of_file(name);
    EXPECT_EQ(line.rfind("/base_color/file: file \"" + std::string(name) + "\"", 0), 0U) << line;
  }
  EXPECT_EQ(of_file("blank.txt"),
            "/base_color/file: material \"paint\": base_color: file \"blank.txt\": no such file");
}

TEST_F(BadExtras, FilesOfAStrangersLightsLieBesideItInSceneFilesToo) {
  GltfBuilder builder = street();
  say(builder, street_lamp, {{"intensity", {{"file", "../blink.txt"}}}});
  folder_.write("below/street.glb", builder.glb());
  folder_.write("blink.txt", "% interval 0 1 1\n");
  const auto lines = faults_of([&] { load_toml("[[object]]\nasset = 'below/street.glb'\n"); });
  EXPECT_THAT(only_fault(lines, "below/street.glb:" + street_lamp + "/extras/restframe"),
              HasSubstr("/intensity/file: file \"../blink.txt\" leads out of the asset's folder"));
}

TEST_F(BadExtras, LightsAndCameras) {
  EXPECT_THAT(fault(street_lamp, {{"colour", "red"}}),
              HasSubstr("/colour: light \"lamp\": unknown key \"colour\", the nearest known one is "
                        "\"color\""));
  EXPECT_EQ(fault(street_lamp, {{"cone", {1, 2}}}),
            "/cone: light \"lamp\": cone goes with a spot, not with type = \"point\"");
  EXPECT_EQ(fault("/cameras/0", {{"fov", 180}}),
            "/fov: camera: fov is 180, must be above 0 and "
            "below 180");
  EXPECT_EQ(fault("/cameras/0", "track = 'trm'"),
            ":1:9: camera: there is no object \"trm\", the nearest is \"street\"");
}

TEST_F(BadExtras, ACarriedCameraHasNoMotion) {
  GltfBuilder builder = street();
  builder.json["nodes"][4]["extras"]["restframe"] = {{"velocity", {0.5, 0, 0}}};
  say(builder, "/cameras/0", {{"velocity", {0.1, 0, 0}}});
  EXPECT_THAT(faults(builder),
              ElementsAre("street.glb:/cameras/0/extras/restframe/velocity: camera: velocity goes "
                          "with a camera at rest only: this one is carried by a node that has a "
                          "motion"));
}

TEST_F(BadExtras, ACameraIsToldOnce) {
  GltfBuilder builder = street();
  say(builder, "/cameras/0", {{"fov", 30}});
  say(builder, "/scenes/0", {{"camera", {{"fov", 40}}}});
  EXPECT_THAT(
      faults(builder),
      ElementsAre("street.glb:/scenes/0/extras/restframe/camera/fov: camera: fov is there "
                  "twice: by the camera itself (street.glb:/cameras/0/extras/restframe/fov), "
                  "too"));
}

TEST_F(BadExtras, Scenes) {
  const auto of_scene = [&](const json& what) { return fault("/scenes/0", what); };
  EXPECT_EQ(
      of_scene({{"rendr", json::object()}}),
      "/rendr: unknown key \"rendr\", the nearest known one is \"render\" (known here: scene, "
      "animation, exposure, render, output, object, camera, light, material)");
  EXPECT_EQ(of_scene({{"object", json::array()}}),
            "/object: object goes with scene files only: the objects of an asset are its nodes");
  EXPECT_EQ(of_scene({{"animation", 3}}),
            "/animation: animation is a whole number, must be a table");
  EXPECT_EQ(of_scene("[render]\nsamples = 0"),
            ":2:11: render: samples is 0, must be from 1 to 65536");
  EXPECT_EQ(of_scene("[exposure]\nshutter = -1"),
            ":2:11: exposure: shutter is -1, must be at least 0");
  EXPECT_EQ(of_scene({{"scene", {{"light_speed", 0}}}}),
            "/scene/light_speed: scene: light_speed is 0, must be above 0");
  for (const char* path : {"/tmp/a.exr", "../a.exr", "a/../../b.exr"}) {
    EXPECT_EQ(
        of_scene({{"output", {{"path", path}}}}),
        "/output/path: output: path is \"" + std::string(path) +
            "\", must lie in the current folder or below: an asset chooses no other; --output "
            "does");
  }
}

TEST_F(BadExtras, EveryFaultIsTold) {
  GltfBuilder builder = street();
  say(builder, "/scenes/0", {{"render", {{"samples", 0}}}});
  say(builder, "/nodes/1", {{"velocity", {2, 0, 0}}});
  say(builder, "/materials/1", {{"metallic", "x"}});
  say(builder, "/cameras/0", 1);
  EXPECT_EQ(faults(builder).size(), 4U);
}

TEST_F(BadExtras, UnderAnObjectThatMoves) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {0.5, 0, 0}}});
  folder_.write("street.glb", builder.glb());
  const auto with = [&](const std::string& line) {
    return faults_of([&] { load_toml("[[object]]\nasset = 'street.glb'\n" + line); });
  };
  const std::string rest =
      " and the asset's own motion of node \"tram\" (street.glb:/nodes/1/extras/restframe) exclude "
      "each other";
  EXPECT_THAT(with("velocity = [0.1, 0, 0]"),
              ElementsAre("scene.toml:3:1: object \"object_1\": velocity" + rest));
  EXPECT_THAT(with("gamma = 2\ndirection = [1, 0, 0]"),
              ElementsAre("scene.toml:3:1: object \"object_1\": gamma" + rest));
  EXPECT_THAT(with("time = 3"), IsEmpty());
}

TEST_F(BadExtras, FaultsOfAnAssetInASceneFile) {
  GltfBuilder builder = street();
  say(builder, "/nodes/1", {{"velocity", {2, 0, 0}}});
  folder_.write("street.glb", builder.glb());
  // Once, though two objects are made of it.
  EXPECT_THAT(
      faults_of([&] {
        load_toml(
            "[[object]]\nasset = 'street.glb'\nfoo = 1\n[[object]]\nasset = "
            "'street.glb'\n");
      }),
      ElementsAre(HasSubstr("scene.toml:3:1: object \"object_1\": unknown key \"foo\""),
                  "street.glb:/nodes/1/extras/restframe/velocity: node \"tram\": |velocity| "
                  "is 2, must be below 1"));
}

}  // namespace
}  // namespace restframe
