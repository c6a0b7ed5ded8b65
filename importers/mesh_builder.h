#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "importers/importers.h"
#include "importers/index_table.h"
#include "importers/triangulate.h"
#include "scene/mesh.h"

namespace restframe {

// What a face says beyond its corners; for those formats that let it.
struct FaceAttributes {
  std::optional<Vec4f> color;  // in the file's own units, as the vertices'
  std::vector<Vec2f> uvs;      // none, or one a corner
};

// A mesh whose faces are polygons over shared vertices, as PLY and OFF files have it: made of
// triangles, checked, none lost.
class MeshBuilder {
 public:
  // `file` begins errors and warnings.
  MeshBuilder(std::string file, const ImportLimits& limits)
      : file_(std::move(file)), limits_(limits) {}

  // All vertices with their attributes; filled before the first face. Positions that are not finite
  // or too far off stay as they are: no face may use them. Normals may have any length.
  Mesh mesh;

  // Whether numbers of the colours may mean 0 to 255, should any be beyond 1.
  bool rgb_may_be_bytes = false, alpha_may_be_bytes = false;

  // Throws InputError: "FILE: reason".
  [[noreturn]] void fail(const std::string& reason) const;

  // Makes room for vertices of so many bytes each. Throws InputError beyond the limits.
  void expect_vertices(std::uint64_t count, std::size_t bytes_each);

  // Why no corner of a face can have this index; empty if one can.
  std::string index_fault(double index) const;

  // Appends the triangles of a polygon, whose indices must be without fault; those of fewer than
  // three corners are counted and left out. Throws InputError beyond the limits.
  void add_face(const std::vector<std::uint32_t>& corners, const FaceAttributes& attributes = {});

  // Done: without the vertices that no face uses; colours linear. Throws InputError if there is
  // nothing to render.
  Mesh take(Warnings& warnings);

 private:
  // Of the corners of triangles: 1 + an index into the tables below, 0 where the face says nothing.
  // Empty until some face says something.
  using CornerIndices = std::vector<std::uint32_t>;

  void add_triangle(const std::vector<std::uint32_t>& corners, const Triangle& piece,
                    const FaceAttributes& attributes);
  std::uint32_t color_index(const Vec4f& color);
  void split_vertices();
  void warn(Warnings& warnings) const;

  std::string file_;
  ImportLimits limits_;
  PolygonCutter cutter_;
  std::vector<Vec3> polygon_;
  std::vector<Triangle> pieces_;
  CornerIndices corner_colors_, corner_uvs_;
  std::vector<Vec4f> face_colors_;
  IndexTable rgb_table_, color_table_, uv_table_;
  std::uint64_t faces_ = 0, small_faces_ = 0;
};

}  // namespace restframe
