#pragma once

#include <cstdint>
#include <vector>

#include "scene/material.h"
#include "scene/mesh.h"

namespace restframe {

// What tangents are worked out from: positions, normals and texture coordinates. One point a
// vertex; of a mesh without normals one a corner, since each triangle has its own there.
class TangentPoints {
 public:
  TangentPoints(const Mesh& mesh, int uv_set, const UvTransform& transform);

  std::size_t count() const { return flat_ ? 3 * mesh_.triangles.size() : mesh_.positions.size(); }
  std::size_t corner_count() const { return 3 * mesh_.triangles.size(); }
  std::uint32_t point_of(std::size_t corner) const {
    return flat_ ? static_cast<std::uint32_t>(corner) : mesh_.triangles[corner / 3][corner % 3];
  }

  const Vec3f& position(std::uint32_t point) const { return mesh_.positions[vertex(point)]; }
  const Vec3f& normal(std::uint32_t point) const {
    return flat_ ? facets_[point / 3] : mesh_.normals[point];
  }
  Vec2f uv(std::uint32_t point) const { return transform_(uvs_[vertex(point)]); }

 private:
  std::uint32_t vertex(std::uint32_t point) const {
    return flat_ ? mesh_.triangles[point / 3][point % 3] : point;
  }

  const Mesh& mesh_;
  const std::vector<Vec2f>& uvs_;
  UvTransform transform_;
  bool flat_;
  std::vector<Vec3f> facets_;  // of the triangles, where the mesh has no normals
};

// Gives all points of the same position, normal and texture coordinates the number of the first.
std::vector<std::uint32_t> welded(const TangentPoints& points);

}  // namespace restframe
