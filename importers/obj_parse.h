#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "importers/importers.h"
#include "importers/obj_check.h"

namespace restframe {

// Indices into ObjData's arrays; -1: none.
struct ObjCorner {
  int position, uv, normal;
};

// From face `first_face` on, up to the next run's, faces are of this group and material.
struct ObjRun {
  std::uint32_t first_face;
  int group;
  int material;  // index into ObjData::materials; -1: none was named
};

// What `o` and `g` statements name.
struct ObjGroup {
  std::string object, group;
  int object_index;  // the same for groups of one object
};

// An OBJ file as it is written: polygons, every kind of index for itself. At least one face.
struct ObjData {
  std::vector<Vec3f> positions, normals;
  std::vector<Vec2f> uvs;     // v upwards
  std::vector<Vec4f> colors;  // empty, or one a position
  std::vector<ObjCorner> corners;
  std::vector<std::uint32_t> face_ends;  // index past each face's last corner
  std::vector<ObjRun> runs;
  std::vector<ObjGroup> groups;
  int objects = 0;
  std::vector<std::string> materials;  // names in the order in which they are used
  std::vector<ObjLibrary> libraries;
};

// Throws InputError on any fault (hazards of OBJ: see ObjChecker).
ObjData parse_obj(const Path& path, const ImportLimits& limits, Warnings& warnings);

}  // namespace restframe
