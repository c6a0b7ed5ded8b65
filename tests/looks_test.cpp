// What assets look like, on pixels: which way axes and textures point, what colours and opacities
// are multiplied, which textures hold colours and which numbers, and mirrored nodes. Where textures
// lie, how they wrap and sRGB itself are in gltf_texture_transform_test.cpp.

#include <gtest/gtest.h>

#include <cmath>

#include "importers/importers.h"
#include "support/direct_render.h"
#include "support/gltf_builder.h"
#include "support/loaded_scene.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using namespace std::string_literals;

constexpr int pixels = 40;
constexpr double byte_188 = 188.0 / 255;

// IEC 61966-2-1, of 188.
double color_188() {
  return std::pow((byte_188 + 0.055) / 1.055, 2.4);
}

Scene scene_of(const GltfBuilder& builder) {
  const TemporaryFolder folder;
  return seen_from_front(folder.write("asset.glb", builder.glb()), pixels);
}

// The pixel that shows (x, y, 0).
Vec4f at(const Picture& picture, double x, double y) {
  const int column = static_cast<int>(pixels * (1 + x) / 2);
  const int row = static_cast<int>(pixels * (1 - y) / 2);
  return picture.rgba().at(static_cast<std::size_t>(row * pixels + column));
}

void expect_near(const Vec4f& pixel, const Vec4f& expected, const char* what = "") {
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(pixel[c], expected[c], 1e-5) << what << ' ' << c;
}

json unlit(const json& material) {
  json result = material;
  result["extensions"]["KHR_materials_unlit"] = json::object();
  return result;
}

