#pragma once

#include <tiny_gltf.h>

#include "importers/gltf_geometry.h"
#include "importers/gltf_pose.h"
#include "importers/gltf_posed.h"

namespace restframe {

// Its vertices and triangles in their rest pose; no normals where it has none: glTF's shading
// is flat then. `shares_vertices`: other primitives may use the same vertices.
Mesh read_primitive(const PrimitivePlace& place, const tinygltf::Model& model,
                    const tinygltf::Primitive& primitive, const PosedMesh& posed, Skins& skins,
                    bool shares_vertices);

}  // namespace restframe
