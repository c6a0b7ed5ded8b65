#pragma once

#include <array>
#include <string>
#include <vector>

#include "importers/importers.h"
#include "importers/index_table.h"

namespace restframe {

// A mesh of facets that come with corners of their own: equal corners become one vertex, so that
// normals can be smooth.
class SolidBuilder {
 public:
  bool empty() const { return triangles_.empty(); }
  void add(const std::array<Vec3f, 3>& corners);
  Mesh take(const std::string& name);

 private:
  IndexTable vertices_;
  std::vector<Triangle> triangles_;
};

// What both kinds of STL say of a corner out of range; empty if it is in range.
std::string corner_fault(const Vec3f& corner);

// The triangles of a binary file.
Mesh read_stl_binary(const Path& path, const ImportLimits& limits, Warnings& warnings);

// The solids of a text file, those without facets left out.
std::vector<Mesh> read_stl_text(const Path& path, const ImportLimits& limits, Warnings& warnings);

}  // namespace restframe
