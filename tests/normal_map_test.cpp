// Normal maps on pixels. A map of one colour everywhere is a plane whose normal is known: in the
// preview it is shaded with |cos| of exactly that normal, and the layer N holds it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "importers/importers.h"
#include "support/direct_render.h"
#include "support/gltf_builder.h"
#include "support/loaded_scene.h"
#include "support/temporary_folder.h"
#include "support/textured_square.h"
#include "tracer/shading_normal.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

constexpr int pixels = 40;
constexpr std::array<std::uint8_t, 3> color{200, 90, 230};

// What the bytes stand for, with x to the right and y to the upper side of the image.
Vec3 vector_of(const std::array<std::uint8_t, 3>& rgb, double scale = 1) {
  Vec3 v;
  for (int c = 0; c < 3; ++c) v[c] = 2.0 * rgb[static_cast<std::size_t>(c)] / 255 - 1;
  return glm::normalize(Vec3(scale * v.x, scale * v.y, v.z));
}

Image pixel_of(const std::array<std::uint8_t, 3>& rgb) {
  return image_of(1, 1, {rgb[0], rgb[1], rgb[2], 255});
}

// The square of support/textured_square.h, its normal map one colour.
Scene bumped_square(const std::array<std::uint8_t, 3>& rgb = color) {
  Scene scene = scene_of_square(textured_square(1), pixel_of(rgb));
  scene.textures[0].srgb = false;
  scene.materials[0].normal_texture.texture = 0;
  scene.materials[0].base_color.value = {0.8F, 0.5F, 0.25F};
  return scene;
}

// All pixels inside the square show this normal, and the preview's shading with it.
void expect_normal(const Scene& scene, const Vec3& normal, double tolerance = 1e-4) {
  const Picture picture = first_picture(scene);
  const std::vector<double> x = channel_of(picture, "N.X"), y = channel_of(picture, "N.Y"),
                            z = channel_of(picture, "N.Z");
  const Vec3 base(scene.materials[0].base_color.value);
  int checked = 0;
  for (int row = 0; row < pixels; ++row) {
    for (int column = 0; column < pixels; ++column) {
      const auto i = static_cast<std::size_t>(row * pixels + column);
      if (picture.rgba()[i].w == 0) continue;
      ++checked;
      ASSERT_LT(glm::distance(Vec3(x[i], y[i], z[i]), normal), tolerance) << x[i] << ' ' << y[i];
      if (scene.render.integrator != IntegratorKind::preview) continue;
      const Vec3 place((column + 0.5) / pixels * 2 - 1, 1 - (row + 0.5) / pixels * 2, 0);
      const double cosine = std::abs(glm::dot(normal, glm::normalize(Vec3(0, 0, 2) - place)));
      ASSERT_LT(glm::distance(Vec3(Vec3f(picture.rgba()[i])), cosine * base), tolerance);
    }
  }
  EXPECT_GT(checked, 300);
}

TEST(NormalMap, TiltsTheShadingNormal) {
  Scene scene = bumped_square();
  expect_normal(scene, vector_of(color));
  scene.render.integrator = IntegratorKind::path;
  expect_normal(scene, vector_of(color));
}

TEST(NormalMap, IsScaledInXAndY) {
  Scene scene = bumped_square();
  for (const float scale : {0.3F, -1.5F, 0.0F}) {
    scene.materials[0].normal_scale.value = scale;
    expect_normal(scene, vector_of(color, static_cast<double>(scale)));
  }
  scene.functions = {KeyFunction{{}, {{-10, Vec3f(0.25F)}, {10, Vec3f(0.25F)}}}};
  scene.materials[0].normal_scale.function = 0;
  expect_normal(scene, vector_of(color, 0.25));
}

// Given tangents hold as they are: turned by 30 degrees, and with the upper side below.
TEST(NormalMap, TakesTheTangentsThatAreGiven) {
  const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
  Scene scene = bumped_square();
  const Vec3 map = vector_of(color);
  scene.meshes[0].normals.assign(4, {0, 0, 1});
  for (const double sign : {1.0, -1.0}) {
    scene.meshes[0].tangents.assign(4, Vec4f(c, s, 0, sign));
    expect_normal(scene, map.x * Vec3(c, s, 0) + sign * map.y * Vec3(-s, c, 0) + Vec3(0, 0, map.z));
  }
  // 0: none is given.
  scene.meshes[0].tangents.assign(4, Vec4f(0));
  expect_normal(scene, map);
}

