#include "importers/complete_normals.h"

#include <cmath>

#include "importers/importers.h"

namespace restframe {
namespace {

// Zero if `v` has no direction.
Vec3f unit(const Vec3f& v) {
  const double length = glm::length(Vec3(v));
  return length > 0 && std::isfinite(length) ? Vec3f(Vec3(v) / length) : Vec3f(0);
}

}  // namespace

std::size_t complete_normals(Mesh& mesh) {
  if (mesh.normals.empty()) {
    add_normals(mesh);
    return 0;
  }
  std::size_t missing = 0;
  for (Vec3f& normal : mesh.normals) {
    normal = unit(normal);
    if (normal == Vec3f(0)) ++missing;
  }
  if (missing == 0) return 0;
  std::vector<Vec3f> given;
  given.swap(mesh.normals);
  const std::vector<Triangle> before = mesh.triangles;
  add_normals(mesh);
  for (std::size_t t = 0; t < before.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f& normal = given[before[t][i]];
      if (normal != Vec3f(0)) mesh.normals[mesh.triangles[t][i]] = normal;
    }
  }
  return missing;
}

}  // namespace restframe
