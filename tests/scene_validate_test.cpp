// validate() on the settings and the camera of scenes that a program built.

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

TEST(Validate, FindsNothingInAGoodScene) {
  EXPECT_THAT(validate(good_scene()), IsEmpty());
}

TEST(Validate, AnEmptySceneHasNoObject) {
  EXPECT_THAT(validate(Scene()), ElementsAre(HasSubstr("no object")));
}

// Where how sure pixels are can not be told.
TEST(Validate, Noise) {
  const auto measured = [](Scene& s) { s.output.layers.push_back(Layer::variance); };
  expect_fault([](Scene& s) { s.render.noise = 0.01, s.render.samples = 3; },
               "at least 4, it is 3");
  expect_fault([&](Scene& s) { measured(s), s.render.samples = 1; }, "\"variance\" needs samples");
  const auto combined = [](Scene& s, Combine combine) {
    s.exposure.count = 2;
    s.exposure.combine = combine;
  };
  expect_fault([&](Scene& s) { s.render.noise = 0.01, combined(s, Combine::max); }, "\"max\"");
  expect_fault([&](Scene& s) { measured(s), combined(s, Combine::max); }, "\"max\"");
  expect_fault([](Scene& s) { s.output.layers = {Layer::samples}; }, "tell of the beauty");
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
  expect_fault([](Scene& s) { s.light_speed = 0; }, "light_speed is 0");
  expect_fault([](Scene& s) { s.light_speed = std::nan(""); }, "light_speed");
  expect_fault([](Scene& s) { s.animation.rate = 0; }, "rate is 0");
  expect_fault([](Scene& s) { s.animation.start = inf; }, "start");
  expect_fault([](Scene& s) { s.animation.pictures = 0; }, "pictures is 0");
  expect_fault([](Scene& s) { s.render.width = 0; }, "width is 0, must be from 1 to 32768");
  expect_fault([](Scene& s) { s.render.height = 32769; }, "height is 32769");
  expect_fault([](Scene& s) { s.render.samples = 0; }, "samples is 0, must be from 1 to 65536");
  expect_fault([](Scene& s) { s.render.depth = 0; }, "depth is 0, must be from 1 to 64");
  expect_fault([](Scene& s) { s.render.depth = 65; }, "depth is 65");
  expect_fault([](Scene& s) { s.render.noise = -0.1; }, "noise is -0.1, must be from 0 to 1");
  expect_fault([](Scene& s) { s.render.noise = std::nan(""); }, "noise is");
  expect_fault([](Scene& s) { s.output.exposure = 65; }, "exposure is 65, must be from -64 to 64");
  expect_fault([](Scene& s) { s.output.exposure = std::nan(""); }, "exposure is nan");
  expect_fault(
      [](Scene& s) {
        s.render.observe = WavelengthBand{500, 600};
      },
      "doppler = true only");
  expect_fault(
      [](Scene& s) {
        s.render.doppler = true;
        s.render.observe = WavelengthBand{600, 500};
      },
      "observe: from 600 to 500 nm");
  expect_fault([](Scene& s) { s.output.path = "a.png"; }, ".exr");
  expect_fault([](Scene& s) { s.output.path = "a.exr", s.animation.pictures = 2; }, "run of #");
  expect_fault([](Scene& s) { s.output.path = "#/#.exr"; }, "one run of #");
  expect_fault([](Scene& s) { s.output.path = "out/.exr"; }, ".exr");
  expect_fault([](Scene& s) { s.output.layers.clear(); }, "at least one");
  expect_fault([](Scene& s) { s.output.layers = {Layer::z, Layer::z}; }, "repeat");
}

TEST(Validate, WhatIsRenderedAndHowItIsStored) {
  expect_fault([](Scene& s) { s.render.overscan = -1; }, "overscan is -1, must be from 0 to 4096");
  expect_fault([](Scene& s) { s.render.crop = PixelWindow{0, 0, 0, 1}; }, "must hold a pixel");
  expect_fault(
      [](Scene& s) {
        s.render.crop = PixelWindow{0, 0, s.render.width + 1, 1};
      },
      "lie within");
  expect_fault([](Scene& s) { s.render.crop = PixelWindow{-1, 0, 1, 1}; }, "crop [-1, 0, 1, 1]");
  expect_fault([](Scene& s) { s.output.compression_level = -1; }, "compression_level is -1");
  expect_fault([](Scene& s) { s.output.compression_level = std::nan(""); },
               "compression_level is nan");
  expect_fault([](Scene& s) { s.output.half_layers = {Layer::uv}; }, "among `layers`");
  expect_fault([](Scene& s) { s.output.float_layers = {Layer::uv}; }, "among `layers`");
  expect_fault([](Scene& s) { s.output.half_layers = s.output.float_layers = {Layer::z}; },
               "both half");
  expect_fault(
      [](Scene& s) {
        s.output.layers = {Layer::id};
        s.output.half_layers = {Layer::id};
      },
      "half can not hold");
  expect_fault([](Scene& s) { s.camera.stereo = StereoSettings{-1, 0}; }, "separation is -1");
  expect_fault([](Scene& s) { s.camera.stereo = StereoSettings{1, inf}; }, "convergence is inf");
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

void expect_camera_fault(const std::function<void(Camera&)>& spoil, const char* words) {
  expect_fault([&](Scene& s) { spoil(s.camera); }, words);
}

TEST(Validate, Lens) {
  expect_camera_fault([](Camera& c) { c.aperture = -1; }, "aperture is -1, must be from 0");
  expect_camera_fault([](Camera& c) { c.aperture = inf; }, "aperture is inf");
  expect_camera_fault([](Camera& c) { c.focus = 0; }, "focus is 0, must be above 0");
  expect_camera_fault([](Camera& c) { c.rolling = -1; }, "rolling is -1, must be from 0");
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
  expect_camera_fault([](Camera& c) { c.vertical_fov = 0; }, "fov is 0");
  expect_camera_fault([](Camera& c) { c.vertical_fov = 3.2; }, "below 180");
  expect_camera_fault([](Camera& c) { std::get<Worldline>(c.motion).reference.t = inf; },
                      "position and time");
  expect_camera_fault(
      [](Camera& c) {
        std::get<Worldline>(c.motion).velocity = Velocity::from_beta({0, 0, 1});
      },
      "|velocity|");
  expect_camera_fault(
      [](Camera& c) {
        std::get<Worldline>(c.motion).velocity = Velocity::from_beta({0, 0, 2});
      },
      "|velocity|");
  expect_camera_fault([](Camera& c) { c.aim = AimDirection{{0, 1, 0}}; }, "along up");
  expect_camera_fault([](Camera& c) { c.aim = AimDirection{{0, 0, 0}}; }, "direction");
  expect_camera_fault([](Camera& c) { c.aim = AimPoint{{0, inf, 0}}; }, "look_at");
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
