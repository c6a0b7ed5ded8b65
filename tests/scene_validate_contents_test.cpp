// validate() on what a program put into a scene: objects, meshes, materials and lights.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/spoilt_scene.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr float inff = std::numeric_limits<float>::infinity();

TEST(Validate, Objects) {
  const auto one = [](const std::function<void(Object&)>& spoil, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { spoil(s.objects[0]); }), ElementsAre(HasSubstr(words)));
  };
  one([](Object& o) { o.worldline.reference.x.y = std::nan(""); }, "object \"thing\": position");
  one([](Object& o) { o.worldline.velocity = Velocity::from_beta({0.8, 0.8, 0}); }, "|velocity|");
  one([](Object& o) { o.clock = inf; }, "clock");
  one([](Object& o) { o.parts[0].mesh = 1; }, "mesh 1 of 1");
  one([](Object& o) { o.parts[0].mesh = -1; }, "mesh -1");
  one([](Object& o) { o.parts[0].object_from_mesh[3].x = inf; }, "matrix");
  one([](Object& o) { o.parts[0].object_from_mesh[1] = {0, 0, 0, 0}; }, "matrix");
  one([](Object& o) { o.parts[0].object_from_mesh[0].w = 1; }, "matrix");
  one([](Object& o) { o.materials = {1}; }, "material 1 of 1");
  one([](Object& o) { o.materials = {}; }, "material slot 0");
  EXPECT_THAT(faults([](Scene& s) { s.objects.push_back(s.objects[0]); }),
              ElementsAre(HasSubstr("two objects are object \"thing\"")));
}

TEST(Validate, Meshes) {
  const auto one = [](const std::function<void(Mesh&)>& spoil, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { spoil(s.meshes[0]); }), ElementsAre(HasSubstr(words)));
  };
  one([](Mesh& m) { m.positions[1].z = std::nanf(""); }, "vertex 1");
  one([](Mesh& m) { m.positions[2].x = 1e16F; }, "1e15");
  one([](Mesh& m) { m.triangles[0][2] = 3; }, "triangle 0 refers to a vertex beyond its 3");
  one([](Mesh& m) { m.normals = {{0, 0, 1}}; }, "1 normals for 3 vertices");
  one([](Mesh& m) { m.uvs[1] = {{0, 0}}; }, "1 texture coordinates (set 1)");
  one([](Mesh& m) { m.uvs.resize(3, {{0, 0}}); }, "1 texture coordinates (set 2)");
  one(
      [](Mesh& m) {
        m.normals.resize(3, {0, 0, 1});
        m.tangents.resize(2);
      },
      "2 tangents");
  one([](Mesh& m) { m.tangents.resize(3); }, "has tangents but no normals");
  one([](Mesh& m) { m.colors.resize(2); }, "2 colours");
  one([](Mesh& m) { m.materials.clear(); }, "no material range");
  one([](Mesh& m) { m.materials = {{0, 0}, {2, 0}, {1, 0}}; }, "out of order");
}

