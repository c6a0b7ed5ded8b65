#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "importers/importers.h"
#include "importers/text_lines.h"

namespace restframe {

// An mtllib statement.
struct ObjLibrary {
  std::string names;  // of one file or several, as written
  std::string at;     // FILE:LINE:COLUMN
};

// Checks an OBJ file line by line before tinyobjloader sees it, which skips or misreads bad lines
// without a word: numbers, indices, counts. Collects what tinyobjloader does not deliver, and what
// is not used.
class ObjChecker {
 public:
  ObjChecker(TextFile& file, const ImportLimits& limits) : file_(file), limits_(limits) {}

  // The next line that is worth parsing, without comment; false at the end of the file. Throws
  // InputError at the first fault.
  bool next_line(std::string_view& line);

  const std::vector<Vec4f>& colors() const { return colors_; }  // one a vertex, or empty
  const std::vector<ObjLibrary>& libraries() const { return libraries_; }

  // After the last line: faults that only show then, and a warning for each thing that is not used.
  void finish(Warnings& warnings);

 private:
  // What indices refer to.
  struct Elements {
    const char* name;
    std::int64_t count = 0;
    std::int64_t greatest = 0;  // index that was ahead of its element
    std::size_t greatest_offset = 0;
  };
  struct Unused {
    std::uint64_t lines = 0;
    std::size_t offset = 0;
  };

  bool check(std::string_view& line);
  void check_vertex(std::string_view& line, std::string_view rest);
  void check_vector(std::string_view& line, std::string_view rest, Elements& elements, int least);
  void check_face(std::string_view& line, std::string_view rest);
  void check_corner(std::string_view corner);
  void check_index(std::string_view word, Elements& elements);
  void add_library(std::string_view line, std::string_view rest);
  void add_color(const std::vector<double>& numbers);
  void read_numbers(std::string_view& line, std::string_view rest);
  void note_unused(std::string_view keyword);
  void check_size(std::string_view line) const;

  TextFile& file_;
  const ImportLimits& limits_;
  Elements vertices_{"v"}, uvs_{"vt"}, normals_{"vn"};
  std::uint64_t corners_ = 0, triangles_ = 0;
  std::string mended_;           // the line at hand, where it must be changed
  std::vector<double> numbers_;  // of the line at hand
  std::vector<Vec4f> colors_;
  std::vector<ObjLibrary> libraries_;
  std::set<std::string, std::less<>> library_names_;
  std::map<std::string, Unused, std::less<>> unused_;
};

}  // namespace restframe
