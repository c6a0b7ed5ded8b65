#pragma once

#include <cstdint>
#include <vector>

#include "importers/obj_data.h"
#include "importers/vertex_picker.h"

namespace restframe {

// One object of an OBJ file on its way to meshes.
struct ObjPiece {
  Mesh mesh;                             // corners without a normal have a zero one
  std::vector<std::uint32_t> positions;  // of each vertex, the number of its `v` statement
  std::vector<ObjRun> runs;              // of `mesh`, likewise
  std::vector<ObjPolygon> polygons;
};

// The object of some runs, by their numbers. `picker` is one for data.vertices.
ObjPiece take_object(const ObjData& data, const std::vector<std::size_t>& runs,
                     VertexPicker& picker);

// All of a file that is one object: no triangle is copied, and `data` keeps only names.
ObjPiece take_all(ObjData& data);

// Gives normals to the corners that have none: by smoothing group, or by crease angle. Vertices are
// split where their corners' normals differ. A mesh that is flat all over may get none at all.
void complete_normals(ObjPiece& piece);

}  // namespace restframe