TEST(Validate, Materials) {
  expect_fault([](Scene& s) { s.materials[0].base_color.function = 1; },
               "temporal function 1 of 1");
  expect_fault([](Scene& s) { s.materials[0].base_color.value.y = std::nanf(""); }, "base_color");
  expect_fault([](Scene& s) { s.materials[0].emission.value.x = -1; }, "emission");
  expect_fault([](Scene& s) { s.materials[0].opacity.value = std::nanf(""); }, "opacity");
  expect_fault([](Scene& s) { s.materials[0].ior.value = 0.5F; }, "ior is 0.5, must be at least 1");
  expect_fault([](Scene& s) { s.materials[0].ior.value = std::nanf(""); }, "ior");
  expect_fault([](Scene& s) { s.materials[0].ior.value = INFINITY; }, "ior is inf");
  expect_fault([](Scene& s) { s.materials[0].transmission.value = 1.5F; },
               "transmission is 1.5, must be from 0 to 1");
  expect_fault([](Scene& s) { s.materials[0].transmission.function = -2; }, "temporal function -2");
  expect_fault([](Scene& s) { s.materials[0].attenuation_color.value.z = 2; }, "attenuation_color");
  expect_fault([](Scene& s) { s.materials[0].attenuation_distance.value = -1; },
               "attenuation_distance");
  expect_fault([](Scene& s) { s.materials[0].specular.value = 1.5F; },
               "specular is 1.5, must be from 0 to 1");
  expect_fault([](Scene& s) { s.materials[0].specular_color.value.x = -1; }, "must be at least 0");
  expect_fault([](Scene& s) { s.materials[0].clearcoat.value = 2; }, "clearcoat is 2");
  expect_fault([](Scene& s) { s.materials[0].clearcoat_roughness.value = -1; },
               "clearcoat_roughness");
  expect_fault([](Scene& s) { s.materials[0].clearcoat_normal_scale = NAN; },
               "clearcoat_normal_scale");
  expect_fault([](Scene& s) { s.materials[0].sheen_color.value.y = 2; }, "sheen_color");
  expect_fault([](Scene& s) { s.materials[0].sheen_roughness.value = 2; }, "sheen_roughness");
  expect_fault([](Scene& s) { s.materials[0].normal_scale.value = INFINITY; },
               "normal_scale is inf, must be finite");
  expect_fault([](Scene& s) { s.materials[0].emission_temperature.value = 20; },
               "\"paint\": emission: the temperature is 20");
  expect_fault(
      [](Scene& s) {
        s.materials[0].emission_spectrum.points = {{500, 1}, {400, 1}};
      },
      "shorter wavelength");
}

TEST(Validate, TexturesImagesAndFunctions) {
  expect_fault([](Scene& s) { s.materials[0].base_color_texture.texture = 1; }, "texture 1 of 1");
  expect_fault([](Scene& s) { s.materials[0].base_color_texture.uv_set = -1; }, "UV set -1");
  expect_fault([](Scene& s) { s.materials[0].base_color_texture.transform.offset.y = INFINITY; },
               "base_color_texture has a transform that is not finite");
  expect_fault([](Scene& s) { s.materials[0].sheen_roughness_texture.texture = 1; },
               "sheen_roughness_texture refers to texture 1 of 1");
  expect_fault([](Scene& s) { s.textures[0].image = 1; }, "image 1 of 1");
  expect_fault([](Scene& s) { s.images[0].rgba.pop_back(); }, "3 bytes");
  expect_fault([](Scene& s) { s.images[0].width = 0; }, "0 x 1");
  expect_fault([](Scene& s) { std::get<IntervalFunction>(s.functions[0]).period = 0; },
               "period is 0");
  expect_fault(
      [](Scene& s) {
        s.functions[0] = FormulaFunction{{"t="}, {}, {}};
      },
      "temporal function 0");
}

void expect_light_fault(const std::function<void(Light&)>& spoil, const char* words) {
  expect_fault([&](Scene& s) { spoil(s.lights.emplace_back()); }, words);
}

TEST(Validate, WhereLightsShine) {
  expect_light_fault([](Light& l) { l.worldline.reference.x.y = std::nan(""); },
                     "light \"\": position");
  expect_light_fault(
      [](Light& l) {
        l.worldline.velocity = Velocity::from_beta({0.8, 0.8, 0});
      },
      "|velocity|");
  expect_light_fault([](Light& l) { l.clock = inf; }, "clock");
  expect_light_fault([](Light& l) { l.direction = {0, 0, 2}; }, "direction must be of length 1");
  expect_light_fault([](Light& l) { l.direction.x = std::nan(""); }, "direction");
  expect_light_fault([](Light& l) { l.inner_cone = 1, l.outer_cone = 0.5; }, "cone");
  expect_light_fault([](Light& l) { l.inner_cone = -0.1; }, "cone");
  expect_light_fault([](Light& l) { l.outer_cone = 1.6; }, "cone");
  expect_light_fault([](Light& l) { l.outer_cone = 0; }, "cone is [0, 0]");
  expect_light_fault([](Light& l) { l.outer_cone = std::nan(""); }, "cone");
  EXPECT_THAT(faults([](Scene& s) { s.lights.resize(2); }),
              ElementsAre(HasSubstr("two lights are light \"\"")));
}

