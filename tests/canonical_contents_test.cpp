// The canonical text of a scene changes with everything in it that changes pixels: objects, meshes,
// materials, lights and functions of time.

#include <gtest/gtest.h>

#include <cmath>

#include "scene/material_properties.h"
#include "support/canonical_changes.h"

namespace restframe {
namespace {

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

Changes changes_of_surfaces() {
  return {
      {"base_color", [](Scene& s) { s.materials[1].base_color.value.y = 0.5F; }},
      {"base_color's function", [](Scene& s) { s.materials[1].base_color.function = 0; }},
      {"opacity", [](Scene& s) { s.materials[0].opacity.value = 0.5F; }},
      {"opacity's function", [](Scene& s) { s.materials[0].opacity.function = 1; }},
      {"metallic", [](Scene& s) { s.materials[0].metallic.value = 0.5F; }},
      {"roughness", [](Scene& s) { s.materials[0].roughness.value = 0.5F; }},
      {"ior", [](Scene& s) { s.materials[0].ior.value = 1.25F; }},
      {"ior's function", [](Scene& s) { s.materials[0].ior.function = 0; }},
      {"transmission", [](Scene& s) { s.materials[0].transmission.value = 0.5F; }},
      {"attenuation_color", [](Scene& s) { s.materials[0].attenuation_color.value.y = 0.5F; }},
      {"attenuation_distance", [](Scene& s) { s.materials[0].attenuation_distance.value = 0.5F; }},
      {"clearcoat's normals", [](Scene& s) { s.materials[0].clearcoat_normal_scale = 0.5F; }},
      {"alpha mode", [](Scene& s) { s.materials[0].alpha_mode = AlphaMode::blend; }},
      {"alpha cutoff", [](Scene& s) { s.materials[0].alpha_cutoff = 0.25F; }},
      {"double sided", [](Scene& s) { s.materials[0].double_sided = true; }},
      {"unlit", [](Scene& s) { s.materials[0].unlit = true; }},
      {"group", [](Scene& s) { s.materials[0].group = "neon"; }},
      {"thin_walled", [](Scene& s) { s.materials[0].thin_walled = true; }},
  };
}

Changes changes_of_emission() {
  return {
      {"emission", [](Scene& s) { s.materials[0].emission.value.x = 0.5F; }},
      {"emission_strength", [](Scene& s) { s.materials[0].emission_strength.value = 0.5F; }},
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
  };
}

Changes changes_of_textures() {
  return {
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
      {"a texture", [](Scene& s) { s.textures.emplace_back(); }},
      {"a texture's image", [](Scene& s) { s.textures.emplace_back().image = 1; }},
      {"a texture of data", [](Scene& s) { s.textures.emplace_back().srgb = false; }},
      {"wrapping", [](Scene& s) { s.textures.emplace_back().wrap_u = Wrap::clamp; }},
      {"wrapping of v", [](Scene& s) { s.textures.emplace_back().wrap_v = Wrap::clamp; }},
      {"filter", [](Scene& s) { s.textures.emplace_back().filter = TextureFilter::nearest; }},
      {"mip filter", [](Scene& s) { s.textures.emplace_back().mip_filter = MipFilter::none; }},
      {"emission's texture", [](Scene& s) { s.materials[0].emission_texture.texture = 0; }},
  };
}

TEST(Canonical, ChangesWithMaterials) {
  Changes changes = changes_of_surfaces();
  changes.merge(changes_of_emission());
  changes.merge(changes_of_textures());
  EXPECT_EQ(changes.size(), 36U);
  expect_all_different(changes);
}

TEST(Canonical, ChangesWithEveryProperty) {
  Changes changes;
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

Changes changes_of_where_lights_shine() {
  return {
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
  };
}

Changes changes_of_their_light() {
  return {
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
  };
}

Changes changes_of_sky_maps() {
  return {
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
  };
}

TEST(Canonical, ChangesWithLights) {
  Changes changes = changes_of_where_lights_shine();
  changes.merge(changes_of_their_light());
  changes.merge(changes_of_sky_maps());
  EXPECT_EQ(changes.size(), 29U);
  expect_all_different(changes);
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

}  // namespace
}  // namespace restframe
