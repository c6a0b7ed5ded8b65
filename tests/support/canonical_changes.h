#pragma once

// Changes of a scene, and what they make of its canonical text.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "scene/canonical.h"

namespace restframe {

using Change = std::function<void(Scene&)>;
using Changes = std::map<std::string, Change>;  // by what they change

inline Scene canonical_base() {
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

inline std::string text_after(const Change& change) {
  Scene scene = canonical_base();
  change(scene);
  return canonical_settings(scene);
}

// Each text differs from the base's and from all others'.
inline void expect_all_different(const Changes& changes) {
  std::set<std::string> texts = {canonical_settings(canonical_base())};
  for (const auto& [what, change] : changes) {
    EXPECT_TRUE(texts.insert(text_after(change)).second) << what;
  }
}

}  // namespace restframe
