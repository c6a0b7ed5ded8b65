// validate() on scenes that a program built.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "scene/scene.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr float inff = std::numeric_limits<float>::infinity();

// A triangle of one textured material.
Scene good_scene() {
  Scene scene;
  Mesh mesh;
  mesh.name = "triangle";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.uvs[0] = {{0, 0}, {1, 0}, {0, 1}};
  mesh.materials = {{0, 0}};
  scene.meshes.push_back(mesh);
  scene.images.push_back({"dot", 1, 1, {255, 255, 255, 255}});
  scene.textures.push_back({});
  scene.functions.push_back(IntervalFunction{1.0, {{0, 0.5, Vec3f(1)}}});
  Material material;
  material.name = "paint";
  material.base_color_texture = {0, 0};
  material.base_color.function = 0;
  scene.materials.push_back(material);
  Object object;
  object.name = "thing";
  object.parts.push_back({0, Mat4(1)});
  object.materials = {0};
  scene.objects.push_back(object);
  scene.camera_given = true;
  return scene;
}

// The faults after `spoil`.
std::vector<std::string> faults(const std::function<void(Scene&)>& spoil) {
  Scene scene = good_scene();
  spoil(scene);
  return validate(scene);
}

TEST(Validate, FindsNothingInAGoodScene) {
  EXPECT_THAT(validate(good_scene()), IsEmpty());
}

TEST(Validate, AnEmptySceneHasNoObject) {
  EXPECT_THAT(validate(Scene()), ElementsAre(HasSubstr("no object")));
}

// Where how sure pixels are can not be told.
TEST(Validate, Noise) {
  const auto one = [](const std::function<void(Scene&)>& spoil, const char* words) {
    EXPECT_THAT(faults(spoil), ElementsAre(HasSubstr(words)));
  };
  const auto measured = [](Scene& s) { s.output.layers.push_back(Layer::variance); };
  one([](Scene& s) { s.render.noise = 0.01, s.render.samples = 3; }, "at least 4, it is 3");
  one([&](Scene& s) { measured(s), s.render.samples = 1; }, "\"variance\" needs samples");
  const auto combined = [](Scene& s, Combine combine) {
    s.exposure.count = 2;
    s.exposure.combine = combine;
  };
  one([&](Scene& s) { s.render.noise = 0.01, combined(s, Combine::max); }, "\"max\"");
  one([&](Scene& s) { measured(s), combined(s, Combine::max); }, "\"max\"");
  one([](Scene& s) { s.output.layers = {Layer::samples}; }, "tell of the beauty");
  EXPECT_THAT(faults([&](Scene& s) {
                measured(s), combined(s, Combine::sum);
                s.render.noise = 0.01;
                s.render.samples = 4;
                s.output.layers.push_back(Layer::samples);
              }),
              IsEmpty());
  EXPECT_THAT(faults([&](Scene& s) { combined(s, Combine::max); }), IsEmpty());
}

TEST(Validate, Settings) {
  const auto one = [](const std::function<void(Scene&)>& spoil, const char* words) {
    EXPECT_THAT(faults(spoil), ElementsAre(HasSubstr(words)));
  };
  one([](Scene& s) { s.light_speed = 0; }, "light_speed is 0");
  one([](Scene& s) { s.light_speed = std::nan(""); }, "light_speed");
  one([](Scene& s) { s.animation.rate = 0; }, "rate is 0");
  one([](Scene& s) { s.animation.start = inf; }, "start");
  one([](Scene& s) { s.animation.pictures = 0; }, "pictures is 0");
  one([](Scene& s) { s.render.width = 0; }, "width is 0, must be from 1 to 32768");
  one([](Scene& s) { s.render.height = 32769; }, "height is 32769");
  one([](Scene& s) { s.render.samples = 0; }, "samples is 0, must be from 1 to 65536");
  one([](Scene& s) { s.render.depth = 0; }, "depth is 0, must be from 1 to 64");
  one([](Scene& s) { s.render.depth = 65; }, "depth is 65");
  one([](Scene& s) { s.render.noise = -0.1; }, "noise is -0.1, must be from 0 to 1");
  one([](Scene& s) { s.render.noise = std::nan(""); }, "noise is");
  one([](Scene& s) { s.output.exposure = 65; }, "exposure is 65, must be from -64 to 64");
  one([](Scene& s) { s.output.exposure = std::nan(""); }, "exposure is nan");
  one([](Scene& s) { s.render.observe = WavelengthBand{500, 600}; }, "doppler = true only");
  one(
      [](Scene& s) {
        s.render.doppler = true;
        s.render.observe = WavelengthBand{600, 500};
      },
      "observe: from 600 to 500 nm");
  one([](Scene& s) { s.output.path = "a.png"; }, ".exr");
  one([](Scene& s) { s.output.path = "a.exr", s.animation.pictures = 2; }, "run of #");
  one([](Scene& s) { s.output.path = "#/#.exr"; }, "one run of #");
  one([](Scene& s) { s.output.path = "out/.exr"; }, ".exr");
  one([](Scene& s) { s.output.layers.clear(); }, "at least one");
  one([](Scene& s) { s.output.layers = {Layer::z, Layer::z}; }, "repeat");
}

