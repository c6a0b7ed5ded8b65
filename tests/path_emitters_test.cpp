// Light of emitting surfaces on a white diffuse floor, against its integral over the emitter: with
// retarded events where it moves (closed form 13 for each of its points), and against Lambert's
// formula for polygons where it rests.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/exr_writer.h"
#include "support/loaded_scene.h"
#include "support/picture_statistics.h"
#include "support/retarded_light.h"

namespace restframe {
namespace {

using reference::Long3;

constexpr double pi = std::numbers::pi;
constexpr double kGrey = 0.7;

// A lamp of 1.2 x 0.8 beside what the camera looks at, leaning over it.
const Vec3 kCenter(1.5, 1, 0.2), kU(0, 0, 0.6),
    kV(-0.16, 0.36, 0);  // half edges; faces along u x v

struct LampSetting {
  Vec3 velocity{0};
  bool beaming = false;
  std::string emission = "emission = [2, 2, 2]";
  std::string clock{};
};

reference::ObserverCamera camera_above() {
  reference::ObserverCamera camera;
  camera.position = {0, 6, 0};
  camera.time = 3;
  camera.width = 8;
  camera.height = 6;
  camera.vertical_fov = 0.03;
  aim(camera, {0, -1, 0}, {0, 0, -1});
  return camera;
}

Scene lamp_scene(const LampSetting& lamp, int samples = 16) {
  const std::string text =
      camera_text(camera_above(),
                  fmt::format("samples = {}\ndepth = 1\nbeaming = {}", samples, lamp.beaming)) +
      "[[object]]\nname = \"floor\"\nasset = \"floor.obj\"\nmaterial = \"floor\"\n" +
      diffuse_material("floor", kGrey) +
      fmt::format(
          "[[object]]\nname = \"lamp\"\nasset = \"lamp.obj\"\nmaterial = \"lamp\"\n"
          "position = {}\nvelocity = {}\ntime = -4\n{}\n",
          toml(kCenter), toml(lamp.velocity), lamp.clock) +
      "[[material]]\nname = \"lamp\"\nbase_color = \"black\"\nmetallic = 0\nior = 1\n" +
      lamp.emission + "\n";
  return loaded_scene(text, {{"floor.obj", quad_obj({0, 0, 0}, {4, 0, 0}, {0, 0, -4})},
                             {"lamp.obj", quad_obj({0, 0, 0}, kU, kV)}});
}

Vec3 floor_point(int x, int y) {
  const reference::ObserverCamera camera = camera_above();
  const Vec3 sight = reference::narrowed(direction_through(camera, {x + 0.5, y + 0.5}));
  return camera.position + sight * (camera.position.y / -sight.y);
}

// What falls on a point of the floor from the lamp's front, whose emission may change with its clock.
double irradiance(const Scene& scene, const Vec3& point, bool beaming,
                  const std::function<double(double clock)>& emission) {
  const Object& lamp = scene.objects[1];
  const Vec3 normal = glm::normalize(glm::cross(kU, kV));
  const double time = 3 - glm::length(point - Vec3(0, 6, 0));
  constexpr int steps = 60;
  double sum = 0;
  for (int i = 0; i < steps * steps; ++i) {
    const int row = i / steps, column = i % steps;
    const double u = 2 * (row + 0.5) / steps - 1, v = 2 * (column + 0.5) / steps - 1;
    const Worldline line = at_rest_on(lamp, u * kU + v * kV);
    const reference::SeenLight s =
        reference::seen({reference::widened(line.velocity.gamma_beta()),
                         reference::widened(line.reference.x), line.reference.t, 0},
                        {time, reference::widened(point)}, {});
    // The clock of the point's own worldline is the lamp's, apart from where they are synchronised.
    const Long3 offset = reference::widened(u * kU + v * kV);
    const long double behind = dot(reference::widened(line.velocity.gamma_beta()), offset) /
                               gamma_of(reference::widened(line.velocity.gamma_beta()));
    const double clock = static_cast<double>(s.clock - behind) + lamp.clock;
    const long double facing = -dot(reference::widened(normal), s.sight_at_light);
    const long double cosine = s.sight_at_surface.y;
    if (facing <= 0 || cosine <= 0) continue;
    const long double d = s.at_surface / s.at_light, r = s.delay * s.at_surface;
    const double factor = beaming ? static_cast<double>(d * d * d * d) : 1;
    sum += emission(clock) * factor * static_cast<double>(facing * cosine / (r * r));
  }
  return sum * 4 * glm::length(glm::cross(kU, kV)) / (steps * steps);
}

std::vector<double> expected_pixels(const Scene& scene, bool beaming,
                                    const std::function<double(double)>& emission) {
  std::vector<double> pixels;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      pixels.push_back(kGrey / pi * irradiance(scene, floor_point(x, y), beaming, emission));
    }
  }
  return pixels;
}

double always_two(double) {
  return 2;
}

