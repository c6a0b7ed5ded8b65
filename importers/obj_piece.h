#pragma once

#include <cstdint>
#include <vector>

#include "importers/obj_data.h"

namespace restframe {

// One object of an OBJ file on its way to meshes.
struct ObjPiece {
  Mesh mesh;                             // corners without a normal have a zero one
  std::vector<std::uint32_t> positions;  // of each vertex, the number of its `v` statement
  std::vector<ObjRun> runs;              // of `mesh`, likewise
  std::vector<ObjPolygon> polygons;
};

// Gives normals to the corners that have none: by smoothing group, or by crease angle. Vertices are
// split where their corners' normals differ. A mesh that is flat all over may get none at all.
void complete_normals(ObjPiece& piece);

}  // namespace restframe