TEST(Validate, WhatIsRenderedAndHowItIsStored) {
  const auto one = [](const std::function<void(Scene&)>& spoil, const char* words) {
    EXPECT_THAT(faults(spoil), ElementsAre(HasSubstr(words)));
  };
  one([](Scene& s) { s.render.overscan = -1; }, "overscan is -1, must be from 0 to 4096");
  one([](Scene& s) { s.render.crop = PixelWindow{0, 0, 0, 1}; }, "must hold a pixel");
  one([](Scene& s) { s.render.crop = PixelWindow{0, 0, s.render.width + 1, 1}; }, "lie within");
  one([](Scene& s) { s.render.crop = PixelWindow{-1, 0, 1, 1}; }, "crop [-1, 0, 1, 1]");
  one([](Scene& s) { s.output.compression_level = -1; }, "compression_level is -1");
  one([](Scene& s) { s.output.compression_level = std::nan(""); }, "compression_level is nan");
  one([](Scene& s) { s.output.half_layers = {Layer::uv}; }, "among `layers`");
  one([](Scene& s) { s.output.float_layers = {Layer::uv}; }, "among `layers`");
  one([](Scene& s) { s.output.half_layers = s.output.float_layers = {Layer::z}; }, "both half");
  one(
      [](Scene& s) {
        s.output.layers = {Layer::id};
        s.output.half_layers = {Layer::id};
      },
      "half can not hold");
  one([](Scene& s) { s.camera.stereo = StereoSettings{-1, 0}; }, "separation is -1");
  one([](Scene& s) { s.camera.stereo = StereoSettings{1, inf}; }, "convergence is inf");
  EXPECT_THAT(faults([](Scene& s) {
                s.render.overscan = 5;
                s.render.crop = PixelWindow{-5, -5, 3, 3};
                s.output.half_layers = {Layer::z};
                s.output.float_layers = {Layer::beauty};
                s.camera.stereo = StereoSettings{0.1, 0};
              }),
              IsEmpty());
}

TEST(Validate, Exposure) {
  const auto one = [](const std::function<void(ExposureSettings&)>& spoil, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { spoil(s.exposure); }), ElementsAre(HasSubstr(words)));
  };
  one([](ExposureSettings& e) { e.shutter = -1; }, "shutter is -1, must be from 0");
  one([](ExposureSettings& e) { e.shutter = std::nan(""); }, "shutter");
  one([](ExposureSettings& e) { e.count = 0; }, "count is 0, must be from 1 to 65536");
  one([](ExposureSettings& e) { e.count = 65537; }, "count is 65537");
  one([](ExposureSettings& e) { e.interval = -1; }, "interval is -1");
  one([](ExposureSettings& e) { e.count = 2, e.interval = 0; }, "above 0 with several");
  one([](ExposureSettings& e) { e.shape = ShutterShape::curve; }, "never open");
  one(
      [](ExposureSettings& e) {
        e.shape = ShutterShape::curve, e.curve = {{0, 1}, {1, inf}};
      },
      "openness is inf");
  one(
      [](ExposureSettings& e) {
        e.shape = ShutterShape::curve, e.curve = {{0, 1}, {2, 1}};
      },
      "2 is out of place");
}

TEST(Validate, Lens) {
  const auto one = [](const std::function<void(Camera&)>& spoil, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { spoil(s.camera); }), ElementsAre(HasSubstr(words)));
  };
  one([](Camera& c) { c.aperture = -1; }, "aperture is -1, must be from 0");
  one([](Camera& c) { c.aperture = inf; }, "aperture is inf");
  one([](Camera& c) { c.focus = 0; }, "focus is 0, must be above 0");
  one([](Camera& c) { c.rolling = -1; }, "rolling is -1, must be from 0");
}