// Adds a square across the z axis, its front towards +z, with texture coordinates, and returns its
// mesh.
int add_square(GltfBuilder& builder, float half, int material,
               const std::vector<float>& color = {}) {
  const float h = half;
  json attributes = {
      {"POSITION", builder.add_accessor<float>({-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0}, "VEC3")},
      {"TEXCOORD_0", builder.add_accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2")}};
  if (!color.empty()) {
    std::vector<float> colors;
    for (int i = 0; i < 4; ++i) colors.insert(colors.end(), color.begin(), color.end());
    attributes["COLOR_0"] = builder.add_accessor<float>(colors, "VEC4");
  }
  const int indices = builder.add_accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  return builder.add_mesh(
      {{"attributes", attributes}, {"indices", indices}, {"material", material}});
}

// Texture 0 is a PNG of these bytes, RGBA, its texels sharp.
void add_texture(GltfBuilder& builder, int width, int height, const std::string& rgba) {
  const std::string bytes = test::png(width, height, rgba);
  const int view = builder.add_view(bytes.data(), bytes.size());
  builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  builder.add("samplers", {{"magFilter", 9728}});
  builder.add("textures", {{"source", 0}, {"sampler", 0}});
}

const std::string red = "\xff\0\0\xff"s, green = "\0\xff\0\xff"s, blue = "\0\0\xff\xff"s,
                  white = "\xff\xff\xff\xff"s;

// glTF: right-handed, +y is up, and the front, +z, faces the viewer.
TEST(Looks, AxesOfGltf) {
  GltfBuilder builder;
  const std::vector<std::vector<float>> colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const std::vector<std::vector<float>> places = {
      {0.7F, 0, 0}, {0, 0.7F, 0}, {0, 0, 0.7F}, {0, 0, -0.7F}};
  for (std::size_t i = 0; i < 4; ++i) {
    json factor = colors[i];
    factor.push_back(1);
    const int material =
        builder.add("materials", unlit({{"pbrMetallicRoughness", {{"baseColorFactor", factor}}}}));
    const int mesh = add_square(builder, 0.2F, material);
    builder.json["nodes"][static_cast<std::size_t>(mesh)]["translation"] = places[i];
  }
  const Picture picture = first_picture(scene_of(builder));
  expect_near(at(picture, 0.7, 0), {1, 0, 0, 1}, "+x is right");
  expect_near(at(picture, 0, 0.7), {0, 1, 0, 1}, "+y is up");
  expect_near(at(picture, 0, 0), {0, 0, 1, 1}, "+z is near and hides -z");
  expect_near(at(picture, -0.7, 0), {0, 0, 0, 0}, "-x");
  expect_near(at(picture, 0, -0.7), {0, 0, 0, 0}, "-y");
}

// Wavefront's v = 0 is an image's lowest row.
TEST(Looks, TexturesOfObj) {
  const TemporaryFolder folder;
  folder.write("four.png", test::png(2, 2, red + green + blue + white));
  folder.write("four.mtl", "newmtl four\nKd 1 1 1\nmap_Kd -blendu off -blendv off four.png\n");
  Scene scene =
      seen_from_front(folder.write("square.obj",
                                   "mtllib four.mtl\nusemtl four\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\n"
                                   "v -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"),
                      pixels);
  for (Material& material : scene.materials) material.unlit = true;
  const Picture picture = first_picture(scene);
  expect_near(at(picture, -0.5, 0.5), {1, 0, 0, 1}, "upper left");
  expect_near(at(picture, 0.5, 0.5), {0, 1, 0, 1}, "upper right");
  expect_near(at(picture, -0.5, -0.5), {0, 0, 1, 1}, "lower left");
  expect_near(at(picture, 0.5, -0.5), {1, 1, 1, 1}, "lower right");
}

// Colour and opacity are the texture's times the factor's times the vertex's; colours of vertices
// and factors are linear, the texture's sRGB.
GltfBuilder product(const json& alpha) {
  GltfBuilder builder;
  add_texture(builder, 1, 1, "\xbc\xbc\xbc\xbc");
  json material = {
      {"pbrMetallicRoughness",
       {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {0.5, 1, 0.25, 0.8}}}}};
  material.update(alpha);
  builder.add("materials", unlit(material));
  add_square(builder, 1, 0, {0.5F, 0.25F, 1, 0.75F});
  return builder;
}

Vec4f product_color() {
  const auto c = static_cast<float>(color_188());
  return {0.25F * c, 0.25F * c, 0.25F * c, 1};
}

TEST(Looks, ColorIsAProduct) {
  expect_near(at(first_picture(scene_of(product({{"alphaMode", "OPAQUE"}}))), 0.1, 0.1),
              product_color());
}

// 188 / 255 x 0.8 x 0.75 = 0.44235
TEST(Looks, OpacityIsAProduct) {
  const auto shown = [](const json& alpha) {
    return at(first_picture(scene_of(product(alpha))), 0.1, 0.1);
  };
  const auto opacity = static_cast<float>(byte_188 * 0.8 * 0.75);
  expect_near(shown({{"alphaMode", "BLEND"}}), product_color() * opacity, "blended, premultiplied");
  expect_near(shown({{"alphaMode", "MASK"}, {"alphaCutoff", 0.44}}), product_color(), "above");
  expect_near(shown({{"alphaMode", "MASK"}, {"alphaCutoff", 0.45}}), Vec4f(0), "below");
  expect_near(shown({{"alphaMode", "MASK"}}), Vec4f(0), "below the cutoff that is not given: 0.5");
}

// Roughness is the green channel and metalness the blue one, as numbers: 188 is 0.737, not 0.503.
// So a picture with the texture is that of the factors.
Picture lit_square(double metallic, double roughness, bool textured) {
  GltfBuilder builder;
  if (textured) add_texture(builder, 1, 1, "\x11\xbc\x50\xff");
  json pbr = {{"baseColorFactor", {0.9, 0.5, 0.1, 1}},
              {"metallicFactor", metallic},
              {"roughnessFactor", roughness}};
  if (textured) pbr["metallicRoughnessTexture"] = {{"index", 0}};
  builder.add("materials", {{"pbrMetallicRoughness", pbr}});
  add_square(builder, 1, 0);
  Scene scene = scene_of(builder);
  scene.render.integrator = IntegratorKind::path;
  Light sun;
  sun.name = "sun";
  sun.kind = LightKind::sun;
  sun.intensity.value = 3;
  scene.lights = {sun};
  return first_picture(scene);
}

TEST(Looks, RoughnessAndMetalAreLinear) {
  const double metallic = 80.0 / 255;
  for (const double factor : {1.0, 0.5}) {
    const Picture textured = lit_square(factor, 0.75, true);
    const Picture plain = lit_square(factor * metallic, 0.75 * byte_188, false);
    const Picture rough = lit_square(factor * metallic, 0.75 * color_188(), false);
    const Picture metal = lit_square(factor * 0.08, 0.75 * byte_188, false);
    double least_rough = 1, least_metal = 1;
    for (const double x : {-0.6, 0.0, 0.2}) {
      const Vec4f pixel = at(textured, x, 0);
      expect_near(pixel, at(plain, x, 0));
      EXPECT_GT(pixel.x, 0.1);
      least_rough = std::min<double>(least_rough, std::abs(pixel.x - at(rough, x, 0).x));
      least_metal = std::min<double>(least_metal, std::abs(pixel.x - at(metal, x, 0).x));
    }
    EXPECT_GT(least_rough, 1e-3);
    EXPECT_GT(least_metal, 1e-3);
  }
}

// A node that mirrors takes the texture along, but the front stays the front: it is seen, shaded as
// it was, and its normal is towards the viewer.
TEST(Looks, MirroredNodesShowTheirFronts) {
  const auto shown = [](const std::vector<double>& scale) {
    GltfBuilder builder;
    add_texture(builder, 2, 2, red + green + blue + white);
    builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    add_square(builder, 1, 0);
    builder.json["nodes"][0]["scale"] = scale;
    return first_picture(scene_of(builder));
  };
  const Picture plain = shown({1, 1, 1});
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      const Picture mirrored = shown({x, y, 1});
      for (const auto& [u, v] : {std::pair(0.33, 0.57), {-0.62, 0.41}, {0.48, -0.73}}) {
        expect_near(at(mirrored, x * u, y * v), at(plain, u, v));
        EXPECT_EQ(at(mirrored, u, v).w, 1) << x << ' ' << y;
      }
      for (const double z : channel_of(mirrored, "N.Z")) ASSERT_NEAR(z, 1, 1e-6);
    }
  }
  const Picture away = shown({1, 1, -1});
  for (const Vec4f& pixel : away.rgba()) ASSERT_EQ(pixel.w, 0);
}

}  // namespace
}  // namespace restframe
