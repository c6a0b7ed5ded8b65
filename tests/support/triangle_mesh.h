#pragma once

#include <utility>
#include <vector>

#include "scene/mesh.h"

namespace restframe {

// Of one material.
inline Mesh mesh_of(std::vector<Vec3f> positions, std::vector<Triangle> triangles) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  mesh.materials = {{0, 0}};
  return mesh;
}

}  // namespace restframe
