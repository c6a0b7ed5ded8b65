#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "importers/importers.h"
#include "importers/line_reader.h"
#include "importers/obj_data.h"

namespace restframe {

// Reads f statements.
class ObjFaces {
 public:
  ObjFaces(const LineReader& lines, const ImportLimits& limits, ObjData& data)
      : lines_(lines), limits_(limits), data_(data) {}

  // A whole line, and what comes after its keyword.
  void add(std::string_view line, std::string_view rest);

  // After the last line: indices may have been ahead of what they refer to.
  void check_greatest() const;

 private:
  // Whatever an index may refer to.
  struct Kind {
    const char* name;
    std::int64_t greatest = 0;  // index that was ahead of its statement
    std::string written{};      // as it is in the file, at `place`
    LineReader::Place place{};
  };

  std::int64_t count(const Kind& kind) const;
  const char* read_corner(const char* begin, const char* end);
  const char* read_index(const char* begin, const char* end, Kind& kind, std::uint32_t& index);
  std::uint32_t absolute(std::string_view word, std::int64_t index, Kind& kind);
  void check_size(std::string_view line) const;

  const LineReader& lines_;
  const ImportLimits& limits_;
  ObjData& data_;
  Kind vertices_{"v"}, uvs_{"vt"}, normals_{"vn"};
  std::vector<std::uint32_t> corners_;  // of one face, as numbers of ObjData::vertices
};

}  // namespace restframe
