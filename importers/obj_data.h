#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "importers/index_table.h"
#include "physics/vectors.h"
#include "scene/mesh.h"

namespace restframe {

// How normals that a file does not give are made; any other value is the number of a smoothing
// group, in which normals are shared.
inline constexpr int smooth_by_crease = -1;  // the file has no `s` statement
inline constexpr int smooth_never = 0;       // `s off`

// From triangle `first_triangle` on, up to the next run's, triangles are of this group, material
// and smoothing group.
struct ObjRun {
  std::uint32_t first_triangle;
  int group;
  int material;  // index into ObjData::materials; -1: none was named
  int smoothing;
};

inline std::uint32_t end_of_run(const std::vector<ObjRun>& runs, std::size_t run,
                                std::size_t triangles) {
  return run + 1 < runs.size() ? runs[run + 1].first_triangle
                               : static_cast<std::uint32_t>(triangles);
}

// A face of more than three corners: its triangles are consecutive.
struct ObjPolygon {
  std::uint32_t first_triangle, triangles;
};

// What `o` and `g` statements name.
struct ObjGroup {
  std::string object, group;
  int object_index;             // the same for groups of one object
  int object_line, group_line;  // of the statement; 0: there is none
};

// An mtllib statement.
struct ObjLibrary {
  std::string names;  // of one file or several, as written
  std::string at;     // FILE:LINE:COLUMN
};

// An OBJ file as it is written. At least one triangle.
struct ObjData {
  std::vector<Vec3f> positions, normals;
  std::vector<Vec2f> uvs;     // v upwards
  std::vector<Vec4f> colors;  // linear; empty, or one a position
  IndexTable vertices;        // position, then UV and normal, which count from 1 (0: none is given)
  std::vector<Triangle> triangles;   // of `vertices`; polygons are fans around their first corner
  std::vector<ObjPolygon> polygons;  // in the order of their triangles
  std::vector<ObjRun> runs;
  std::vector<ObjGroup> groups;
  int objects = 0;
  std::vector<std::string> materials;  // names in the order in which they are used
  std::vector<ObjLibrary> libraries;
};

}  // namespace restframe
