#pragma once

// What validate() says of a good scene that was spoilt in one way.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace restframe {

using Spoil = std::function<void(Scene&)>;

// A triangle of one textured material.
inline Scene good_scene() {
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
inline std::vector<std::string> faults(const Spoil& spoil) {
  Scene scene = good_scene();
  spoil(scene);
  return validate(scene);
}

// The one fault holds these words.
inline void expect_fault(const Spoil& spoil, const char* words) {
  EXPECT_THAT(faults(spoil), testing::ElementsAre(testing::HasSubstr(words)));
}

}  // namespace restframe