// Lambert 1760: half the sum over a polygon's edges of the angles that they subtend times the
// cosines between their planes and the surface.
TEST(EmittingQuad, AtRestIsLambertsPolygon) {
  const Scene scene = lamp_scene({});
  const Vec3 corners[4] = {kCenter - kU - kV, kCenter + kU - kV, kCenter + kU + kV,
                           kCenter - kU + kV};
  std::vector<double> expected;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      const Vec3 point = floor_point(x, y);
      double sum = 0;
      for (int i = 0; i < 4; ++i) {
        const Vec3 a = glm::normalize(corners[i] - point);
        const Vec3 b = glm::normalize(corners[(i + 1) % 4] - point);
        sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(a, b)).y;
      }
      expected.push_back(kGrey / pi * 2 * 0.5 * std::abs(sum));
      EXPECT_NEAR(expected.back(), kGrey / pi * irradiance(scene, point, false, always_two),
                  1e-3 * expected.back());
    }
  }
  expect_means(pixel_means(scene, 24), expected, 3e-3);
}

TEST(EmittingQuad, InMotionIsItsRetardedIntegral) {
  for (const Vec3& velocity :
       {Vec3(0, 0, 0.6), Vec3(0.5, 0, 0), Vec3(-0.3, -0.1, 0.4), Vec3(0, 0, -0.95)}) {
    for (const bool beaming : {false, true}) {
      LampSetting setting;
      setting.velocity = velocity;
      setting.beaming = beaming;
      Scene scene = lamp_scene(setting);
      // Brought to where it is near the floor's point when its light leaves.
      scene.objects[1].worldline.reference.t = -4;
      scene.objects[1].worldline.reference.x = kCenter - velocity * 2.0;
      SCOPED_TRACE(::testing::Message() << velocity.x << ' ' << velocity.y << ' ' << velocity.z
                                        << (beaming ? " beaming" : ""));
      expect_means(pixel_means(scene, 24), expected_pixels(scene, beaming, always_two), 4e-3);
    }
  }
}

// Brightness over the lamp's own clock, with the delay of each of its points.
TEST(EmittingQuad, ShowsItsOwnRetardedClock) {
  LampSetting setting;
  setting.velocity = {0.3, 0, 0.5};
  setting.emission =
      "emission = \"white\"\nemission_strength = {formula = \"2 + 1.5 * sin(9 * t)\"}";
  setting.clock = "clock = 0.3";
  Scene scene = lamp_scene(setting);
  scene.objects[1].worldline.reference.x = kCenter - setting.velocity * 2.0;
  expect_means(pixel_means(scene, 24),
               expected_pixels(scene, false, [](double t) { return 2 + 1.5 * std::sin(9 * t); }),
               4e-3);
}

// The floor is white, and only the lamp's front shines.
TEST(EmittingQuad, ShinesToItsFrontOnly) {
  Scene scene = lamp_scene({});
  scene.objects[1].worldline.reference.x = {1.5, 1, 0.2};
  scene.objects[1].parts[0].object_from_mesh[0] *= -1.0;  // mirrored, as a whole turned away
  scene.objects[1].worldline.reference.x.x = -1.5;
  Scene turned = scene;
  for (Mesh& mesh : turned.meshes) {
    if (mesh.positions.size() != 4 || glm::length(mesh.positions[0]) > 2) continue;
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    for (Vec3f& n : mesh.normals) n = -n;
  }
  const PixelMeans front = pixel_means(scene, 4), back = pixel_means(turned, 4);
  for (std::size_t i = 0; i < front.mean.size(); ++i) {
    EXPECT_GT(front.mean[i], 0.01);
    EXPECT_EQ(back.mean[i], 0);
  }
  material_of(turned, "lamp").double_sided = true;
  expect_equal_means(pixel_means(turned, 16), pixel_means(scene, 16));
}

TEST(EmittingQuad, ShinesAsMuchAsOfItIsThere) {
  Scene scene = lamp_scene({});
  const PixelMeans whole = pixel_means(scene, 24);
  material_of(scene, "lamp").alpha_mode = AlphaMode::blend;
  material_of(scene, "lamp").opacity.value = 0.25F;
  std::vector<double> quarter;
  for (const double mean : whole.mean) quarter.push_back(0.25 * mean);
  for (const LightSearch search : {LightSearch::both, LightSearch::by_choice}) {
    expect_means(pixel_means(scene, 24, search), quarter, 0.02);
  }
}