TEST(Validate, SweepsOfLights) {
  EXPECT_THAT(faults([](Scene& s) {
                s.lights.emplace_back().kind = LightKind::spot;
                s.lights[0].sweep = Sweep();
              }),
              IsEmpty());
  expect_light_fault(
      [](Light& l) {
        l.kind = LightKind::sun;
        l.sweep = Sweep();
      },
      "sweep goes with spots only");
  expect_light_fault(
      [](Light& l) {
        l.kind = LightKind::spot;
        l.sweep = Sweep{{0, 0, 0}, 1};
      },
      "axis of sweep");
  expect_light_fault(
      [](Light& l) {
        l.kind = LightKind::spot;
        l.sweep = Sweep{{0, 1, 0}, 0};
      },
      "period of sweep is 0");
  expect_light_fault(
      [](Light& l) {
        l.kind = LightKind::spot;
        l.sweep = Sweep{{0, 1, 0}, inf};
      },
      "period of sweep is inf");
}

TEST(Validate, TheLightOfLights) {
  expect_light_fault([](Light& l) { l.temperature.value = 20; }, "temperature is 20, must be 500");
  expect_light_fault([](Light& l) { l.temperature.value = -1; }, "temperature is -1");
  expect_light_fault([](Light& l) { l.temperature.function = 3; },
                     "temperature refers to temporal function 3");
  expect_light_fault(
      [](Light& l) {
        l.spectrum.lines = {{600, inff, 1}};
      },
      "power of line 0 is inf");
  expect_light_fault([](Light& l) { l.color.value.x = -1; }, "color is [-1, 1, 1]");
  expect_light_fault([](Light& l) { l.color.function = 1; },
                     "color refers to temporal function 1 of 1");
  expect_light_fault([](Light& l) { l.intensity.value = std::nanf(""); }, "intensity is nan");
  expect_light_fault([](Light& l) { l.intensity.value = -1; },
                     "intensity is -1, must be at least 0");
}

TEST(Validate, SkyMaps) {
  const auto one = [](const std::function<void(Scene&)>& spoil, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) {
                  s.sky_maps = {{"sky", 2, 1, {Vec3f(1), Vec3f(2)}}};
                  s.lights.emplace_back().kind = LightKind::environment;
                  s.lights[0].sky_map = 0;
                  spoil(s);
                }),
                ElementsAre(HasSubstr(words)));
  };
  one([](Scene& s) { s.lights[0].sky_map = 1; }, "refers to sky map 1 of 1");
  one([](Scene& s) { s.lights[0].sky_map = -2; }, "refers to sky map -2 of 1");
  one([](Scene& s) { s.lights[0].kind = LightKind::sun; }, "goes with environments only");
  one([](Scene& s) { s.lights[0].rest_from_map[0] = {2, 0, 0}; }, "turned by a rotation");
  one([](Scene& s) { s.lights[0].rest_from_map[0] = {-1, 0, 0}; }, "turned by a rotation");
  one([](Scene& s) { s.lights[0].rest_from_map[0].x = std::nan(""); }, "turned by a rotation");
  one([](Scene& s) { s.sky_maps[0].pixels.pop_back(); }, "has 1 pixels for 2 x 1");
  one([](Scene& s) { s.sky_maps[0].height = -1; }, "has 2 pixels for 2 x -1");
  one([](Scene& s) { s.sky_maps[0].pixels[1].y = -1; }, "pixel [2, -1, 2]");
  one([](Scene& s) { s.sky_maps[0].pixels[1].y = std::nanf(""); }, "at least 0 and finite");
}

}  // namespace
}  // namespace restframe
