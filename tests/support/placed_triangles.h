#pragma once

// Small scenes of placed triangles, for tests of rest frames.

#include <utility>
#include <vector>

#include "scene/scene.h"

namespace restframe {

// A triangle of legs `size` whose right angle is at `corner`, facing +Z.
inline Mesh triangle(const Vec3f& corner = Vec3f(0), float size = 1) {
  Mesh mesh;
  mesh.name = "triangle";
  mesh.positions = {corner, corner + Vec3f(size, 0, 0), corner + Vec3f(0, size, 0)};
  mesh.triangles = {{0, 1, 2}};
  mesh.materials = {{0, 0}};
  pad_for_embree(mesh);
  return mesh;
}

inline Object object_of(int mesh, const Vec3& position, const Vec3& beta = Vec3(0)) {
  Object object;
  object.worldline = {{0, position}, Velocity::from_beta(beta)};
  object.parts = {{mesh, Mat4(1)}};
  object.materials = {0};
  return object;
}

inline Scene scene_of(std::vector<Mesh> meshes, std::vector<Object> objects) {
  Scene scene;
  scene.meshes = std::move(meshes);
  scene.objects = std::move(objects);
  scene.materials.emplace_back();
  return scene;
}

}  // namespace restframe