// One bright texel in sixteen.
TEST(EmittingQuad, ShinesAsItsTextureSays) {
  Scene scene = lamp_scene({});
  Image image{"dots", 4, 4, std::vector<std::uint8_t>(64, 0)};
  for (int i = 0; i < 4; ++i) image.rgba[static_cast<std::size_t>(4 * 6 + i)] = 255;
  scene.images = {image};
  scene.textures.resize(1);
  scene.textures[0].wrap_u = scene.textures[0].wrap_v = Wrap::clamp;
  scene.textures[0].filter = TextureFilter::nearest;
  material_of(scene, "lamp").emission_texture.texture = 0;
  Mesh* lamp = nullptr;
  for (Mesh& mesh : scene.meshes) {
    if (glm::length(mesh.positions[0]) < 2) lamp = &mesh;
  }
  ASSERT_NE(lamp, nullptr);
  const auto uv_of = [](const Vec3& p) {
    return Vec2f(static_cast<float>(0.5 + 0.5 * glm::dot(p, kU) / glm::dot(kU, kU)),
                 static_cast<float>(0.5 + 0.5 * glm::dot(p, kV) / glm::dot(kV, kV)));
  };
  lamp->uvs[0].clear();
  for (const Vec3f& p : lamp->positions) lamp->uvs[0].push_back(uv_of(Vec3(p)));
  // The texel (2, 1): u from 1/2 to 3/4, v from 1/4 to 1/2.
  Scene part = lamp_scene({});
  for (Mesh& mesh : part.meshes) {
    if (glm::length(mesh.positions[0]) > 2) continue;
    for (Vec3f& p : mesh.positions) {
      p = Vec3f(0.25 * Vec3(p) + 0.25 * kU - 0.25 * kV);
    }
  }
  expect_equal_means(pixel_means(scene, 24), pixel_means(part, 24));
}

// A room with a moving lamp of changing light, behind a half transparent veil, glass and gloss, under
// a sky with a sun, seen from its own velocity.
const std::string kRoom = R"toml(
[camera]
position = [0, 1.2, 4]
look_at = [0, 0.6, 0]
velocity = [0.1, 0, -0.2]
fov = 50
[render]
resolution = [32, 24]
samples = 8
depth = 4
integrator = "path"
beaming = true
[[object]]
name = "floor"
asset = "floor.obj"
material = "floor"
[[object]]
name = "lamp"
asset = "lamp.obj"
position = [1, 2, 0]
time = -4
velocity = [-0.5, 0, 0.1]
material = "lamp"
[[object]]
name = "metal"
sphere = {radius = 0.6, fineness = 4}
position = [-0.9, 0.6, 0]
velocity = [0, 0, -0.3]
material = "metal"
[[object]]
name = "glass"
sphere = {radius = 0.5, fineness = 4}
position = [0.6, 0.5, 0.8]
material = "glass"
[[object]]
name = "veil"
asset = "veil.obj"
position = [0, 0.8, -1.2]
material = "veil"
[[material]]
name = "lamp"
base_color = [0.3, 0.2, 0.1]
emission = "white"
emission_strength = {formula = "3 + 2 * sin(5 * t)"}
[[material]]
name = "metal"
base_color = [0.9, 0.8, 0.6]
metallic = 1
roughness = 0.7
[[material]]
name = "glass"
base_color = "white"
metallic = 0
roughness = 0.6
transmission = 1
ior = 1.4
[[material]]
name = "veil"
base_color = [0.5, 0.7, 0.6]
metallic = 0
roughness = 0.8
opacity = 0.4
[[light]]
type = "environment"
file = "sky.exr"
velocity = [0, 0.3, 0]
rotation = [10, 50, 20]
intensity = 0.5
)toml";

Scene room() {
  Scene scene = loaded_scene(
      kRoom + diffuse_material("floor", 0.6),
      {{"floor.obj", quad_obj({0, 0, 0}, {4, 0, 0}, {0, 0, -4})},
       {"lamp.obj", quad_obj({0, 0, 0}, 2.0 * kU, 2.0 * kV)},
       {"veil.obj", quad_obj({0, 0, 0}, {0.8, 0, 0}, {0, 0.8, 0})},
       {"sky.exr", sky_exr(16, 8, [](int x, int y) {
          return x == 11 && y == 2 ? Vec3f(30)
                                   : Vec3f(0.3F, 0.3F + 0.02F * static_cast<float>(y), 0.5F);
        })}});
  material_of(scene, "veil").alpha_mode = AlphaMode::blend;
  material_of(scene, "veil").double_sided = true;
  return scene;
}

// A clear coat keeps the same part of the lamp's light from what looks for it and from what meets it.
TEST(LightSearch, WaysAgreeOnCoatedLamps) {
  LampSetting lamp;
  lamp.velocity = {0.3, 0, 0.2};
  lamp.emission = "emission = [2, 2, 2]\nclearcoat = 1\nclearcoat_roughness = 0.3";
  const Scene scene = lamp_scene(lamp, 4);
  const PixelMeans by_choice = block_means(scene, 40, 2, LightSearch::by_choice);
  expect_equal_means(by_choice, block_means(scene, 40, 2, LightSearch::by_chance));
}

// All ways to look for light have the same mean. (Of gloss at grazing angles, choosing alone finds too
// seldom what is bright for its spread to be known.)
TEST(LightSearch, WaysAgree) {
  const Scene scene = room();
  const PixelMeans both = block_means(scene, 40, 8);
  expect_equal_means(both, block_means(scene, 40, 8, LightSearch::by_chance));
  expect_equal_means(both, block_means(scene, 40, 8, LightSearch::by_choice));
}

}  // namespace
}  // namespace restframe
