// Scenes that invite hangs, crashes and values that are no numbers; and the same bytes whatever the
// threads.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "support/file_bytes.h"
#include "support/path_scene.h"

namespace restframe {
namespace {

std::string stage(const std::string& render, const std::string& camera_keys) {
  return fmt::format(
      "[render]\nresolution = [32, 24]\nintegrator = \"path\"\n{}\n[output]\npreview = false\n"
      "[camera]\n{}\n",
      render, camera_keys);
}

const std::string kOutside = "position = [0, 0.5, 4]\nlook_at = [0, 0, 0]\nfov = 50";

std::string ball(const std::string& keys, const std::string& material_keys) {
  static int count = 0;
  const std::string name = fmt::format("m{}", ++count);
  return fmt::format(
      "[[object]]\nsphere = {{fineness = 3}}\nmaterial = \"{0}\"\n{1}\n[[material]]\nname = "
      "\"{0}\"\n{2}\n",
      name, keys, material_keys);
}

std::string lamp(const std::string& position, const std::string& keys = "intensity = 20") {
  return fmt::format("[[light]]\ntype = \"point\"\nposition = {}\n{}\n", position, keys);
}

const std::string kSky = "[[light]]\ntype = \"environment\"\n";
const std::string kGlass = "metallic = 0\nroughness = 0\ntransmission = 1\n";
const std::string kClay = "metallic = 0\nroughness = 1\n";

// It renders, in time, and every value is a number and not negative.
void expect_fine(const std::string& text, const std::vector<AssetFile>& assets = {}) {
  const PathRender render = run_path(text, assets);
  ASSERT_FALSE(render.result.timed_out) << text;
  ASSERT_EQ(render.result.exit_code, 0) << render.result.error << text;
  const ExrPicture picture = render.picture();
  for (const char* channel : {"R", "G", "B", "A"}) {
    for (const float value : picture.channel(channel)) {
      ASSERT_TRUE(std::isfinite(value) && value >= 0) << channel << ' ' << value << '\n' << text;
    }
  }
}

// Embree's rtcOccluded16 with its coherent flag did not come back from shadow rays of a floor like
// this.
TEST(PathRobustness, ShadowsOnAHugeFloorComeBack) {
  expect_fine(
      "[camera]\nposition = [0, 1.2, 5]\nlook_at = [0, 0.6, 0]\nfov = 45\n"
      "[render]\nresolution = [160, 90]\nsamples = 8\nintegrator = \"path\"\ndepth = 8\n"
      "[output]\npreview = false\n"
      "[[object]]\nsphere = {radius = 1000, fineness = 6}\nposition = [0, -1000.5, -3]\n"
      "material = \"clay\"\n"
      "[[material]]\nname = \"clay\"\nbase_color = \"#bbbbbb\"\nmetallic = 0\n" +
      ball("scale = 0.7\nposition = [-1.2, 0.4, 0]", "metallic = 1\nroughness = 0") +
      ball("scale = 0.7\nposition = [0.6, 0.4, 0.8]", kGlass) +
      ball("scale = 0.5\nposition = [0, 0.2, -1.5]\nvelocity = [0.9, 0, 0]\ntime = -6",
           "metallic = 0\nroughness = 0.3") +
      lamp("[2, 4, 3]") + kSky);
}

TEST(PathRobustness, GlassOfAnySort) {
  const std::string open =
      "[[object]]\nasset = \"quad.obj\"\nmaterial = \"pane\"\n[[material]]\n"
      "name = \"pane\"\n" +
      kGlass;
  const AssetFile quad = {"quad.obj", quad_obj({0, 0, 1}, {0.7, 0, 0.2}, {0, 0.7, 0})};
  for (const char* camera : {"position = [0, 0.5, 4]\nlook_at = [0, 0, 0]",
                             "position = [0.1, 0.2, 0.3]\nlook_at = [0, 0, 0]",
                             "position = [0, 0, 1]\nvelocity = [0, 0, 0.6]"}) {
    for (const int depth : {1, 2, 64}) {
      const std::string begin = stage(fmt::format("samples = 4\ndepth = {}", depth), camera);
      const std::string end = lamp("[2, 3, 2]") + kSky;
      expect_fine(begin + open + ball("", kGlass + "ior = 1.5") + end, {quad});
      expect_fine(begin + ball("", kGlass) + ball("", kGlass + "ior = 2") + end);
      expect_fine(begin +
                  ball("", kGlass + "ior = 1e6\nattenuation_color = \"black\"\n"
                                    "attenuation_distance = 1e-9") +
                  ball("position = [0.5, 0, 0]", kGlass + "ior = 1") + end);
    }
  }
}

TEST(PathRobustness, ManyMediaInOneAnother) {
  for (const int count : {7, 8, 9, 14}) {
    std::string text = stage("samples = 4\ndepth = 64", kOutside) + kSky + lamp("[2, 3, 2]");
    for (int i = 0; i < count; ++i) {
      text += ball(fmt::format("scale = {}", 1 - 0.05 * i),
                   kGlass + fmt::format("ior = {}", 1 + 0.1 * (i % 5)));
    }
    expect_fine(text + ball("scale = 0.1", kClay));
  }
}

TEST(PathRobustness, RoughnessFromNoneToAll) {
  for (const char* roughness : {"0", "1e-5", "0.03", "0.032", "0.1", "1"}) {
    std::string text = stage("samples = 8", kOutside) + kSky + lamp("[2, 3, 2]");
    int x = -2;
    for (const char* kind : {"metallic = 1", "metallic = 0", "metallic = 0\ntransmission = 1",
                             "metallic = 0.5\ntransmission = 0.5\nior = 1"}) {
      text += ball(fmt::format("scale = 0.5\nposition = [{}, 0, 0]", x++),
                   fmt::format("{}\nroughness = {}", kind, roughness));
    }
    expect_fine(text);
  }
}

TEST(PathRobustness, LightsInOddPlaces) {
  const std::string floor =
      "[[object]]\nasset = \"floor.obj\"\nmaterial = \"clay\"\n"
      "[[material]]\nname = \"clay\"\n" +
      kClay;
  const AssetFile quad = {"floor.obj", quad_obj({0, -1, 0}, {0, 0, 9}, {9, 0, 0})};
  const std::string begin = stage("samples = 4\nbeaming = true", kOutside) + floor;
  for (const char* place : {"[0, -1, 0]", "[0, -1.0000001, 0]", "[0, 1, 0]", "[0, 0.5, 4]",
                            "[0, 0, 0]", "[1e15, 1e15, 0]", "[0, 1e-300, 0]"}) {
    expect_fine(begin + ball("", kClay) + lamp(place), {quad});
  }
  for (const char* keys :
       {"gamma = 1e8\nmotion = [0, -1, 0]", "gamma = 1000\nmotion = [0.1, 1, 0]",
        "intensity = 3e38", "intensity = 0", "color = \"black\"", "intensity = 1e-40"}) {
    expect_fine(begin + ball("", kClay) + lamp("[0, 3, 0]", keys), {quad});
    expect_fine(
        begin + ball("velocity = [0.999999, 0, 0]\ntime = -4", kClay) + lamp("[0, 3, 0]", keys),
        {quad});
  }
}

TEST(PathRobustness, SpotsAndSunsInOddDirections) {
  const std::string begin = stage("samples = 2", kOutside) + ball("", kClay);
  for (const char* cone : {"[0, 90]", "[0, 1e-9]", "[30, 30]", "[90, 90]"}) {
    expect_fine(begin + fmt::format("[[light]]\ntype = \"spot\"\nposition = [0, 3, 0]\n"
                                    "direction = [0, -1, 0]\ncone = {}\n"
                                    "sweep = {{axis = [0, 1, 0], period = 1e-12}}\n",
                                    cone));
  }
  for (const char* direction : {"[0, 0, 1]", "[0, 1e-9, -1]", "[1e-200, 0, 0]"}) {
    expect_fine(begin + fmt::format("[[light]]\ntype = \"sun\"\ndirection = {}\n"
                                    "gamma = 1e6\nmotion = [0, 0, 1]\n",
                                    direction));
  }
}

// A sphere of light-years, one of a picometre, and everything at gamma = 1000.
TEST(PathRobustness, ExtremeSizesAndSpeeds) {
  const std::string begin =
      stage("samples = 2\nbeaming = true", kOutside) + lamp("[0, 3, 0]") + kSky;
  for (const std::string& material : {kGlass, kClay, std::string("roughness = 0")}) {
    expect_fine(begin + ball("scale = 1e9\nposition = [0, -1.0000000003e9, 0]", material));
    expect_fine(begin + ball("scale = 1e-12", material));
    expect_fine(begin + ball("gamma = 1000\ndirection = [0, 0, 1]\ntime = -4", material));
    expect_fine(begin + ball("gamma = 1e6\ndirection = [1, 0, 0]\ntime = -4", material));
  }
}

TEST(PathRobustness, MaterialsThatChangeAllTheTime) {
  const auto wave = [](const char* key, const char* formula) {
    return fmt::format("{} = {{formula = \"{}\"}}\n", key, formula);
  };
  expect_fine(stage("samples = 4", kOutside) + lamp("[0, 3, 2]") + kSky +
              ball("", wave("roughness", "0.5 + 0.5 * sin(50 * t)") +
                           wave("ior", "1.5 + 0.5 * sin(70 * t)") +
                           wave("transmission", "0.5 + 0.5 * sin(60 * t)") +
                           wave("metallic", "0.5 + 0.5 * sin(40 * t)") +
                           wave("opacity", "0.5 + 0.5 * sin(30 * t)") +
                           wave("emission_strength", "2 + sin(20 * t)") + "emission = \"red\"\n"));
}

TEST(PathRobustness, HundredsOfHalfTransparentLayers) {
  std::string quads;
  for (int i = 0; i < 300; ++i) {
    const int first = 4 * i + 1;
    for (const char* corner : {"-1 -1", "1 -1", "1 1", "-1 1"}) {
      quads += fmt::format("v {} {:.6g}\n", corner, -0.01 * i);
    }
    quads += fmt::format("f {} {} {} {}\n", first, first + 1, first + 2, first + 3);
  }
  expect_fine(stage("samples = 2", kOutside) + lamp("[0, 1, -6]") + kSky +
                  "[[object]]\nasset = \"veils.obj\"\nmaterial = \"veil\"\n[[material]]\nname = "
                  "\"veil\"\nopacity = 0.01\n" +
                  kClay + ball("position = [0, 0, -5]", kClay),
              {{"veils.obj", quads}});
}

// Paths, blur, lens and glass.
TEST(PathRobustness, ThreadsDoNotMatter) {
  const std::string text =
      stage("samples = 8",
            "position = [0, 0.5, 4]\nlook_at = [0, 0, 0]\naperture = 0.1\nfocus = 4\n"
            "velocity = [0.1, 0, 0]") +
      "[exposure]\nshutter = 0.5\ncount = 2\n" + ball("", kGlass) +
      ball("position = [1, 0, -1]\nvelocity = [0.7, 0, 0.1]", "roughness = 0.3\nopacity = 0.5") +
      ball("position = [0, -9, 0]\nscale = 8", kClay) + lamp("[2, 3, 2]") + kSky;
  std::vector<std::string> all;
  for (const char* threads : {"1", "2", "5"}) {
    const PathRender render = run_path(text, {}, {"--threads", threads});
    ASSERT_EQ(render.result.exit_code, 0) << render.result.error;
    all.push_back(bytes_of(render.folder->path() / "picture.0000.exr"));
  }
  EXPECT_FALSE(all[0].empty());
  EXPECT_EQ(all[0], all[1]);
  EXPECT_EQ(all[0], all[2]);
}

}  // namespace
}  // namespace restframe
