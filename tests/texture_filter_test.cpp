// Smaller copies of images, the mean over a footprint, and how large footprints are: far or shrunken
// textures do not flicker, near ones are as sharp as ever.

#include "scene/texture_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/direct_render.h"
#include "support/textured_square.h"
#include "tracer/footprint.h"

namespace restframe {
namespace {

Vec4f last_of(const MipChain& mips, bool srgb) {
  const TexelGrid grid = mips.level(mips.level_count() - 1);
  EXPECT_EQ(grid.width * grid.height, 1);
  Vec4f pixel;
  for (int c = 0; c < 4; ++c) pixel[c] = linear_from_byte(srgb && c < 3, grid.rgba[c]);
  return pixel;
}

TEST(MipChain, HalvesDownToOnePixel) {
  const MipChain mips(image_of(11, 4, std::vector<std::uint8_t>(4 * 44, 9)), {});
  ASSERT_EQ(mips.level_count(), 4);
  EXPECT_EQ(mips.level(1).width, 5);
  EXPECT_EQ(mips.level(1).height, 2);
  EXPECT_EQ(mips.level(2).width, 2);
  EXPECT_EQ(mips.level(2).height, 1);
  EXPECT_EQ(mips.level(3).width, 1);
  EXPECT_EQ(mips.bytes(), 4U * (10 + 2 + 1));
  const MipChain large(checkerboard(256), {});
  EXPECT_NEAR(static_cast<double>(large.bytes()), 256 * 256 * 4 / 3.0, 4);
}

// Half of the light is 188 in sRGB, not 128.
TEST(MipChain, AveragesLight) {
  const MipChain light(checkerboard(64), {true, false});
  EXPECT_NEAR(last_of(light, true).x, 0.5, 0.003);
  EXPECT_EQ(light.level(1).rgba[0], 188);
  const MipChain data(checkerboard(64), {false, false});
  EXPECT_NEAR(last_of(data, false).x, 0.5, 0.003);
  EXPECT_EQ(data.level(1).rgba[0], 128);
}

// However odd the sides, each pixel counts as much as any other; each level rounds by half a step.
TEST(MipChain, KeepsTheMean) {
  for (const auto& [width, height] : {std::pair(5, 3), {7, 7}, {1, 9}, {13, 2}, {31, 17}}) {
    std::vector<std::uint8_t> rgba;
    double sum = 0;
    for (int i = 0; i < width * height; ++i) {
      const auto value = static_cast<std::uint8_t>(37 * i * i % 251);
      add_pixel(rgba, {value, value, value, value});
      sum += value;
    }
    const MipChain mips(image_of(width, height, rgba), {false, false});
    const double steps = 0.5 * (mips.level_count() - 1);
    EXPECT_NEAR(255 * static_cast<double>(last_of(mips, false).x), sum / (width * height),
                steps + 1e-3);
    EXPECT_NEAR(255 * static_cast<double>(last_of(mips, false).w), sum / (width * height),
                steps + 1e-3);
  }
}

TEST(MipChain, WeighsColoursByAlphaIfToldSo) {
  const Image image = image_of(2, 1, {255, 0, 0, 0, 0, 255, 0, 255});
  const Vec4f weighed = last_of(MipChain(image, {true, true}), true);
  EXPECT_EQ(Vec3f(weighed), Vec3f(0, 1, 0));
  EXPECT_NEAR(weighed.w, 0.5, 0.003);
  const Vec4f plain = last_of(MipChain(image, {true, false}), true);
  EXPECT_NEAR(plain.x, 0.5, 0.003);
  EXPECT_NEAR(plain.y, 0.5, 0.003);
  const Image nothing = image_of(2, 1, {255, 0, 0, 0, 255, 0, 0, 0});
  EXPECT_EQ(last_of(MipChain(nothing, {true, true}), true), Vec4f(1, 0, 0, 0));
}

Texture texture_with(TextureFilter filter, TextureFilter shrunken, MipFilter mips) {
  Texture texture;
  texture.srgb = false;
  texture.filter = filter;
  texture.shrunken_filter = shrunken;
  texture.mip_filter = mips;
  return texture;
}

Image noise(int width, int height) {
  std::vector<std::uint8_t> rgba;
  std::uint32_t state = 1;
  for (int i = 0; i < 4 * width * height; ++i) {
    state = state * 1664525U + 1013904223U;
    rgba.push_back(static_cast<std::uint8_t>(state >> 24U));
  }
  return image_of(width, height, std::move(rgba));
}

TEST(TextureFilter, MagnifiedTexturesAreAsEverToTheBit) {
  const Image image = noise(16, 8);
  const MipChain mips(image, {false, false});
  for (const TextureFilter filter : {TextureFilter::linear, TextureFilter::nearest}) {
    const Texture texture = texture_with(filter, TextureFilter::linear, MipFilter::linear);
    for (int i = 0; i < 1000; ++i) {
      const Vec2f uv(0.0137F * static_cast<float>(i) - 3, 0.0071F * static_cast<float>(i));
      const float a = 0.005F * static_cast<float>(i % 100);
      // Turned by a: no longer than a texel in any direction.
      const TextureFootprint footprint{Vec2f(0.99F * std::cos(a) / 16, 0.99F * std::sin(a) / 8),
                                       Vec2f(-0.5F * std::sin(a) / 16, 0.5F * std::cos(a) / 8)};
      const Vec4f filtered = sample_texture(texture, image, mips, uv, footprint);
      const Vec4f plain = sample_texture(texture, image, uv);
      ASSERT_EQ(std::memcmp(&filtered, &plain, sizeof(plain)), 0);
    }
  }
}

TEST(TextureFilter, FollowsTheSampler) {
  const Image image = checkerboard(16);
  const MipChain mips(image, {false, false});
  const auto sample = [&](TextureFilter shrunken, MipFilter mip, float texels, float u) {
    const TextureFootprint footprint{{texels / 16, 0}, {0, texels / 16}};
    return sample_texture(texture_with(TextureFilter::linear, shrunken, mip), image, mips,
                          {u / 16, 0.5F / 16}, footprint)
        .x;
  };
  constexpr auto linear = TextureFilter::linear, nearest = TextureFilter::nearest;
  constexpr float grey = 128.0F / 255;
  for (const float texels : {2.5F, 40.0F, 1e9F}) {
    EXPECT_EQ(sample(nearest, MipFilter::none, texels, 0.6F), 1);
    EXPECT_EQ(sample(nearest, MipFilter::none, texels, 1.4F), 0);
    EXPECT_NEAR(sample(linear, MipFilter::none, texels, 0.75F), 0.75F, 1e-6);
    EXPECT_NEAR(sample(linear, MipFilter::linear, texels, 0.5F), grey, 1e-6);
    EXPECT_NEAR(sample(nearest, MipFilter::nearest, texels, 0.5F), grey, 1e-6);
  }
  // Levels by the logarithm of the footprint: 0.49 and 0.51, and in between.
  EXPECT_EQ(sample(nearest, MipFilter::nearest, std::exp2(0.49F), 0.5F), 1);
  EXPECT_NEAR(sample(nearest, MipFilter::nearest, std::exp2(0.51F), 0.5F), grey, 1e-6);
  EXPECT_NEAR(sample(nearest, MipFilter::linear, std::exp2(0.25F), 0.5F), 0.75F + 0.25F * grey,
              1e-5);
}

// Rows of one colour each stay sharp under a footprint that is long along them, and are mixed by one
// across them.
TEST(TextureFilter, IsAnisotropic) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 64 * 64; ++i) {
    const std::uint8_t grey = i / 64 % 2 == 0 ? 255 : 0;
    add_pixel(rgba, {grey, grey, grey, 255});
  }
  const Image image = image_of(64, 64, rgba);
  const MipChain mips(image, {false, false});
  const Texture texture =
      texture_with(TextureFilter::linear, TextureFilter::linear, MipFilter::linear);
  const Vec2f uv(0.37F, 10.5F / 64);
  const Vec2f u(1.0F / 64, 0), v(0, 1.0F / 64);
  EXPECT_NEAR(sample_texture(texture, image, mips, uv, {7.9F * u, 0.5F * v}).x, 1, 1e-5);
  EXPECT_NEAR(sample_texture(texture, image, mips, uv, {0.5F * v, 7.9F * u}).x, 1, 1e-5);
  EXPECT_NEAR(sample_texture(texture, image, mips, uv, {8.0F * v, 0.5F * u}).x, 0.5, 1e-5);
}

