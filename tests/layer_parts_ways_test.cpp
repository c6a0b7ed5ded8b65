// The layers that the beauty is the sum of, by the way that light came: what is in which.

#include <cmath>
#include <numbers>

#include "support/lit_walls.h"
#include "support/picture_parts.h"

namespace restframe {
namespace {

constexpr double pi = std::numbers::pi;

TEST(LayerParts, MirrorsReflectAll) {
  for (const char* roughness : {"0", "0.4"}) {
    const Scene scene = loaded_scene(
        camera_at({0, 0, 3}, 0.2, "samples = 4\ndepth = 3") + placed("wall", "mirror") +
            material("mirror", fmt::format("metallic = 1\nroughness = {}", roughness)) +
            "[[light]]\ntype = \"environment\"\n[[light]]\ntype = \"point\"\nposition = [1, 1, "
            "2]\n",
        {{"wall.obj", quad_obj({0, 0, 0}, {3, 0, 0}, {0, 3, 0})}});
    const Picture picture = first_picture(with_parts(scene));
    EXPECT_GT(mean_of(beauty_of(picture)).y, 0.5);
    expect_all_in(picture, "reflection");
  }
}

// A Lambert wall under a point light: base/pi I cos / r^2, all of it direct.
TEST(LayerParts, DiffuseLightOfALampIsDirect) {
  const Scene scene =
      loaded_scene(camera_at({0, 0, 3}, 0.6, "samples = 1\ndepth = 3") + placed("wall", "clay") +
                       diffuse_material("clay", 0.7) +
                       "[[light]]\ntype = \"point\"\nposition = [0.5, 0.2, 2]\nintensity = 3\n",
                   {{"wall.obj", quad_obj({0, 0, 0}, {9, 0, 0}, {0, 9, 0})}});
  const Picture picture = first_picture(with_parts(scene));
  expect_all_in(picture, "direct");
  std::vector<Vec3> expected;
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) {
      const double side = 3 * std::tan(0.3) / 6;
      const Vec3 to_lamp = Vec3(0.5, 0.2, 2) - Vec3((x + 0.5 - 6) * side, (6 - y - 0.5) * side, 0);
      expected.emplace_back(0.7 / pi * 3 * to_lamp.z / std::pow(glm::length(to_lamp), 3));
    }
  }
  expect_same_colors(colors_of(picture, "direct"), expected, 1e-4);
}

// Of light that goes to and fro between grey walls that glow, the surface seen has emitted 1, of
// what its walls emit it has scattered the part g once, and all the rest after other walls.
TEST(LayerParts, OfAFurnaceAreItsSeries) {
  const double grey = 0.6;
  const int depth = 4;
  Scene scene = loaded_scene(
      camera_at({0.3, 0.2, 1}, 0.9, fmt::format("samples = 64\ndepth = {}", depth)) +
          placed("room", "room") + diffuse_material("room", grey) + "emission = [1.5, 1.5, 1.5]\n",
      {{"room.obj", box_obj({-30, -25, -40}, {35, 40, 30})}});
  material_of(scene, "room").double_sided = true;
  const Picture picture = first_picture(with_parts(scene));
  const double all = (1 - std::pow(grey, depth + 1)) / (1 - grey);
  EXPECT_NEAR(mean_of(colors_of(picture, "emission")).y, 1.5, 1e-5);
  EXPECT_NEAR(mean_of(colors_of(picture, "direct")).y, 1.5 * grey, 5e-3);
  EXPECT_NEAR(mean_of(colors_of(picture, "indirect")).y, 1.5 * (all - 1 - grey), 5e-3);
  EXPECT_NEAR(mean_of(colors_of(picture, "reflection")).y, 0, 1e-6);
  EXPECT_NEAR(mean_of(colors_of(picture, "transmission")).y, 0, 1e-6);
}

// A body and a sheet of clear glass before a sky: straight on, the part ((n - 1) / (n + 1))^2 is
// reflected by the first surface.
TEST(LayerParts, GlassReflectsAndLetsThrough) {
  for (const char* keys : {"", "thin_walled = true"}) {
    const Scene scene = loaded_scene(
        camera_at({0, 0, 3}, 0.02, "samples = 256\ndepth = 30") + placed("slab", "glass") +
            material("glass",
                     fmt::format("metallic = 0\nroughness = 0\ntransmission = 1\n{}", keys)) +
            "[[light]]\ntype = \"environment\"\n",
        {{"slab.obj", box_obj({-5, -5, -1}, {5, 5, 0})}});
    const Picture picture = first_picture(with_parts(scene));
    const double error = std::sqrt(0.04 * 0.96 / (256 * 144));
    EXPECT_NEAR(mean_of(beauty_of(picture)).y, 1, 1e-3) << keys;
    EXPECT_NEAR(mean_of(colors_of(picture, "reflection")).y, 0.04, 5 * error) << keys;
    EXPECT_NEAR(mean_of(colors_of(picture, "transmission")).y, 0.96, 5 * error) << keys;
  }
}