TEST(Validate, Mattes) {
  const auto with = [](const std::vector<Layer>& halves) {
    return faults([&](Scene& s) {
      s.output.layers = {Layer::beauty, Layer::crypto_material};
      s.output.half_layers = halves;
      s.output.compression = Compression::dwaa;  // not of them
    });
  };
  EXPECT_THAT(with({}), IsEmpty());
  EXPECT_THAT(with({Layer::crypto_material}), ElementsAre(HasSubstr("half can not hold")));
  for (const int name : {-2, 1}) {
    EXPECT_THAT(faults([&](Scene& s) {
                  s.objects[0].part_names = {"only"};
                  s.objects[0].parts[0].name = name;
                }),
                ElementsAre(HasSubstr("of 1")));
  }
}

TEST(Validate, Camera) {
  const auto one = [](const std::function<void(Camera&)>& spoil, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { spoil(s.camera); }), ElementsAre(HasSubstr(words)));
  };
  one([](Camera& c) { c.vertical_fov = 0; }, "fov is 0");
  one([](Camera& c) { c.vertical_fov = 3.2; }, "below 180");
  one([](Camera& c) { std::get<Worldline>(c.motion).reference.t = inf; }, "position and time");
  one(
      [](Camera& c) {
        std::get<Worldline>(c.motion).velocity = Velocity::from_beta({0, 0, 1});
      },
      "|velocity|");
  one(
      [](Camera& c) {
        std::get<Worldline>(c.motion).velocity = Velocity::from_beta({0, 0, 2});
      },
      "|velocity|");
  one([](Camera& c) { c.aim = AimDirection{{0, 1, 0}}; }, "along up");
  one([](Camera& c) { c.aim = AimDirection{{0, 0, 0}}; }, "direction");
  one([](Camera& c) { c.aim = AimPoint{{0, inf, 0}}; }, "look_at");
  EXPECT_THAT(faults([](Scene& s) { s.camera_given = false, s.camera.vertical_fov = 0; }),
              IsEmpty())
      << "a camera that is not given is not used";
}

TEST(Validate, CameraMotion) {
  const auto one = [](const CameraMotion& motion, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { s.camera.motion = motion; }), ElementsAre(HasSubstr(words)));
  };
  const auto path = [](const std::vector<PathKey>& keys) { return KeyedPath(0, keys, false); };
  EXPECT_THAT(faults([&](Scene& s) { s.camera.motion = path({{0, Vec3(0), {}}}); }), IsEmpty());
  one(path({}), "at least one key");
  one(path({{1, Vec3(0), {}}, {0, Vec3(0), {}}}), "must be finite and rise");
  one(path({{0, {0, inf, 0}, {}}}), "key 0: position and time");
  one(path({{0, Vec3(0), {}}, {1e-9, {1, 0, 0}, {}}, {2, {1, 0, 0}, {}}}),
      "key 0: gamma is 999999999");
  one(KeyedPath(0, {{0, Vec3(0), Velocity::from_gamma(1e9, {1, 0, 0})}}, true), "key 0: gamma is");
  one(KeyedPath(inf, {{0, Vec3(0), {}}}, false), "key 0: position and time");

  const auto legs = [](const std::vector<AccelerationLeg>& all) {
    return AcceleratedPath(Worldline{}, all);
  };
  EXPECT_THAT(faults([&](Scene& s) { s.camera.motion = legs({{1, {1, 0, 0}}}); }), IsEmpty());
  EXPECT_THAT(faults([&](Scene& s) { s.camera.motion = legs({}); }), IsEmpty());
  one(legs({{0, {1, 0, 0}}}), "leg 0: duration is 0, must be above 0");
  one(legs({{1, {1, 0, 0}}, {20, {1, 0, 0}}}), "leg 1: gamma is");
  one(legs({{1e101, {0, 0, 0}}}), "leg 0 must end within");
  one(AcceleratedPath({{inf, {0, 0, 0}}, {}}, {}), "position and time");
  EXPECT_THAT(faults([&](Scene& s) {
                s.camera.motion = legs({{1, {inf, 0, 0}}});
              }),
              ::testing::Contains(HasSubstr("leg 0: acceleration must be finite")));
  EXPECT_THAT(faults([&](Scene& s) {
                s.camera.motion = Worldline{{0, {0, 0, 0}}, Velocity::from_gamma(1e8, {1, 0, 0})};
                s.animation.start = 1e99;
              }),
              ElementsAre(HasSubstr("picture 0: camera: it is farther than 1e100")));
}

