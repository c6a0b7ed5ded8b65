#pragma once

#include <string>
#include <vector>

#include "importers/mesh_builder.h"
#include "importers/ply_values.h"

namespace restframe {

// Reads the elements that a PLY header promises into a mesh; returns the names of those elements
// and properties ("vertex.confidence") that it has no use for. Throws InputError.
std::vector<std::string> read_ply_body(PlyText& values, const PlyHeader& header,
                                       MeshBuilder& builder);
std::vector<std::string> read_ply_body(PlyBytes& values, const PlyHeader& header,
                                       MeshBuilder& builder);

}  // namespace restframe
