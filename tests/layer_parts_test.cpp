// The layers that the beauty is the sum of, by the way that light came: together they are all of it,
// whatever else is asked for.

#include <cmath>
#include <cstring>

#include "support/lit_walls.h"
#include "support/picture_parts.h"

namespace restframe {
namespace {

std::string ball(const std::string& name, const Vec3& position, const std::string& material,
                 const std::string& more = "") {
  return fmt::format(
      "[[object]]\nname = \"{}\"\nsphere = {{radius = 0.5, fineness = 3}}\nposition = {}\nmaterial "
      "= \"{}\"\n{}\n",
      name, toml(position), material, more);
}

const AssetFile kFloor = {"floor.obj", quad_obj({0, -0.5, -2}, {4, 0, 0}, {0, 0, -4})};
const AssetFile kLamp = {"lamp.obj", quad_obj({1, 2.2, -1}, {0.4, 0, 0}, {0, 0, 0.4})};
const AssetFile kPane = {"pane.obj", quad_obj({-0.4, 0.3, 1.2}, {0.3, 0, 0}, {0, 0.3, 0})};
const AssetFile kSheet = {"sheet.obj", quad_obj({0.5, 0.4, 1}, {0.3, 0, 0}, {0, 0.3, 0})};

// Everything that shines and scatters, at several velocities.
std::string everything(const std::string& render_keys, const std::string& lamp_keys = "") {
  return camera_at({0, 0.3, 3.5}, 0.9, "samples = 8\ndepth = 5\n" + render_keys) +
         placed("floor", "clay") + placed("lamp", "lamp") + placed("pane", "haze") +
         placed("sheet", "sheet") +
         ball("gold", {-1.1, 0, -0.5}, "gold", "velocity = [0.3, 0, 0]") +
         ball("glass", {0.1, 0, 0}, "glass") +
         ball("velvet", {1.2, 0, -0.5}, "velvet", "velocity = [0, 0, 0.5]") +
         material("clay", "base_color = [0.8, 0.5, 0.2]\nmetallic = 0\nroughness = 0.5") +
         material("lamp", "emission = [8, 6, 4]\nbase_color = \"black\"\n" + lamp_keys) +
         material("haze", "opacity = 0.4\nbase_color = \"red\"\nunlit = true") +
         material("sheet",
                  "metallic = 0\nroughness = 0.3\ntransmission = 0.7\nthin_walled = true\n"
                  "base_color = [0.7, 0.9, 0.7]") +
         material("gold", "base_color = [0.9, 0.6, 0.2]\nmetallic = 1\nroughness = 0.3") +
         material("glass", "metallic = 0\nroughness = 0\ntransmission = 1") +
         material("velvet",
                  "base_color = [0.3, 0.1, 0.1]\nmetallic = 0\nroughness = 0.6\nclearcoat = 0.5\n"
                  "sheen_color = [0.5, 0.2, 0.2]\nsheen_roughness = 0.5") +
         "[[light]]\ntype = \"point\"\nposition = [-2, 2, 1]\nintensity = 5\ngroup = \"key\"\n"
         "[[light]]\ntype = \"spot\"\nposition = [2, 2, 2]\ndirection = [-1, -1, -1]\nintensity = "
         "9\nvelocity = [0, 0.4, 0]\ngroup = \"fill\"\n"
         "[[light]]\ntype = \"sun\"\ndirection = [0.2, -1, -0.3]\nintensity = 0.7\n"
         "[[light]]\ntype = \"environment\"\nintensity = 0.2\ngroup = \"sky\"\n";
}

Scene everything_of(const std::string& render_keys, const std::string& lamp_keys = "") {
  return loaded_scene(everything(render_keys, lamp_keys), {kFloor, kLamp, kPane, kSheet});
}

void expect_parts(const Scene& scene) {
  const Picture picture = first_picture(with_parts(scene));
  expect_sum(picture, way_names);
  expect_sum(picture, {"light_rest", "light_key", "light_fill", "light_sky"});
  for (const std::string& way : way_names) {
    for (const Vec3& color : colors_of(picture, way)) {
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(color[c])) << way;
    }
    EXPECT_GT(mean_of(colors_of(picture, way)).y, 1e-3) << way;
  }
}

TEST(LayerParts, AreTheBeauty) {
  expect_parts(everything_of(""));
}

TEST(LayerParts, AreTheBeautyOfWhatBeams) {
  expect_parts(everything_of("beaming = true"));
}

// Light by wavelength, with lines that are not among a path's wavelengths.
TEST(LayerParts, AreTheBeautyWhereColorsShift) {
  expect_parts(everything_of("doppler = true"));
  expect_parts(everything_of("doppler = true\nbeaming = true", "emission_temperature = 3000"));
  expect_parts(everything_of("doppler = true", "emission_lines = [[589, 0.02], [500, 0.01, 5]]"));
}

TEST(LayerParts, AreTheBeautyOfExposures) {
  Scene scene = everything_of("");
  scene.exposure = {0.3, ShutterShape::triangle, {}, 3, 0.5, Combine::sum};
  expect_parts(scene);
  scene.exposure.combine = Combine::mean;
  expect_parts(scene);
}

TEST(LayerParts, AreTheBeautyThatStopsWhereItIsSure) {
  Scene scene = everything_of("");
  scene.render.samples = 64;
  scene.render.noise = 0.2;
  expect_parts(scene);
  scene.exposure = {0.1, ShutterShape::box, {}, 2, 0.5, Combine::mean};
  expect_parts(scene);
}

// Asking for parts changes no bit of the beauty, nor of other layers.
TEST(LayerParts, LeaveTheRestAlone) {
  for (const char* keys : {"", "doppler = true", "integrator = \"preview\""}) {
    std::string text = everything("");
    if (*keys != 0) {
      const bool other = std::string_view(keys).starts_with("integrator");
      const std::string was = other ? "integrator = \"path\"" : "depth = 5";
      text.replace(text.find(was), was.size(), other ? keys : was + "\n" + keys);
    }
    Scene scene = loaded_scene(text, {kFloor, kLamp, kPane, kSheet});
    scene.output.layers = {Layer::beauty, Layer::z};
    const Picture alone = first_picture(scene);
    scene = with_parts(scene);
    scene.output.layers.push_back(Layer::z);
    scene.output.layers.push_back(Layer::motion);
    const Picture with = first_picture(scene);
    EXPECT_EQ(
        std::memcmp(alone.rgba().data(), with.rgba().data(), alone.rgba().size() * sizeof(Vec4f)),
        0)
        << keys;
    EXPECT_EQ(channel_of(alone, "Z"), channel_of(with, "Z"));
  }
}

// Parts without the beauty are what they are with it.
TEST(LayerParts, StandAlone) {
  Scene scene = with_parts(everything_of(""));
  const Picture all = first_picture(scene);
  scene.output.layers = {Layer::reflection};
  EXPECT_EQ(colors_of(first_picture(scene), "reflection"), colors_of(all, "reflection"));
}

// A window of a picture has the parts that the whole has there; one beyond it has its own.
TEST(LayerParts, OfACropAreThoseOfTheWhole) {
  Scene scene = with_parts(everything_of(""));
  scene.render.overscan = 3;
  const Picture whole = first_picture(scene);
  expect_sum(whole, way_names);
  scene.render.crop = PixelWindow{-2, 3, 7, 5};
  const Picture crop = first_picture(scene);
  ASSERT_EQ(crop.rgba().size(), 35U);
  for (const std::string& way : way_names) {
    const std::vector<Vec3> all = colors_of(whole, way), some = colors_of(crop, way);
    for (std::size_t i = 0; i < some.size(); ++i) {
      EXPECT_EQ(some[i], all[(i / 7 + 3 + 3) * 18 + i % 7 - 2 + 3]) << way << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace restframe
