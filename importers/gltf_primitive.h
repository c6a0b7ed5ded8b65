#pragma once

#include <tiny_gltf.h>

#include "importers/gltf_geometry.h"
#include "importers/gltf_pose.h"
#include "importers/gltf_posed.h"

namespace restframe {

// Its modes that show triangles.
bool is_surface(const tinygltf::Primitive& primitive);

// What a primitive is to become a part of.
struct WholeMesh {
  bool shares_vertices = false;  // other primitives may use the same vertices
  // For how many there is to be memory, if that is more than the primitive has.
  std::size_t vertices = 0, triangles = 0;
};

// The whole that a mesh's surfaces make.
WholeMesh whole_of(const GltfContext& context, const tinygltf::Model& model,
                   const tinygltf::Mesh& mesh);

// Its vertices and triangles in their rest pose; no normals where it has none: glTF's shading
// is flat then.
Mesh read_primitive(const PrimitivePlace& place, const tinygltf::Model& model,
                    const tinygltf::Primitive& primitive, const PosedMesh& posed, Skins& skins,
                    const WholeMesh& whole);

}  // namespace restframe