TEST(Validate, CameraViewKeys) {
  const auto one = [](const std::vector<ViewKey>& keys, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { s.camera.view_keys = keys; }),
                ElementsAre(HasSubstr(words)));
  };
  const AimDirection ahead{{0, 0, -1}}, back{{0, 0, 1}};
  EXPECT_THAT(faults([&](Scene& s) {
                s.camera.view_keys = {{0, ahead, 1}, {1, ahead, 2}};
              }),
              IsEmpty());
  one({{1, ahead, 1}, {1, ahead, 1}}, "view keys must be finite and rise");
  one({{std::nan(""), ahead, 1}}, "view keys must be finite and rise");
  one({{0, ahead, 1}, {1, ahead, 4}}, "view key 1: fov is");
  one({{0, ahead, 1}, {1, AimPoint{}, 1}}, "view key 1 has another kind of aim");
  one({{0, ahead, 1}, {1, back, 1}}, "view key 1 looks the opposite way");
  one({{0, AimDirection{{0, 1, 0}}, 1}}, "view key 0: direction");
  one({{0, AimPoint{{inf, 0, 0}}, 1}}, "view key 0: look_at");
  one({{0, AimTrack{{{inf, {0, 0, 0}}, {}}, "a"}, 1}}, "view key 0: track: position and time");
  EXPECT_THAT(faults([](Scene& s) {
                s.camera.aim = AimTrack{{{0, {0, 0, 0}}, {}}, "thing"};
              }),
              ElementsAre(HasSubstr("picture 0: camera: it meets \"thing\"")));
  const auto meets_at_half = [](Scene& s) {
    s.camera.motion = Worldline{{0, {0, 0, 0.375}}, Velocity::from_gamma_beta({0, 0, -0.75})};
    s.camera.aim = AimPoint{};
    s.exposure.interval = 0.25;
  };
  EXPECT_THAT(faults(meets_at_half), IsEmpty());
  EXPECT_THAT(faults([&](Scene& s) { meets_at_half(s), s.exposure.count = 3; }),
              ElementsAre(HasSubstr("picture 0: camera: it is at its look_at point")));
}

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

TEST(Validate, MaterialsTexturesAndFunctions) {
  const auto one = [](const std::function<void(Scene&)>& spoil, const char* words) {
    EXPECT_THAT(faults(spoil), ElementsAre(HasSubstr(words)));
  };
  one([](Scene& s) { s.materials[0].base_color.function = 1; }, "temporal function 1 of 1");
  one([](Scene& s) { s.materials[0].base_color.value.y = std::nanf(""); }, "base_color");
  one([](Scene& s) { s.materials[0].emission.value.x = -1; }, "emission");
  one([](Scene& s) { s.materials[0].opacity.value = std::nanf(""); }, "opacity");
  one([](Scene& s) { s.materials[0].ior.value = 0.5F; }, "ior is 0.5, must be at least 1");
  one([](Scene& s) { s.materials[0].ior.value = std::nanf(""); }, "ior");
  one([](Scene& s) { s.materials[0].ior.value = INFINITY; }, "ior is inf");
  one([](Scene& s) { s.materials[0].transmission.value = 1.5F; },
      "transmission is 1.5, must be from 0 to 1");
  one([](Scene& s) { s.materials[0].transmission.function = -2; }, "temporal function -2");
  one([](Scene& s) { s.materials[0].attenuation_color.value.z = 2; }, "attenuation_color");
  one([](Scene& s) { s.materials[0].attenuation_distance.value = -1; }, "attenuation_distance");
  one([](Scene& s) { s.materials[0].base_color_texture.texture = 1; }, "texture 1 of 1");
  one([](Scene& s) { s.materials[0].base_color_texture.uv_set = -1; }, "UV set -1");
  one([](Scene& s) { s.materials[0].base_color_texture.transform.offset.y = INFINITY; },
      "base_color_texture has a transform that is not finite");
  one([](Scene& s) { s.materials[0].sheen_roughness_texture.texture = 1; },
      "sheen_roughness_texture refers to texture 1 of 1");
  one([](Scene& s) { s.materials[0].specular.value = 1.5F; },
      "specular is 1.5, must be from 0 to 1");
  one([](Scene& s) { s.materials[0].specular_color.value.x = -1; }, "must be at least 0");
  one([](Scene& s) { s.materials[0].clearcoat.value = 2; }, "clearcoat is 2");
  one([](Scene& s) { s.materials[0].clearcoat_roughness.value = -1; }, "clearcoat_roughness");
  one([](Scene& s) { s.materials[0].clearcoat_normal_scale = NAN; }, "clearcoat_normal_scale");
  one([](Scene& s) { s.materials[0].sheen_color.value.y = 2; }, "sheen_color");
  one([](Scene& s) { s.materials[0].sheen_roughness.value = 2; }, "sheen_roughness");
  one([](Scene& s) { s.materials[0].normal_scale.value = INFINITY; },
      "normal_scale is inf, must be finite");
  one([](Scene& s) { s.textures[0].image = 1; }, "image 1 of 1");
  one([](Scene& s) { s.materials[0].emission_temperature.value = 20; },
      "\"paint\": emission: the temperature is 20");
  one(
      [](Scene& s) {
        s.materials[0].emission_spectrum.points = {{500, 1}, {400, 1}};
      },
      "shorter wavelength");
  one([](Scene& s) { s.images[0].rgba.pop_back(); }, "3 bytes");
  one([](Scene& s) { s.images[0].width = 0; }, "0 x 1");
  one([](Scene& s) { std::get<IntervalFunction>(s.functions[0]).period = 0; }, "period is 0");
  one([](Scene& s) { s.functions[0] = FormulaFunction{{"t="}, {}, {}}; }, "temporal function 0");
}

