// The canonical text of a scene: it changes with everything that changes pixels, and with nothing else.

#include "scene/canonical.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "scene/material_properties.h"

namespace restframe {
namespace {

using Change = std::function<void(Scene&)>;

Scene base() {
  Scene scene;
  Mesh mesh;
  mesh.name = "triangle";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.materials = {{0, 0}};
  scene.meshes = {mesh, mesh};
  scene.materials.resize(2);
  Object object;
  object.name = "thing";
  object.parts = {{0, Mat4(1)}};
  object.materials = {0};
  scene.objects = {object};
  scene.lights.resize(2);
  scene.lights[0].sweep = Sweep();
  scene.lights[1].kind = LightKind::environment;
  scene.lights[1].sky_map = 0;
  scene.sky_maps = {{"sky", 2, 1, {Vec3f(1), Vec3f(2)}}};
  scene.functions.push_back(IntervalFunction{1.0, {{0, 0.5, Vec3f(1)}}});
  scene.functions.push_back(KeyFunction{{}, {{0, Vec3f(0)}, {1, Vec3f(1)}}});
  scene.functions.push_back(FormulaFunction{{"t"}, Vec3f(0), Vec3f(1)});
  return scene;
}

std::string text_after(const Change& change) {
  Scene scene = base();
  change(scene);
  return canonical_settings(scene);
}

// Each text differs from the base's and from all others'.
void expect_all_different(const std::map<std::string, Change>& changes) {
  std::set<std::string> texts = {canonical_settings(base())};
  for (const auto& [what, change] : changes) {
    EXPECT_TRUE(texts.insert(text_after(change)).second) << what;
  }
}

TEST(Canonical, SameScenesHaveTheSameText) {
  EXPECT_EQ(canonical_settings(base()), canonical_settings(base()));
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

TEST(Canonical, ChangesWithObjects) {
  expect_all_different({
      {"position", [](Scene& s) { s.objects[0].worldline.reference.x.x = 1; }},
      {"time", [](Scene& s) { s.objects[0].worldline.reference.t = 1; }},
      {"velocity",
       [](Scene& s) {
         s.objects[0].worldline.velocity = Velocity::from_beta({0, 0, 0.5});
       }},
      {"the next velocity",
       [](Scene& s) {
         s.objects[0].worldline.velocity = Velocity::from_beta({0, 0, std::nextafter(0.5, 1)});
       }},
      {"clock", [](Scene& s) { s.objects[0].clock = 1; }},
      {"frame clock", [](Scene& s) { s.objects[0].frame_clock = true; }},
      {"placement", [](Scene& s) { s.objects[0].parts[0].object_from_mesh[3].x = 1; }},
      {"another mesh", [](Scene& s) { s.objects[0].parts[0].mesh = 1; }},
      {"a part more",
       [](Scene& s) {
         s.objects[0].parts.push_back({0, Mat4(1)});
       }},
      {"another material", [](Scene& s) { s.objects[0].materials[0] = 1; }},
      {"name", [](Scene& s) { s.objects[0].name = "other"; }},  // headers hold it
      {"an object more", [](Scene& s) { s.objects.push_back(s.objects[0]); }},
  });
}

TEST(Canonical, ChangesWithMeshes) {
  expect_all_different({
      {"vertex", [](Scene& s) { s.meshes[1].positions[2].y = 1.0000001F; }},
      {"triangle",
       [](Scene& s) {
         s.meshes[0].triangles[0] = {0, 2, 1};
       }},
      {"normals",
       [](Scene& s) {
         s.meshes[0].normals.assign(3, {0, 0, 1});
       }},
      {"uvs",
       [](Scene& s) {
         s.meshes[0].uvs[0].assign(3, {0, 1});
       }},
      {"a third set of uvs",
       [](Scene& s) {
         s.meshes[0].uvs.resize(3, {{0, 1}, {0, 1}, {0, 1}});
       }},
      {"tangents", [](Scene& s) { s.meshes[0].tangents.assign(3, Vec4f(1)); }},
      {"colours", [](Scene& s) { s.meshes[0].colors.assign(3, Vec4f(1)); }},
      {"slot", [](Scene& s) { s.meshes[0].materials[0].slot = 1; }},
      {"a mesh more", [](Scene& s) { s.meshes.emplace_back(); }},
  });
}

TEST(Canonical, ChangesWithMaterials) {
  expect_all_different({
      {"base_color", [](Scene& s) { s.materials[1].base_color.value.y = 0.5F; }},
      {"base_color's function", [](Scene& s) { s.materials[1].base_color.function = 0; }},
      {"opacity", [](Scene& s) { s.materials[0].opacity.value = 0.5F; }},
      {"opacity's function", [](Scene& s) { s.materials[0].opacity.function = 1; }},
      {"metallic", [](Scene& s) { s.materials[0].metallic.value = 0.5F; }},
      {"roughness", [](Scene& s) { s.materials[0].roughness.value = 0.5F; }},
      {"emission", [](Scene& s) { s.materials[0].emission.value.x = 0.5F; }},
      {"emission_strength", [](Scene& s) { s.materials[0].emission_strength.value = 0.5F; }},
      {"ior", [](Scene& s) { s.materials[0].ior.value = 1.25F; }},
      {"ior's function", [](Scene& s) { s.materials[0].ior.function = 0; }},
      {"transmission", [](Scene& s) { s.materials[0].transmission.value = 0.5F; }},
      {"attenuation_color", [](Scene& s) { s.materials[0].attenuation_color.value.y = 0.5F; }},
      {"attenuation_distance", [](Scene& s) { s.materials[0].attenuation_distance.value = 0.5F; }},
      {"base colour's texture", [](Scene& s) { s.materials[0].base_color_texture.texture = 0; }},
      {"its UV set",
       [](Scene& s) {
         s.materials[0].base_color_texture = {0, 1, {}};
       }},
      {"its transform",
       [](Scene& s) {
         s.materials[0].base_color_texture = {0, 0, {{0, 1}, {1, 0}, {0, 0}}};
       }},
      {"its offset",
       [](Scene& s) {
         s.materials[0].base_color_texture = {0, 0, {{1, 0}, {0, 1}, {0, 0.5F}}};
       }},
      {"clearcoat's normals", [](Scene& s) { s.materials[0].clearcoat_normal_scale = 0.5F; }},
      {"a texture", [](Scene& s) { s.textures.emplace_back(); }},
      {"a texture's image", [](Scene& s) { s.textures.emplace_back().image = 1; }},
      {"a texture of data", [](Scene& s) { s.textures.emplace_back().srgb = false; }},
      {"wrapping", [](Scene& s) { s.textures.emplace_back().wrap_u = Wrap::clamp; }},
      {"wrapping of v", [](Scene& s) { s.textures.emplace_back().wrap_v = Wrap::clamp; }},
      {"filter", [](Scene& s) { s.textures.emplace_back().filter = TextureFilter::nearest; }},
      {"mip filter", [](Scene& s) { s.textures.emplace_back().mip_filter = MipFilter::none; }},
      {"emission's texture", [](Scene& s) { s.materials[0].emission_texture.texture = 0; }},
      {"alpha mode", [](Scene& s) { s.materials[0].alpha_mode = AlphaMode::blend; }},
      {"alpha cutoff", [](Scene& s) { s.materials[0].alpha_cutoff = 0.25F; }},
      {"double sided", [](Scene& s) { s.materials[0].double_sided = true; }},
      {"unlit", [](Scene& s) { s.materials[0].unlit = true; }},
      {"group", [](Scene& s) { s.materials[0].group = "neon"; }},
      {"thin_walled", [](Scene& s) { s.materials[0].thin_walled = true; }},
      {"temperature", [](Scene& s) { s.materials[0].emission_temperature.value = 3000; }},
      {"temperature's function",
       [](Scene& s) { s.materials[0].emission_temperature.function = 0; }},
      {"spectrum",
       [](Scene& s) {
         s.materials[0].emission_spectrum.points = {{400, 1}, {500, 1}};
       }},
      {"lines",
       [](Scene& s) {
         s.materials[0].emission_spectrum.lines = {{400, 1, 1}};
       }},
  });
}

TEST(Canonical, ChangesWithEveryProperty) {
  std::map<std::string, Change> changes;
  for (const NumberProperty& p : number_properties) {
    changes[p.name] = [&](Scene& s) { (s.materials[0].*p.member).value = 0.25F; };
    changes[std::string(p.name) + "'s function"] = [&](Scene& s) {
      (s.materials[0].*p.member).function = 0;
    };
  }
  for (const ColorProperty& p : color_properties) {
    changes[p.name] = [&](Scene& s) { (s.materials[0].*p.member).value.z = 0.25F; };
    changes[std::string(p.name) + "'s function"] = [&](Scene& s) {
      (s.materials[0].*p.member).function = 1;
    };
  }
  for (const TextureProperty& p : texture_properties) {
    changes[p.name] = [&](Scene& s) { (s.materials[0].*p.member).texture = 0; };
  }
  EXPECT_EQ(changes.size(), 46U);
  expect_all_different(changes);
}

TEST(Canonical, ChangesWithLights) {
  expect_all_different({
      {"kind", [](Scene& s) { s.lights[1].kind = LightKind::sun; }},
      {"position", [](Scene& s) { s.lights[0].worldline.reference.x.z = 1; }},
      {"time", [](Scene& s) { s.lights[0].worldline.reference.t = 1; }},
      {"velocity",
       [](Scene& s) {
         s.lights[0].worldline.velocity = Velocity::from_beta({0, 0, 0.5});
       }},
      {"clock", [](Scene& s) { s.lights[0].clock = 1; }},
      {"frame clock", [](Scene& s) { s.lights[0].frame_clock = true; }},
      {"direction",
       [](Scene& s) {
         s.lights[1].direction = {0, 1, 0};
       }},
      {"sweep", [](Scene& s) { s.lights[1].sweep = Sweep(); }},
      {"sweep's axis",
       [](Scene& s) {
         s.lights[0].sweep->axis = {0, 0, 1};
       }},
      {"sweep's period", [](Scene& s) { s.lights[0].sweep->period = 2; }},
      {"inner cone", [](Scene& s) { s.lights[0].inner_cone = 0.1; }},
      {"outer cone", [](Scene& s) { s.lights[0].outer_cone = 0.9; }},
      {"color", [](Scene& s) { s.lights[0].color.value.y = 0.5F; }},
      {"color's function", [](Scene& s) { s.lights[0].color.function = 1; }},
      {"intensity", [](Scene& s) { s.lights[1].intensity.value = 2; }},
      {"intensity's function", [](Scene& s) { s.lights[1].intensity.function = 0; }},
      {"group", [](Scene& s) { s.lights[1].group = "key"; }},
      {"temperature", [](Scene& s) { s.lights[1].temperature.value = 3000; }},
      {"temperature's function", [](Scene& s) { s.lights[1].temperature.function = 0; }},
      {"spectrum",
       [](Scene& s) {
         s.lights[1].spectrum.points = {{400, 1}, {500, 1}};
       }},
      {"spectrum's values",
       [](Scene& s) {
         s.lights[1].spectrum.points = {{400, 1}, {500, 2}};
       }},
      {"lines",
       [](Scene& s) {
         s.lights[1].spectrum.lines = {{400, 1, 1}};
       }},
      {"lines' widths",
       [](Scene& s) {
         s.lights[1].spectrum.lines = {{400, 1, 2}};
       }},
      {"a light more", [](Scene& s) { s.lights.emplace_back(); }},
      {"no map", [](Scene& s) { s.lights[1].sky_map = -1; }},
      {"another map", [](Scene& s) { s.lights[1].sky_map = 1; }},
      {"a turned map",
       [](Scene& s) {
         s.lights[1].rest_from_map = Mat3({0, 1, 0}, {-1, 0, 0}, {0, 0, 1});
       }},
      {"a map's pixel", [](Scene& s) { s.sky_maps[0].pixels[1].z = 3; }},
      {"a map's size",
       [](Scene& s) {
         s.sky_maps[0].width = 1;
         s.sky_maps[0].height = 2;
       }},
  });
}

TEST(Canonical, ChangesWithTemporalFunctions) {
  const auto intervals = [](Scene& s) -> IntervalFunction& {
    return std::get<IntervalFunction>(s.functions[0]);
  };
  const auto keys = [](Scene& s) -> KeyFunction& { return std::get<KeyFunction>(s.functions[1]); };
  const auto formula = [](Scene& s) -> FormulaFunction& {
    return std::get<FormulaFunction>(s.functions[2]);
  };
  expect_all_different({
      {"period", [&](Scene& s) { intervals(s).period = 2; }},
      {"no period", [&](Scene& s) { intervals(s).period.reset(); }},
      {"begin", [&](Scene& s) { intervals(s).intervals[0].begin = 1e-9; }},
      {"end", [&](Scene& s) { intervals(s).intervals[0].end = 0.6; }},
      {"value", [&](Scene& s) { intervals(s).intervals[0].value.z = 0; }},
      {"key's time", [&](Scene& s) { keys(s).keys[1].time = 2; }},
      {"key's value", [&](Scene& s) { keys(s).keys[1].value.x = 2; }},
      {"keys' period", [&](Scene& s) { keys(s).period = 2; }},
      {"formula", [&](Scene& s) { formula(s).formulas[0] = "t+1"; }},
      {"from", [&](Scene& s) { formula(s).from = Vec3f(2); }},
      {"to", [&](Scene& s) { formula(s).to.reset(); }},
  });
}

TEST(Canonical, StaysWithWhatChangesNoPixel) {
  const std::map<std::string, Change> changes = {
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
    EXPECT_EQ(text_after(change), canonical_settings(base())) << what;
  }
}

TEST(Canonical, IsOneKeyALine) {
  std::istringstream lines(canonical_settings(base()));
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