TEST(NormalMap, NeedsTextureCoordinates) {
  Scene scene = bumped_square();
  scene.materials[0].normal_texture.uv_set = 1;
  expect_normal(scene, {0, 0, 1});
  scene.meshes[0].uvs[0].clear();
  scene.materials[0].normal_texture.uv_set = 0;
  expect_normal(scene, {0, 0, 1});
}

// As if it were geometry: by the inverse transpose, also where the placing mirrors and stretches.
TEST(NormalMap, IsPlacedLikeGeometry) {
  const Vec3 map = vector_of(color);
  for (const auto& [columns, expected] :
       {std::pair<Mat3, Vec3>{{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-map.x, map.y, map.z}},
        {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {-map.y, map.x, map.z}},
        {{{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}}, {-map.y, -map.x, map.z}},
        {{{0.5, 0, 0}, {0, 2, 0}, {0, 0, 1}}, glm::normalize(Vec3(2 * map.x, map.y / 2, map.z))},
        {{{1, 0, 0}, {0.5, 1, 0}, {0, 0, 1}},
         glm::normalize(Vec3(map.x, map.y - 0.5 * map.x, map.z))}}) {
    Scene scene = bumped_square();
    scene.objects[0].parts[0].object_from_mesh = Mat4(columns);
    expect_normal(scene, expected);
    // Alone in its rest frame, baked beside another mesh, and as an instance.
    Object other = scene.objects[0];
    other.name = "behind";
    other.worldline.reference.x = {0, 0, -50};
    scene.objects.push_back(other);
    expect_normal(scene, expected);
    scene.meshes.push_back(scene.meshes[0]);
    scene.objects[1].parts[0].mesh = 1;
    expect_normal(scene, expected);
  }
}

// The object's own clock and rest frame: what is seen is the same, whatever the velocity. Little is
// tilted, so that nothing looks away where the board is seen from its edge.
TEST(NormalMap, TiltsInTheRestFrame) {
  for (const Vec3& beta : {Vec3(0, 0, 0.9), Vec3(0.6, 0, 0), Vec3(0.3, 0.2, -0.9)}) {
    Scene scene = bumped_square();
    scene.objects[0].worldline = {{-2, {0, 0, 0}}, Velocity::from_beta(beta)};
    scene.render.integrator = IntegratorKind::path;
    scene.materials[0].normal_scale.value = 0.2F;
    expect_normal(scene, vector_of(color, 0.2));
  }
}

// From behind a bump is a hollow.
TEST(NormalMap, TurnsWithBackFaces) {
  Scene scene = bumped_square();
  scene.materials[0].double_sided = true;
  scene.objects[0].parts[0].object_from_mesh =
      Mat4(Mat3(Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)));
  const Vec3 map = vector_of(color);
  expect_normal(scene, {map.x, -map.y, map.z});
}

// Where it looks away it is mirrored to the viewer's side; |cos| is the same.
TEST(NormalMap, ThatLooksAwayIsMirrored) {
  Scene scene = bumped_square({255, 128, 130});
  scene.output.layers = {Layer::beauty, Layer::normal};
  const Vec3 normal = vector_of({255, 128, 130});
  for (const IntegratorKind integrator : {IntegratorKind::preview, IntegratorKind::path}) {
    scene.render.integrator = integrator;
    const Picture picture = first_picture(scene);
    const std::vector<double> x = channel_of(picture, "N.X"), z = channel_of(picture, "N.Z");
    int mirrored = 0;
    for (int i = 0; i < pixels * pixels; ++i) {
      const Vec3 place((i % pixels + 0.5) / pixels * 2 - 1, 1 - (i / pixels + 0.5) / pixels * 2, 0);
      const Vec3 view = glm::normalize(Vec3(0, 0, 2) - place);
      const double cosine = glm::dot(normal, view);
      const Vec3 expected = cosine < 0 ? normal - 2 * cosine * view : normal;
      mirrored += cosine < 0 ? 1 : 0;
      const auto at = static_cast<std::size_t>(i);
      ASSERT_NEAR(x[at], expected.x, 1e-4);
      ASSERT_NEAR(z[at], expected.z, 1e-4);
      if (integrator == IntegratorKind::preview) {
        ASSERT_NEAR(picture.rgba()[at].x, 0.8 * std::abs(cosine), 1e-4);
      }
    }
    EXPECT_GT(mirrored, 400);
  }
}

