// Pictures of each of glTF's material extensions: a surface across the sight line under a white sky,
// whose brightness is what the surface scatters in all, and under a sun.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/gltf_builder.h"
#include "support/path_scene.h"
#include "tracer/bsdf.h"
#include "tracer/bsdf_albedo.h"

namespace restframe {
namespace {

using nlohmann::json;

constexpr double kPi = std::numbers::pi;
const std::string kSky = "[[light]]\ntype = \"environment\"\n";

// What fills the picture, seen straight on from z = 1 through a narrow lens.
Vec3 mean_of(const std::string& rest, const std::vector<AssetFile>& assets, int samples = 256) {
  reference::ObserverCamera camera;
  camera.position = {0, 0, 1};
  camera.width = camera.height = 8;
  camera.vertical_fov = 0.02;
  const ExrPicture picture = path_pictures(
      camera_text(camera, fmt::format("samples = {}\ndepth = 6\nbeaming = true", samples)) + rest,
      assets)[0];
  Vec3 sum(0);
  for (std::size_t i = 0; i < picture.channel("G").size(); ++i) {
    sum += Vec3(picture.channel("R")[i], picture.channel("G")[i], picture.channel("B")[i]);
  }
  return sum / static_cast<double>(picture.channel("G").size());
}

// A wall of a material that says this besides being no metal.
Vec3 wall(const std::string& material, const std::string& light, int samples = 256) {
  const AssetFile quad = {"wall.obj", quad_obj({0, 0, 0}, {1, 0, 0}, {0, 1, 0})};
  return mean_of(
      "[[object]]\nasset = \"wall.obj\"\nmaterial = \"wall\"\n[[material]]\nname = "
      "\"wall\"\nmetallic = 0\n" +
          material + "\n" + light,
      {quad}, samples);
}

// Black, smooth, under the sky.
Vec3 black_wall(const std::string& more) {
  return wall("base_color = \"black\"\nroughness = 0\n" + more, kSky);
}

// A quad of 2 x 2 around the origin, its front along +z, all of whose texture coordinates are those
// of one texel.
AssetFile textured_wall(const json& material, const std::vector<std::string>& texels) {
  test::GltfBuilder builder;
  for (const std::string& texel : texels) {
    const std::string dot = test::png(1, 1, texel);
    const int view = builder.add_view(dot.data(), dot.size());
    const int image = builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    builder.add("textures", {{"source", image}});
  }
  const int positions = builder.add_accessor<float>(
      {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3");
  const int uv = builder.add_accessor<float>(std::vector<float>(12, 0.5F), "VEC2");
  builder.add_mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uv}}},
                    {"material", builder.add("materials", material)}});
  return {"wall.glb", builder.glb()};
}

Vec3 seen_textured(const json& extensions, const std::vector<std::string>& texels,
                   const json& base = {0, 0, 0, 1}) {
  json material = {{"pbrMetallicRoughness",
                    {{"baseColorFactor", base}, {"metallicFactor", 0}, {"roughnessFactor", 0}}},
                   {"extensions", extensions}};
  return mean_of("[[object]]\nasset = \"wall.glb\"\n" + kSky, {textured_wall(material, texels)});
}

std::string texel(int r, int g, int b, int a) {
  return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(a)};
}

void expect_color(const Vec3& color, const Vec3& expected, double tolerance) {
  EXPECT_LT(glm::length(color - expected), tolerance)
      << color.x << ' ' << color.y << ' ' << color.z;
}

TEST(Materials, ClearcoatReflectsFourPercent) {
  expect_color(black_wall("ior = 1"), Vec3(0), 1e-6);
  expect_color(black_wall("ior = 1\nclearcoat = 1"), Vec3(0.04), 1e-4);
  expect_color(black_wall("ior = 1\nclearcoat = 0.5"), Vec3(0.02), 1e-4);
}

// What shines below shines through it.
TEST(Materials, ClearcoatIsOverTheSurfacesOwnLight) {
  expect_color(wall("emission = [1, 2, 3]\nclearcoat = 1", "", 4), 0.96 * Vec3(1, 2, 3), 1e-3);
}

TEST(Materials, SpecularChangesTheGloss) {
  expect_color(black_wall(""), Vec3(0.04), 1e-4);
  expect_color(black_wall("specular = 0"), Vec3(0), 1e-6);
  expect_color(black_wall("specular = 0.5\nspecular_color = [2, 1, 0.5]"), Vec3(0.04, 0.02, 0.01),
               1e-4);
}

// As in closed form: of light that meets a rough sheet straight from behind, seen straight on. D is
// 1/pi, 96% of the light passes, 1 - ln 2 of it without being scattered again.
TEST(Materials, SheetsAreLitFromBehind) {
  const Vec3 lit =
      wall("base_color = [1, 0.5, 0.25]\nroughness = 1\ntransmission = 1\nthin_walled = true",
           "[[light]]\ntype = \"sun\"\ndirection = [0, 0, 1]\nintensity = 1\n", 4);
  const double expected = 0.96 / (4 * kPi) / (1 - std::log(2.0));
  expect_color(lit, expected * Vec3(1, 0.5, 0.25), 0.01 * expected);
}

