#pragma once

#include <span>
#include <vector>

#include "frames/corner_normals.h"
#include "frames/embree_handles.h"
#include "scene/aligned_vector.h"
#include "scene/mesh.h"

namespace restframe {

// A mesh of the scene as Embree holds it. Coordinates are local: the mesh's own, or, where the mesh
// lies so far from its origin that floats would not do, with `offset` taken off.
struct TraversableMesh {
  const Mesh* mesh = nullptr;
  Vec3 offset{0};
  std::vector<Vec3f> moved;                  // empty where the mesh's own positions serve
  EmbreeScene scene;                         // empty until build_scene()
  Bounds bounds;                             // local
  AlignedVector<MetTriangle> met_triangles;  // their corners local

  std::span<const Vec3f> positions() const { return moved.empty() ? mesh->positions : moved; }
};

// Without a scene. `mesh` must outlive the result.
TraversableMesh traversable(const Mesh& mesh);

// Builds the mesh's own scene, for instances and for rest frames that hold nothing else.
void build_scene(const EmbreeDevice& device, TraversableMesh& mesh);

// Shares `positions` (padded) and the mesh's indices with Embree; both must outlive the geometry.
EmbreeGeometry triangle_geometry(const EmbreeDevice& device, std::span<const Vec3f> positions,
                                 const Mesh& mesh);

}  // namespace restframe
