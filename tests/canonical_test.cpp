// The canonical text of a scene changes with every setting that changes pixels, and with nothing else.

#include "scene/canonical.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "support/canonical_changes.h"

namespace restframe {
namespace {

TEST(Canonical, SameScenesHaveTheSameText) {
  EXPECT_EQ(canonical_settings(canonical_base()), canonical_settings(canonical_base()));
}

TEST(Canonical, ChangesWithTheCamera) {
  expect_all_different({
      {"position", [](Scene& s) { std::get<Worldline>(s.camera.motion).reference.x.y = 1e-300; }},
      {"time", [](Scene& s) { std::get<Worldline>(s.camera.motion).reference.t = 1; }},
      {"velocity",
       [](Scene& s) {
         std::get<Worldline>(s.camera.motion).velocity = Velocity::from_beta({0.1, 0, 0});
       }},
      {"direction",
       [](Scene& s) {
         s.camera.aim = AimDirection{{0, 0, 1}};
       }},
      {"look_at",
       [](Scene& s) {
         s.camera.aim = AimPoint{{0, 0, 1}};
       }},
      {"look_at elsewhere",
       [](Scene& s) {
         s.camera.aim = AimPoint{{0, 0, 2}};
       }},
      {"up",
       [](Scene& s) {
         s.camera.up = {1, 0, 0};
       }},
      {"fov", [](Scene& s) { s.camera.vertical_fov = std::nextafter(1.0, 2.0); }},
      {"aperture", [](Scene& s) { s.camera.aperture = 0.1; }},
      {"focus", [](Scene& s) { s.camera.focus = 0.1; }},
      {"rolling", [](Scene& s) { s.camera.rolling = 0.1; }},
      {"two eyes", [](Scene& s) { s.camera.stereo.emplace(); }},
      {"separation",
       [](Scene& s) {
         s.camera.stereo = StereoSettings{0.1, 0};
       }},
      {"convergence",
       [](Scene& s) {
         s.camera.stereo = StereoSettings{0.1, 1};
       }},
  });
}

// Names of parts are pixels of Cryptomatte's layers, and of no others.
TEST(Canonical, ChangesWithNamesThatLayersTellApart) {
  const auto with = [](Layer layer, const Change& change) {
    return text_after([&](Scene& s) {
      s.output.layers = {layer};
      change(s);
    });
  };
  const auto named = [](const std::string& name, int of_part) {
    return [=](Scene& s) {
      s.objects[0].part_names = {"one", name};
      s.objects[0].parts[0].name = of_part;
    };
  };
  const Change nothing = [](Scene&) {};
  const Change whole = [](Scene& s) { s.objects[0].whole = "all"; };
  EXPECT_NE(with(Layer::crypto_object, nothing), with(Layer::crypto_object, named("two", 0)));
  EXPECT_NE(with(Layer::crypto_object, named("two", 0)),
            with(Layer::crypto_object, named("too", 0)));
  EXPECT_NE(with(Layer::crypto_object, named("two", 0)),
            with(Layer::crypto_object, named("two", 1)));
  EXPECT_EQ(with(Layer::crypto_object, nothing), with(Layer::crypto_object, whole));
  EXPECT_NE(with(Layer::crypto_asset, nothing), with(Layer::crypto_asset, whole));
  EXPECT_EQ(with(Layer::crypto_asset, nothing), with(Layer::crypto_asset, named("two", 0)));
  EXPECT_EQ(with(Layer::z, nothing), with(Layer::z, named("two", 0)));
  EXPECT_NE(with(Layer::crypto_asset, nothing), with(Layer::crypto_material, nothing));
}

TEST(Canonical, ChangesWithExposures) {
  expect_all_different({
      {"shutter", [](Scene& s) { s.exposure.shutter = 0.1; }},
      {"shape", [](Scene& s) { s.exposure.shape = ShutterShape::triangle; }},
      {"a curve",
       [](Scene& s) {
         s.exposure.curve = {{0, 1}, {1, 0}};
       }},
      {"another curve",
       [](Scene& s) {
         s.exposure.curve = {{0, 1}, {1, 0.5}};
       }},
      {"count", [](Scene& s) { s.exposure.count = 2; }},
      {"interval", [](Scene& s) { s.exposure.interval = 0.1; }},
      {"combine", [](Scene& s) { s.exposure.combine = Combine::max; }},
  });
}

TEST(Canonical, ChangesWithTheCamerasPath) {
  const auto keyed = [](double time, const std::vector<PathKey>& keys, bool states_velocity) {
    return [=](Scene& s) { s.camera.motion = KeyedPath(time, keys, states_velocity); };
  };
  const auto accelerated = [](const Worldline& start, const std::vector<AccelerationLeg>& legs) {
    return [=](Scene& s) { s.camera.motion = AcceleratedPath(start, legs); };
  };
  const PathKey key{0, {1, 2, 3}, {}}, moved{0, {1, 2, 3.5}, {}}, later{0.5, {1, 2, 3}, {}};
  const PathKey moving{0, {1, 2, 3}, Velocity::from_beta({0, 0, 0.5})};
  const Worldline start{{1, {0, 0, 0}}, {}};
  expect_all_different({
      {"a key", keyed(0, {key}, false)},
      {"another time", keyed(1, {key}, false)},
      {"another place", keyed(0, {moved}, false)},
      {"another clock", keyed(0, {later}, false)},
      {"two keys", keyed(0, {key, later}, false)},
      {"a stated rest", keyed(0, {key}, true)},
      {"a stated velocity", keyed(0, {moving}, true)},
      {"a leg", accelerated({}, {{1, {0, 0, 1}}})},
      {"a longer leg", accelerated({}, {{2, {0, 0, 1}}})},
      {"another acceleration", accelerated({}, {{1, {0, 0, 2}}})},
      {"two legs", accelerated({}, {{1, {0, 0, 1}}, {1, {0, 0, 1}}})},
      {"another start", accelerated(start, {{1, {0, 0, 1}}})},
  });
}

TEST(Canonical, ChangesWithTheCamerasAims) {
  const auto aimed = [](const Aim& aim) { return [=](Scene& s) { s.camera.aim = aim; }; };
  const auto keyed = [](const std::vector<ViewKey>& keys) {
    return [=](Scene& s) { s.camera.view_keys = keys; };
  };
  const Worldline there{{0, {1, 0, 0}}, {}},
      moving{{0, {1, 0, 0}}, Velocity::from_beta({0, 1e-9, 0})};
  expect_all_different({
      {"track", aimed(AimTrack{there, ""})},
      {"track of what moves", aimed(AimTrack{moving, ""})},
      {"a key", keyed({{0, AimPoint{}, 1}})},
      {"a key later", keyed({{1, AimPoint{}, 1}})},
      {"a narrower key", keyed({{0, AimPoint{}, 0.5}})},
      {"a key that looks elsewhere", keyed({{0, AimPoint{{0, 1, 0}}, 1}})},
      {"a key that tracks", keyed({{0, AimTrack{there, ""}, 1}})},
      {"two keys", keyed({{0, AimPoint{}, 1}, {1, AimPoint{}, 1}})},
  });
}

TEST(Canonical, ChangesWithSettings) {
  expect_all_different({
      {"light_speed", [](Scene& s) { s.light_speed = 3e8; }},
      {"rate", [](Scene& s) { s.animation.rate = 11; }},
      {"start", [](Scene& s) { s.animation.start = 1; }},
      {"width", [](Scene& s) { s.render.width = 10; }},
      {"height", [](Scene& s) { s.render.height = 10; }},
      {"samples", [](Scene& s) { s.render.samples = 17; }},
      {"noise", [](Scene& s) { s.render.noise = 0.01; }},
      {"integrator", [](Scene& s) { s.render.integrator = IntegratorKind::path; }},
      {"depth", [](Scene& s) { s.render.depth = 3; }},
      {"beaming", [](Scene& s) { s.render.beaming = true; }},
      {"doppler", [](Scene& s) { s.render.doppler = true; }},
      {"band",
       [](Scene& s) {
         s.render.observe = WavelengthBand{500, 900};
       }},
      {"band's end",
       [](Scene& s) {
         s.render.observe = WavelengthBand{500, 901};
       }},
      {"seed", [](Scene& s) { s.render.seed = ~0ULL; }},
      {"layers", [](Scene& s) { s.output.layers.push_back(Layer::time); }},
      {"compression", [](Scene& s) { s.output.compression = Compression::dwaa; }},
      {"compression level", [](Scene& s) { s.output.compression_level = 46; }},
      {"half", [](Scene& s) { s.output.half_layers = {Layer::z}; }},
      {"float", [](Scene& s) { s.output.float_layers = {Layer::z}; }},
      {"split", [](Scene& s) { s.output.split = true; }},
      {"overscan", [](Scene& s) { s.render.overscan = 1; }},
      {"crop",
       [](Scene& s) {
         s.render.crop = PixelWindow{0, 0, 2, 2};
       }},
      {"another crop",
       [](Scene& s) {
         s.render.crop = PixelWindow{1, 0, 2, 2};
       }},
  });
}

TEST(Canonical, StaysWithWhatChangesNoPixel) {
  const Changes changes = {
      {"path", [](Scene& s) { s.output.path = "elsewhere/#.exr"; }},
      {"preview", [](Scene& s) { s.output.preview = false; }},
      {"the preview's exposure", [](Scene& s) { s.output.exposure = -3; }},
      {"the preview's view", [](Scene& s) { s.output.view = ViewTransform::filmic; }},
      {"pictures", [](Scene& s) { s.animation.pictures = 100; }},
      {"sources",
       [](Scene& s) {
         s.sources.push_back({"a.glb", "00"});
       }},  // told apart
      {"a light's name", [](Scene& s) { s.lights[0].name = "other"; }},
      {"a mesh's name", [](Scene& s) { s.meshes[0].name = "other"; }},
      {"capacity", [](Scene& s) { s.meshes[0].positions.reserve(100); }},
  };
  for (const auto& [what, change] : changes) {
    EXPECT_EQ(text_after(change), canonical_settings(canonical_base())) << what;
  }
}

TEST(Canonical, IsOneKeyALine) {
  std::istringstream lines(canonical_settings(canonical_base()));
  std::string line;
  int count = 0;
  while (std::getline(lines, line)) {
    EXPECT_NE(line.find(" = "), std::string::npos) << line;
    ++count;
  }
  EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace restframe