TEST(TextureFilter, AnyFootprintIsSafe) {
  const Image image = noise(5, 9);
  const MipChain mips(image, {false, false});
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const MipFilter mip : {MipFilter::linear, MipFilter::nearest, MipFilter::none}) {
    const Texture texture = texture_with(TextureFilter::linear, TextureFilter::linear, mip);
    for (const float a : {0.0F, 1e-30F, 1.0F, 1e20F, 3e38F, infinity, std::nanf("")}) {
      for (const float b : {0.0F, -1.0F, 1e25F, -infinity, std::nanf("")}) {
        for (const TextureFootprint& f :
             {TextureFootprint{{a, b}, {b, a}}, {{a, a}, {b, b}}, {{a, 0}, {0, b}}}) {
          const Vec4f pixel = sample_texture(texture, image, mips, {0.3F, 0.6F}, f);
          for (int c = 0; c < 4; ++c) ASSERT_TRUE(pixel[c] >= 0 && pixel[c] <= 1.0001F) << a << b;
        }
      }
    }
  }
}

// A pixel's neighbours say how far it reaches on the texture. As aberration keeps small circles
// round, it does so whatever moves: with J the change of (u, v) by pixels, J J^T is the footprint's.
void expect_footprint_of_neighbours(Scene scene, const Vec3& object_beta, const Vec3& camera_beta) {
  scene.objects[0].worldline.velocity = Velocity::from_beta(object_beta);
  // Seen at the picture's centre.
  auto& camera = std::get<Worldline>(scene.camera.motion);
  const double distance = glm::length(camera.reference.x);
  scene.objects[0].worldline.reference.t = -distance;
  camera.velocity = Velocity::from_beta(camera_beta);
  scene.camera.aim = AimTrack{{{-distance, {0, 0, 0}}, Velocity()}, "centre"};
  scene.render.width = scene.render.height = 20'000;
  Lanes<double> film_x, film_y;
  film_x.fill(10'000);
  film_y.fill(10'000);
  constexpr double apart = 8;  // pixels
  film_x[1] += apart;
  film_y[2] += apart;
  const MetPacket met(scene, film_x, film_y);
  for (int lane = 0; lane < 3; ++lane) ASSERT_GE(met.hits.frame[lane], 0);
  const auto uv = [&](int lane) {
    return glm::dvec2(uv_at(met.scene, met.frames, met.hits, lane, 0));
  };
  const glm::dmat2 change((uv(1) - uv(0)) / apart, (uv(2) - uv(0)) / apart);
  const TextureFootprint reached = footprint(met.at(0), {0, 0, {}});
  const glm::dmat2 sides(glm::dvec2(reached.side), glm::dvec2(reached.other_side));
  const glm::dmat2 expected = change * glm::transpose(change);
  const glm::dmat2 actual = sides * glm::transpose(sides);
  const double size = expected[0][0] + expected[1][1];
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(actual[i][j], expected[i][j], 0.01 * size);
  }
}

TEST(Footprint, IsThatOfAPixelWhateverMoves) {
  Scene scene = scene_of_square(textured_square(1), checkerboard(2));
  // Turned, leaning, stretched.
  Mat4& placed = scene.objects[0].parts[0].object_from_mesh;
  placed = Mat4(1);
  placed[0] = {0.6, 0.5, -0.9, 0};
  placed[1] = {-0.8, 1.2, 0.3, 0};
  placed[2] = {0.3, 0.2, 1.5, 0};
  for (const Vec3& object : {Vec3(0), Vec3(0, 0, 0.9), Vec3(0, 0, -0.9), Vec3(0.6, -0.3, 0.7)}) {
    for (const Vec3& camera : {Vec3(0), Vec3(-0.5, 0.6, 0.3)}) {
      expect_footprint_of_neighbours(scene, object, camera);
    }
  }
}

struct Moments {
  double mean = 0, variance = 0;
  int count = 0;
};

// Of the red of pixels that the middle of the square covers.
Moments moments_of(const Picture& picture, int from, int to) {
  Moments m;
  double squares = 0;
  for (int y = from; y < to; ++y) {
    for (int x = from; x < to; ++x) {
      const Vec4f pixel = picture.rgba().at(static_cast<std::size_t>(y) *
                                                static_cast<std::size_t>(picture.width()) +
                                            static_cast<std::size_t>(x));
      EXPECT_EQ(pixel.w, 1);
      const auto red = static_cast<double>(pixel.x);
      m.mean += red;
      squares += red * red;
      ++m.count;
    }
  }
  m.mean /= m.count;
  m.variance = squares / m.count - m.mean * m.mean;
  return m;
}

// Some hundred pixels of the texture to one of the picture, in a ratio that is not a whole number.
Scene shrunken_board(IntegratorKind integrator) {
  Scene scene = scene_of_square(textured_square(1, 37.7F), checkerboard(64));
  scene.materials[0].unlit = true;
  scene.materials[0].base_color_texture.texture = 0;
  scene.render.integrator = integrator;
  scene.output.layers = {Layer::beauty};
  return scene;
}

TEST(TextureFilter, ShrunkenBoardsAreGreyInAllTheirPixels) {
  for (const IntegratorKind integrator : {IntegratorKind::preview, IntegratorKind::path}) {
    Scene scene = shrunken_board(integrator);
    const Moments filtered = moments_of(first_picture(scene), 2, 38);
    EXPECT_NEAR(filtered.mean, 0.5, 0.01);
    EXPECT_LT(filtered.variance, 1e-5);
    scene.textures[0].mip_filter = MipFilter::none;
    scene.textures[0].shrunken_filter = TextureFilter::nearest;
    // Black or white by chance: a variance of 1/4.
    EXPECT_NEAR(moments_of(first_picture(scene), 2, 38).variance, 0.25, 0.01);
  }
}

// At 0.99c towards the camera, seen when it was at the origin: what moves is as large as at rest, but
// its rest frame has the camera 14 times nearer, and a pixel is 14 times as wide an angle.
TEST(TextureFilter, FastBoardsAreGreyInAllTheirPixels) {
  for (const double beta : {0.99, -0.99}) {
    for (const IntegratorKind integrator : {IntegratorKind::preview, IntegratorKind::path}) {
      Scene scene = shrunken_board(integrator);
      scene.objects[0].worldline = {{-2, {0, 0, 0}}, Velocity::from_beta({0, 0, beta})};
      const Moments middle = moments_of(first_picture(scene), 17, 23);
      EXPECT_NEAR(middle.mean, 0.5, 0.01) << beta;
      EXPECT_LT(middle.variance, 1e-5) << beta;
    }
  }
}

// From the edge: long footprints.
TEST(TextureFilter, LeaningBoardsAreGrey) {
  Scene scene = shrunken_board(IntegratorKind::preview);
  Mat4& placed = scene.objects[0].parts[0].object_from_mesh;
  placed[1] = {0, 0.1, 0.995, 0};
  placed[2] = {0, -0.995, 0.1, 0};
  const Moments middle = moments_of(first_picture(scene), 19, 21);
  EXPECT_NEAR(middle.mean, 0.5, 0.02);
  EXPECT_LT(middle.variance, 1e-3);
}

// A board seen in a mirror is as far as both ways together.
TEST(TextureFilter, MirrorsShowFilteredBoards) {
  Scene scene = shrunken_board(IntegratorKind::path);
  scene.meshes.push_back(textured_square(1));
  scene.materials.emplace_back();
  scene.materials[1].roughness.value = 0;
  Object mirror = scene.objects[0];
  mirror.name = "mirror";
  mirror.materials = {1};
  mirror.parts[0].mesh = 1;
  scene.objects.push_back(mirror);
  // The board faces the mirror from behind the camera.
  Mat4& placed = scene.objects[0].parts[0].object_from_mesh;
  placed = Mat4(3);
  placed[0].x = -3;
  placed[2].z = -3;
  placed[3] = {0, 0, 3, 1};
  const Moments seen = moments_of(first_picture(scene), 2, 38);
  EXPECT_NEAR(seen.mean, 0.5, 0.01);
  EXPECT_LT(seen.variance, 1e-5);
}

// A cutoff of alpha is compared with its mean.
TEST(TextureFilter, MasksAreFiltered) {
  Scene scene = shrunken_board(IntegratorKind::preview);
  Image& image = scene.images[0];
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) image.rgba[i + 3] = image.rgba[i];
  scene.materials[0].alpha_mode = AlphaMode::mask;
  for (const float cutoff : {0.45F, 0.55F}) {
    scene.materials[0].alpha_cutoff = cutoff;
    const Picture picture = first_picture(scene);
    for (int y = 2; y < 38; ++y) {
      for (int x = 2; x < 38; ++x) {
        const Vec4f pixel = picture.rgba()[static_cast<std::size_t>(40 * y + x)];
        ASSERT_EQ(pixel.w, cutoff < 0.5F ? 1 : 0);
        // White where it is seen: what is black is not.
        ASSERT_NEAR(pixel.x, cutoff < 0.5F ? 1 : 0, 0.01);
      }
    }
  }
}

}  // namespace
}  // namespace restframe