// A white mirror in a white world is white, however rough the map makes it: no reflection is lost
// below the surface.
TEST(NormalMap, LeavesNoBlackInMirrors) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 64; ++i) {
    add_pixel(rgba,
              {static_cast<std::uint8_t>(i * 97 % 256), static_cast<std::uint8_t>(i * 57 % 256),
               static_cast<std::uint8_t>(128 + i * 31 % 128), 255});
  }
  Scene scene = scene_of_square(textured_square(1), image_of(8, 8, rgba));
  scene.textures[0].srgb = false;
  scene.materials[0].normal_texture.texture = 0;
  scene.materials[0].roughness.value = 0;
  scene.render.integrator = IntegratorKind::path;
  // Nearly from the edge.
  scene.objects[0].parts[0].object_from_mesh =
      Mat4(Mat3(Vec3(1, 0, 0), Vec3(0, 0.2, -0.98), Vec3(0, 0.98, 0.2)));
  Light world;
  world.name = "world";
  world.kind = LightKind::environment;
  scene.lights = {world};
  const Picture picture = first_picture(scene);
  for (const Vec4f& pixel : picture.rgba()) {
    ASSERT_NEAR(pixel.x, 1, 1e-4);
    ASSERT_NEAR(pixel.z, 1, 1e-4);
  }
}

TEST(NormalMap, ReflectingNormalsAreTheNearestThatServe) {
  const Vec3f facet(0, 0, 1);
  const Vec3f steep = glm::normalize(Vec3f(0.9F, 0.1F, 0.5F));
  // Straight on, up to 45 degrees, nothing is to do.
  const Vec3f slight = glm::normalize(Vec3f(0.6F, 0, 0.8F));
  EXPECT_EQ(reflecting_normal(facet, facet, slight), slight);
  for (const Vec3f& view : {facet, glm::normalize(Vec3f(-0.5F, 0.3F, 0.2F)),
                            glm::normalize(Vec3f(-1, 0, 1e-3F)), Vec3f(1, 0, 0)}) {
    const Vec3f normal = reflecting_normal(view, facet, steep);
    const Vec3f image = 2.0F * glm::dot(view, normal) * normal - view;
    EXPECT_NEAR(glm::length(normal), 1, 1e-5);
    EXPECT_GE(glm::dot(image, facet), -1e-6);
    EXPECT_GE(glm::dot(view, normal), -1e-6);
  }
}

// The clearcoat has the mesh's own normal, or that of its own map.
TEST(NormalMap, ClearcoatsHaveNormalsOfTheirOwn) {
  Scene scene = bumped_square();
  scene.images.push_back(pixel_of({40, 128, 200}));
  scene.textures.push_back(scene.textures[0]);
  scene.textures[1].image = 1;
  Lanes<double> film;
  film.fill(20);
  const auto normal_of = [&](bool tilt_first) {
    MetPacket met(scene, film, film);
    TemporalEvaluator evaluator(scene.functions);
    if (tilt_first) tilt_normal(met.at(0), 0, evaluator, met.surfaces);
    return Vec3(clearcoat_normal(met.at(0)));
  };
  for (const bool tilt_first : {false, true}) {
    scene.materials[0].clearcoat_normal_texture.texture = -1;
    EXPECT_LT(glm::distance(normal_of(tilt_first), Vec3(0, 0, 1)), 1e-6);
    scene.materials[0].clearcoat_normal_texture.texture = 1;
    for (const float scale : {1.0F, 0.4F}) {
      scene.materials[0].clearcoat_normal_scale = scale;
      const Vec3 expected = vector_of({40, 128, 200}, static_cast<double>(scale));
      EXPECT_LT(glm::distance(normal_of(tilt_first), expected), 1e-4);
    }
  }
}

const std::string map_png = test::png(1, 1, "\xc8\x5a\xe6\xff");

TEST(NormalMap, OfGltf) {
  GltfBuilder builder;
  const int view = builder.add_view(map_png.data(), map_png.size());
  builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  builder.add("textures", {{"source", 0}});
  builder.add("materials", {{"normalTexture", {{"index", 0}, {"scale", 0.5}}}});
  const json attributes = {
      {"POSITION", builder.add_accessor<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3")},
      {"TEXCOORD_0", builder.add_accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2")}};
  const int indices = builder.add_accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  builder.add_mesh({{"attributes", attributes}, {"indices", indices}, {"material", 0}});
  const TemporaryFolder folder;
  expect_normal(seen_from_front(folder.write("asset.glb", builder.glb()), pixels),
                vector_of(color, 0.5));
}

// vt counts upwards.
TEST(NormalMap, OfObj) {
  const TemporaryFolder folder;
  folder.write("map.png", map_png);
  folder.write("square.mtl", "newmtl m\nKd 0.5 0.5 0.5\nnorm map.png\n");
  const Scene scene = seen_from_front(
      folder.write("square.obj",
                   "mtllib square.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                   "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"),
      pixels);
  expect_normal(scene, vector_of(color));
}

}  // namespace
}  // namespace restframe