TEST(Materials, SheetsTintWhatIsBehind) {
  expect_color(seen_textured({{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}, {},
                             {0.5, 1, 0, 1}),
               Vec3(0.04) + 0.96 * Vec3(0.5, 1, 0), 5e-3);
}

TEST(Materials, TexturesMultiplyByTheirChannels) {
  const json first = {{"index", 0}};
  // Red: what lets light through, black where it does not.
  expect_color(seen_textured({{"KHR_materials_transmission",
                               {{"transmissionFactor", 1}, {"transmissionTexture", first}}}},
                             {texel(51, 255, 0, 255)}, {1, 1, 1, 1}),
               Vec3(1), 5e-3);
  // Alpha: the gloss.
  expect_color(seen_textured({{"KHR_materials_specular", {{"specularTexture", first}}}},
                             {texel(0, 0, 0, 51)}),
               Vec3(0.04 * 0.2), 1e-3);
  // sRGB: its colour.
  expect_color(seen_textured({{"KHR_materials_specular", {{"specularColorTexture", first}}}},
                             {texel(255, 0, 255, 255)}),
               Vec3(0.04, 0, 0.04), 1e-3);
  // Red: the coat; what reflects below it is then seen through it.
  const double coat = 0.2 * 0.04;
  expect_color(seen_textured({{"KHR_materials_clearcoat",
                               {{"clearcoatFactor", 1}, {"clearcoatTexture", first}}},
                              {"KHR_materials_specular", {{"specularFactor", 0}}}},
                             {texel(51, 255, 255, 255)}),
               Vec3(coat), 2e-3);
}

// Green: how rough the coat is. Alpha: how much fibres diverge, and sRGB their colour.
TEST(Materials, RoughnessTexturesMultiplyByTheirChannels) {
  const json first = {{"index", 0}}, second = {{"index", 1}};
  const json dull = {{"specularFactor", 0}};
  const double half = 128.0 / 255;
  const auto alpha = static_cast<float>(half * half);
  expect_color(seen_textured({{"KHR_materials_clearcoat",
                               {{"clearcoatFactor", 1},
                                {"clearcoatRoughnessFactor", 1},
                                {"clearcoatRoughnessTexture", first}}},
                              {"KHR_materials_specular", dull}},
                             {texel(0, 128, 255, 255)}),
               Vec3(static_cast<double>(coat_reflection(1, alpha, 1))), 5e-4);
  const auto fibres = static_cast<double>(fibre_albedo(1, alpha));
  expect_color(seen_textured({{"KHR_materials_sheen",
                               {{"sheenColorFactor", {1, 1, 0.5}},
                                {"sheenColorTexture", first},
                                {"sheenRoughnessFactor", 1},
                                {"sheenRoughnessTexture", second}}},
                              {"KHR_materials_specular", dull}},
                             {texel(255, 0, 255, 255), texel(0, 0, 0, 128)}),
               fibres * Vec3(1, 0, 0.5), 0.03 * fibres);
}

// Whatever lies over what: a white ball in a white furnace is not seen.
TEST(Materials, LoseNothingWhereTheyAreWhite) {
  const std::vector<std::string> materials = {
      "roughness = 0.7\nmetallic = 1\n",
      "roughness = 0.3\nmetallic = 0\n",
      "roughness = 0.5\nmetallic = 0.5\nclearcoat = 1\nclearcoat_roughness = 0.2\n",
      "roughness = 0.9\nmetallic = 0\nsheen_color = \"white\"\nsheen_roughness = 0.5\n",
      "roughness = 0.4\nmetallic = 0\ntransmission = 0.5\nthin_walled = true\nclearcoat = 0.6\n"
      "sheen_color = [0.5, 0.5, 0.5]\nsheen_roughness = 0.7\n",
      "roughness = 0.5\nmetallic = 0\ntransmission = 1\n"};
  for (const std::string& material : materials) {
    reference::ObserverCamera camera;
    camera.position = {0, 0, 3};
    camera.width = camera.height = 16;
    camera.vertical_fov = 0.5;
    const ExrPicture picture = path_pictures(
        camera_text(camera, "samples = 64\ndepth = 64") +
            "[[object]]\nsphere = {radius = 1, fineness = 6}\nmaterial = \"ball\"\n[[material]]\n"
            "name = \"ball\"\nbase_color = \"white\"\n" +
            material + kSky,
        {})[0];
    double sum = 0;
    for (const float value : picture.channel("G")) sum += static_cast<double>(value);
    EXPECT_NEAR(sum / (16 * 16), 1, 0.012) << material;
  }
}

// Velvet is bright at its edges, where varnish is a mirror, and dark where it is met straight on.
TEST(Materials, SheenIsAtTheEdges) {
  reference::ObserverCamera camera;
  camera.position = {0, 0, 6};
  camera.width = camera.height = 24;
  camera.vertical_fov = 0.36;
  const ExrPicture picture = path_pictures(
      camera_text(camera, "samples = 64\ndepth = 4") +
          "[[object]]\nsphere = {radius = 1, fineness = 6}\nmaterial = \"ball\"\n[[material]]\n"
          "name = \"ball\"\nbase_color = \"black\"\nmetallic = 0\nroughness = 1\nior = 1\n"
          "sheen_color = [1, 0.5, 0]\nsheen_roughness = 0.5\n" +
          kSky,
      {})[0];
  const auto at = [&](const char* channel, int x) {
    return static_cast<double>(picture.at(channel, x, 12));
  };
  EXPECT_LT(at("R", 12), 0.05);
  EXPECT_GT(at("R", 2), 0.12);
  EXPECT_NEAR(at("G", 2), 0.5 * at("R", 2), 1e-3);
  EXPECT_EQ(at("B", 2), 0);
}

}  // namespace
}  // namespace restframe