// Plastic as smooth as a mirror under a white sky: gloss by Schlick's formula at 60 degrees, and what
// it leaves is scattered below.
TEST(LayerParts, GlossAndBodyOfPlasticAreApart) {
  const Scene scene = loaded_scene(
      camera_at({0, 0, 0}, 0.02, "samples = 256\ndepth = 1") + placed("wall", "plastic") +
          material("plastic", "base_color = [1, 0.5, 0.25]\nmetallic = 0\nroughness = 0") +
          "[[light]]\ntype = \"environment\"\n",
      {{"wall.obj", quad_obj({0, 0, -3}, {50, 0, 0}, 50.0 * Vec3(0, 0.5, -std::sqrt(0.75)))}});
  const double cosine = std::cos(pi / 3);
  const double gloss = 0.04 + 0.96 * std::pow(1 - cosine, 5);
  const Picture picture = first_picture(with_parts(scene));
  const double error = 1 / std::sqrt(256.0 * 144.0);
  EXPECT_NEAR(mean_of(colors_of(picture, "reflection")).y, gloss, 3 * error);
  const Vec3 direct = mean_of(colors_of(picture, "direct"));
  EXPECT_NEAR(direct.x, 1 - gloss, 3 * error);
  EXPECT_NEAR(direct.y, 0.5 * (1 - gloss), 3 * error);
  EXPECT_NEAR(mean_of(colors_of(picture, "indirect")).y, 0, 1e-6);
  EXPECT_NEAR(mean_of(colors_of(picture, "albedo")).y, 0.5, 1e-6);
}

// A wall of rough plastic. Its gloss is that of black plastic, whatever its own colour.
Scene plastic_wall(const std::string& color, const std::string& render_keys,
                   const std::string& lights, const std::string& more = "") {
  return loaded_scene(
      camera_at({0, 0, 3}, 0.9, "depth = 1\n" + render_keys) +
          placed("wall", "plastic", "velocity = [0.3, 0, 0.05]") +
          material("plastic", fmt::format("base_color = {}\nmetallic = 0\nroughness = 0.4\n"
                                          "specular_color = [1, 0.7, 0.4]\n{}",
                                          color, more)) +
          lights,
      {{"wall.obj", quad_obj({0, 0, 0}, {3, 0, 0}, {0, 3, 0})}});
}

// Light of one direction is shared among the lobes, whatever its spectrum.
TEST(LayerParts, SharesOfLampsAreThoseOfEachLobeAlone) {
  const std::string lamp =
      "[[light]]\ntype = \"point\"\nposition = [0.4, 0.3, 2.5]\nintensity = 100\n";
  for (const std::string keys : {"", "beaming = true", "doppler = true"}) {
    for (const std::string spectrum :
         {"", "temperature = 3000\n", "lines = [[589, 1], [470, 0.5, 8]]\n"}) {
      SCOPED_TRACE(keys + spectrum);
      const std::string render = "samples = 2\n" + keys;
      for (const char* more : {"", "clearcoat = 0.5\nclearcoat_roughness = 0.3"}) {
        const Picture painted = first_picture(
            with_parts(plastic_wall("[0.8, 0.5, 0.2]", render, lamp + spectrum, more)));
        const Picture black =
            first_picture(plastic_wall("\"black\"", render, lamp + spectrum, more));
        const std::vector<Vec3> gloss = beauty_of(black);
        EXPECT_GT(glm::length(mean_of(gloss)), 1e-3);
        EXPECT_GT(glm::length(mean_of(colors_of(painted, "direct"))), 1e-3);
        expect_same_colors(colors_of(painted, "reflection"), gloss, 1e-4);
        expect_sum(painted, way_names);
      }
    }
  }
}

// What paths find by chance, lobe by lobe, has the same means.
TEST(LayerParts, SharesOfSkiesAreThoseOfEachLobeAlone) {
  for (const std::string keys : {"", "doppler = true"}) {
    for (const std::string spectrum : {"", "lines = [[589, 1]]\n"}) {
      SCOPED_TRACE(keys + spectrum);
      const std::string sky = "[[light]]\ntype = \"environment\"\n" + spectrum;
      const std::string render = "samples = 128\n" + keys;
      const Picture painted =
          first_picture(with_parts(plastic_wall("[0.8, 0.5, 0.2]", render, sky)));
      const Picture black = first_picture(plastic_wall("\"black\"", render, sky));
      const Vec3 gloss = mean_of(beauty_of(black));
      const Vec3 reflection = mean_of(colors_of(painted, "reflection"));
      EXPECT_GT(gloss.x, 1e-3);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(reflection[c], gloss[c], 0.05 * std::abs(gloss[c]));
    }
  }
}

