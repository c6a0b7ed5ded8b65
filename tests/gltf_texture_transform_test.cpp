// Where textures lie on a surface: KHR_texture_transform and wrap modes, on the pixels of pictures,
// against a computation of their own.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "importers/importers.h"
#include "support/direct_render.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

constexpr int texels = 4, pixels = 64;
constexpr int repeat = 10497, mirrored = 33648, clamped = 33071;
constexpr int nearest = 9728, linear = 9729;

// Encoded sRGB of the texel in this column and row: all differ.
std::array<int, 3> encoded(int column, int row) {
  return {60 * column + 10, 70 * row + 20, 255 - 15 * (4 * column + row)};
}

std::string image() {
  std::string rgba;
  for (int row = 0; row < texels; ++row) {
    for (int column = 0; column < texels; ++column) {
      for (const int value : encoded(column, row)) rgba += static_cast<char>(value);
      rgba += '\xff';
    }
  }
  return test::png(texels, texels, rgba);
}

struct Sampling {
  int wrap_u = repeat, wrap_v = repeat, filter = nearest;
};

// A square of half-width 1 across z = 0. Its first texture coordinates run from `low` at its upper
// left to `high` at its lower right corner, the second ones from 0 to 1.
GltfBuilder textured_square(const json& use, const Sampling& sampling, float low, float high) {
  GltfBuilder builder;
  const json attributes = {
      {"POSITION", builder.add_accessor<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3")},
      {"TEXCOORD_0",
       builder.add_accessor<float>({low, high, high, high, high, low, low, low}, "VEC2")},
      {"TEXCOORD_1", builder.add_accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2")}};
  const int indices = builder.add_accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  builder.add_mesh({{"attributes", attributes}, {"indices", indices}, {"material", 0}});
  builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", use}}},
                            {"extensions", {{"KHR_materials_unlit", json::object()}}}});
  const std::string bytes = image();
  const int view = builder.add_view(bytes.data(), bytes.size());
  builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  builder.add(
      "samplers",
      {{"wrapS", sampling.wrap_u}, {"wrapT", sampling.wrap_v}, {"magFilter", sampling.filter}});
  builder.add("textures", {{"source", 0}, {"sampler", 0}});
  return builder;
}

// The square fills the picture.
Picture picture_of(const GltfBuilder& builder) {
  const TemporaryFolder folder;
  Warnings warnings;
  Scene scene = load_scene(folder.write("square.glb", builder.glb()), {}, warnings);
  EXPECT_EQ(warnings, Warnings{});
  std::get<Worldline>(scene.camera.motion).reference.x = {0, 0, 2};
  scene.camera.vertical_fov = 2 * std::atan(0.5);
  scene.camera_given = true;
  scene.render.width = scene.render.height = pixels;
  scene.render.samples = 1;
  scene.output.layers = {Layer::beauty, Layer::uv};
  return first_picture(scene);
}

// The texel of an endless row that wraps so.
int wrapped(int i, int wrap) {
  if (wrap == clamped) return std::min(std::max(i, 0), texels - 1);
  const int period = wrap == mirrored ? 2 * texels : texels;
  const int place = (i % period + period) % period;
  return place < texels ? place : period - 1 - place;
}

Vec3 linear_texel(int i, int j, const Sampling& sampling) {
  Vec3 color;
  const auto values = encoded(wrapped(i, sampling.wrap_u), wrapped(j, sampling.wrap_v));
  for (int c = 0; c < 3; ++c) {
    const double v = values[static_cast<std::size_t>(c)] / 255.0;
    color[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return color;
}

int floor_of(double x) {
  return static_cast<int>(std::floor(x));
}

// At coordinates in texels, v downwards.
Vec3 expected_color(double x, double y, const Sampling& sampling) {
  if (sampling.filter == nearest) return linear_texel(floor_of(x), floor_of(y), sampling);
  Vec3 sum(0);
  const int left = floor_of(x - 0.5), top = floor_of(y - 0.5);
  for (int i = left; i <= left + 1; ++i) {
    for (int j = top; j <= top + 1; ++j) {
      const double weight = (1 - std::abs(x - 0.5 - i)) * (1 - std::abs(y - 0.5 - j));
      sum += weight * linear_texel(i, j, sampling);
    }
  }
  return sum;
}

struct Transform {
  double offset_u = 0, offset_v = 0, rotation = 0, scale_u = 1, scale_v = 1;
};

// KHR_texture_transform in its own words: coordinates are scaled, then turned counter-clockwise
// (seen with v downwards: so the height above the origin is -v), then moved.
std::pair<double, double> moved(double u, double v, const Transform& t) {
  const std::complex<double> scaled(u * t.scale_u, -v * t.scale_v);
  const std::complex<double> turned = scaled * std::polar(1.0, t.rotation);
  return {turned.real() + t.offset_u, -turned.imag() + t.offset_v};
}

json extension(const Transform& t) {
  return {{"KHR_texture_transform",
           {{"offset", {t.offset_u, t.offset_v}},
            {"rotation", t.rotation},
            {"scale", {t.scale_u, t.scale_v}}}}};
}

bool near_edge(double x) {
  return std::abs(x - std::round(x)) < 1e-3;
}

void expect_picture(const Transform& transform, const Sampling& sampling, double low, double high) {
  const json use = {{"index", 0}, {"extensions", extension(transform)}};
  const Picture picture =
      picture_of(textured_square(use, sampling, static_cast<float>(low), static_cast<float>(high)));
  const auto layer = channel_of(picture, "UV.U");
  int compared = 0;
  for (int row = 0; row < pixels; ++row) {
    for (int column = 0; column < pixels; ++column) {
      const double u = low + (high - low) * (column + 0.5) / pixels;
      const double v = low + (high - low) * (row + 0.5) / pixels;
      const auto [x, y] = moved(u, v, transform);
      if (sampling.filter == nearest && (near_edge(texels * x) || near_edge(texels * y))) continue;
      const auto i = static_cast<std::size_t>(row * pixels + column);
      ASSERT_NEAR(layer[i], u, 1e-4);  // the mesh's own
      const Vec3 expected = expected_color(texels * x, texels * y, sampling);
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(picture.rgba()[i][c], expected[c], 2e-4) << "at " << x << ' ' << y;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, pixels * pixels / 2);
}

TEST(TextureTransform, TextureLiesWhereItsPartsSay) {
  expect_picture({}, {}, 0, 1);
  expect_picture({0.25, 0.5, 0, 1, 1}, {}, 0, 1);
  expect_picture({0, 0, 0, 2, 0.5}, {}, 0, 1);
  expect_picture({0, 1, 0, 1, -1}, {}, 0, 1);
  expect_picture({0, 0, 0.4, 1, 1}, {}, 0, 1);
  expect_picture({0, 0, -2.5, 1, 1}, {}, 0, 1);
}

TEST(TextureTransform, ScalesThenTurnsThenMoves) {
  for (const int filter : {nearest, linear}) {
    expect_picture({0.3, -0.2, 0.7, 1.5, 0.75}, {mirrored, repeat, filter}, 0, 1);
    expect_picture({-3.1, 0.2, -1.9, -0.6, 2.5}, {clamped, mirrored, filter}, -0.5, 1.5);
  }
}

// The extension's own example: the lower left quadrant of the image, turned clockwise by 90 degrees.
TEST(TextureTransform, ShowsTheQuadrantOfTheExample) {
  const json use = {
      {"index", 0},
      {"extensions",
       {{"KHR_texture_transform",
         {{"offset", {0, 1}}, {"rotation", std::numbers::pi / 2}, {"scale", {0.5, 0.5}}}}}}};
  const Picture picture = picture_of(textured_square(use, {}, 0, 1));
  // Upwards in the image becomes rightwards in the picture.
  const auto color_at = [&](int column, int row) {
    return Vec3(Vec3f(picture.rgba()[static_cast<std::size_t>(row * pixels + column)]));
  };
  const int near_edge_of_picture = pixels / 4, far = 3 * pixels / 4;
  const struct {
    int column, row, texel_column, texel_row;
  } places[] = {{near_edge_of_picture, near_edge_of_picture, 0, 3},
                {far, near_edge_of_picture, 0, 2},
                {near_edge_of_picture, far, 1, 3},
                {far, far, 1, 2}};
  for (const auto& place : places) {
    const Vec3 expected = linear_texel(place.texel_column, place.texel_row, {});
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(color_at(place.column, place.row)[c], expected[c], 1e-4);
  }
}

TEST(Wrapping, GoesOnBeyondTheImage) {
  for (const int filter : {nearest, linear}) {
    for (const int wrap : {repeat, mirrored, clamped}) {
      expect_picture({}, {wrap, repeat, filter}, -2.3, 3.1);
      expect_picture({}, {clamped, wrap, filter}, -2.3, 3.1);
    }
  }
}

// The same number, 188, as a colour and as alpha.
TEST(TextureColours, AreSrgbAndAlphaIsLinear) {
  GltfBuilder builder = textured_square({{"index", 0}}, {}, 0, 1);
  const std::string bytes = test::png(1, 1, "\xbc\xbc\xbc\xbc");
  builder.json["images"][0]["bufferView"] = builder.add_view(bytes.data(), bytes.size());
  json& material = builder.json["materials"][0];
  material["alphaMode"] = "BLEND";
  material["emissiveTexture"] = {{"index", 0}};
  material["emissiveFactor"] = {0, 0.5, 1};
  material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 4}};
  const double color = std::pow((188.0 / 255 + 0.055) / 1.055, 2.4), alpha = 188.0 / 255;
  const Picture picture = picture_of(builder);
  const Vec4f pixel = picture.rgba().at(pixels * pixels / 2);
  EXPECT_NEAR(pixel.x, alpha * color, 1e-5);
  EXPECT_NEAR(pixel.y, alpha * (color + 2 * color), 1e-5);
  EXPECT_NEAR(pixel.z, alpha * (color + 4 * color), 1e-5);
  EXPECT_NEAR(pixel.w, alpha, 1e-5);
}

}  // namespace
}  // namespace restframe