TEST(Validate, Lights) {
  const auto one = [](const std::function<void(Light&)>& spoil, const char* words) {
    EXPECT_THAT(faults([&](Scene& s) { spoil(s.lights.emplace_back()); }),
                ElementsAre(HasSubstr(words)));
  };
  EXPECT_THAT(faults([](Scene& s) {
                s.lights.emplace_back().kind = LightKind::spot;
                s.lights[0].sweep = Sweep();
              }),
              IsEmpty());
  one(
      [](Light& l) {
        l.kind = LightKind::sun;
        l.sweep = Sweep();
      },
      "sweep goes with spots only");
  one([](Light& l) { l.worldline.reference.x.y = std::nan(""); }, "light \"\": position");
  one([](Light& l) { l.worldline.velocity = Velocity::from_beta({0.8, 0.8, 0}); }, "|velocity|");
  one([](Light& l) { l.clock = inf; }, "clock");
  one([](Light& l) { l.temperature.value = 20; }, "temperature is 20, must be 500");
  one([](Light& l) { l.temperature.value = -1; }, "temperature is -1");
  one([](Light& l) { l.temperature.function = 3; }, "temperature refers to temporal function 3");
  one([](Light& l) { l.spectrum.lines = {{600, inff, 1}}; }, "power of line 0 is inf");
  one([](Light& l) { l.direction = {0, 0, 2}; }, "direction must be of length 1");
  one([](Light& l) { l.direction.x = std::nan(""); }, "direction");
  one([](Light& l) { l.inner_cone = 1, l.outer_cone = 0.5; }, "cone");
  one([](Light& l) { l.inner_cone = -0.1; }, "cone");
  one([](Light& l) { l.outer_cone = 1.6; }, "cone");
  one([](Light& l) { l.outer_cone = 0; }, "cone is [0, 0]");
  one([](Light& l) { l.outer_cone = std::nan(""); }, "cone");
  one(
      [](Light& l) {
        l.kind = LightKind::spot;
        l.sweep = Sweep{{0, 0, 0}, 1};
      },
      "axis of sweep");
  one(
      [](Light& l) {
        l.kind = LightKind::spot;
        l.sweep = Sweep{{0, 1, 0}, 0};
      },
      "period of sweep is 0");
  one(
      [](Light& l) {
        l.kind = LightKind::spot;
        l.sweep = Sweep{{0, 1, 0}, inf};
      },
      "period of sweep is inf");
  one([](Light& l) { l.color.value.x = -1; }, "color is [-1, 1, 1]");
  one([](Light& l) { l.color.function = 1; }, "color refers to temporal function 1 of 1");
  one([](Light& l) { l.intensity.value = std::nanf(""); }, "intensity is nan");
  one([](Light& l) { l.intensity.value = -1; }, "intensity is -1, must be at least 0");
  EXPECT_THAT(faults([](Scene& s) { s.lights.resize(2); }),
              ElementsAre(HasSubstr("two lights are light \"\"")));
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

TEST(Validate, ListsEveryFault) {
  EXPECT_EQ(faults([](Scene& s) {
              s.light_speed = -1;
              s.render.samples = -1;
              s.objects[0].clock = inf;
              s.meshes[0].triangles[0][0] = 9;
            }).size(),
            4U);
}

}  // namespace
}  // namespace restframe