// Fibres are no gloss.
TEST(LayerParts, VelvetIsMatte) {
  const Picture picture = first_picture(with_parts(plastic_wall(
      "\"black\"", "samples = 16",
      "[[light]]\ntype = \"environment\"\n[[light]]\ntype = \"point\"\nposition = [0, 0, 2]\n",
      "specular = 0\nsheen_color = [0.9, 0.6, 0.3]\nsheen_roughness = 0.5")));
  EXPECT_GT(mean_of(beauty_of(picture)).y, 0.01);
  expect_all_in(picture, "direct");
}

// What glows behind a veil, and the veil itself: each by the part of it that is seen.
TEST(LayerParts, EmittersBehindVeilsAreSeenStraight) {
  for (const char* integrator : {"path", "preview"}) {
    std::string text =
        camera_at({0, 0, 3}, 0.02, "samples = 256") + placed("veil", "veil") +
        placed("wall", "lamp") +
        material("veil", "base_color = [1, 0, 0]\nunlit = true\nopacity = 0.25") +
        material("lamp", "base_color = [0, 0, 0]\nmetallic = 1\nemission = [0, 3, 0]");
    const std::string was = "integrator = \"path\"";
    text.replace(text.find(was), was.size(), fmt::format("integrator = \"{}\"", integrator));
    const Scene scene =
        loaded_scene(text, {{"veil.obj", quad_obj({0, 0, 1}, {1, 0, 0}, {0, 1, 0})},
                            {"wall.obj", quad_obj({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}});
    const Picture picture = first_picture(with_parts(scene));
    expect_all_in(picture, "emission");
    const Vec3 seen = mean_of(colors_of(picture, "emission"));
    EXPECT_NEAR(seen.x, 0.25, 0.02) << integrator;
    EXPECT_NEAR(seen.y, 2.25, 0.06) << integrator;
    EXPECT_NEAR(mean_of(colors_of(picture, "albedo")).x, 0.25, 0.02) << integrator;
  }
}

// Without lights there are two parts, what glows and the rest.
TEST(LayerParts, OfPreviewsAreTwo) {
  const auto text = [](const std::string& keys) {
    return "[camera]\nposition = [0, 0, 3]\nfov = 40\n[render]\nresolution = [12, 12]\n" + keys +
           "\n[[object]]\nname = \"ball\"\nsphere = {radius = 1, fineness = 3}\nvelocity = [0, 0, "
           "0.4]\nmaterial = \"glow\"\n[[material]]\nname = \"glow\"\nbase_color = [0.5, 0.25, "
           "1]\nemission = [0.125, 0.5, 0]\nopacity = 0.5\n";
  };
  for (const char* keys : {"", "doppler = true", "beaming = true"}) {
    Scene scene = loaded_scene(text(keys));
    const Picture picture = first_picture(with_parts(scene));
    expect_sum(picture, way_names);
    expect_sum(picture, {"light_rest"});
    const std::size_t middle = 12 * 6 + 6;
    if (*keys == 0) {
      const Vec3 glow = colors_of(picture, "emission")[middle];
      EXPECT_LT(glm::length(glow - Vec3(0.0625, 0.25, 0)), 1e-6);
    }
    EXPECT_NEAR(colors_of(picture, "albedo")[middle].z, 0.5, 1e-6) << keys;
    EXPECT_EQ(mean_of(colors_of(picture, "indirect")), Vec3(0));
    material_of(scene, "glow").base_color.value = Vec3f(0);
    expect_same_colors(beauty_of(first_picture(scene)), colors_of(picture, "emission"), 1e-5);
  }
}

// The albedo is the base colour of what is hit, metal or not, white for glass, and 0 for a sky.
TEST(Albedo, IsTheColorOfTheFirstSurface) {
  const auto albedo_of = [](const std::string& keys, const std::string& more = "") {
    Scene scene =
        loaded_scene(camera_at({0, 0, 3}, 0.02, "samples = 2") + placed("wall", "paint") +
                         material("paint", keys) + "[[light]]\ntype = \"environment\"\n" + more,
                     {{"wall.obj", box_obj({-1, -1, -1}, {1, 1, 0})}});
    scene.output.layers = {Layer::albedo};
    return mean_of(colors_of(first_picture(scene), "albedo"));
  };
  const std::string paint = "base_color = [0.25, 0.5, 1]\n";
  const Vec3 color(0.25, 0.5, 1);
  for (const char* keys : {"metallic = 0", "metallic = 1", "unlit = true", "emission = [9, 9, 9]",
                           "clearcoat = 1", "sheen_color = [1, 1, 1]"}) {
    EXPECT_LT(glm::length(albedo_of(paint + keys) - color), 1e-6) << keys;
  }
  EXPECT_LT(glm::length(albedo_of(paint + "metallic = 0\ntransmission = 1") - Vec3(1)), 1e-6);
  // Of several exposures it is the mean, however their light goes together.
  EXPECT_LT(glm::length(albedo_of(paint, "[exposure]\ncount = 3\n") - color), 1e-6);
}

}  // namespace
}  // namespace restframe
