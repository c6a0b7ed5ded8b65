#pragma once

#include <string_view>

#include "importers/importers.h"
#include "importers/line_reader.h"
#include "importers/obj_data.h"

namespace restframe {

// Reads v, vt and vn statements. Each function gets a whole line and what comes after its keyword.
class ObjVectors {
 public:
  ObjVectors(const LineReader& lines, ObjData& data) : lines_(lines), data_(data) {}

  void add_vertex(std::string_view line, std::string_view rest);
  void add_uv(std::string_view line, std::string_view rest);
  void add_normal(std::string_view line, std::string_view rest);

  // After the last line: one colour a vertex, linear.
  void finish_colors(Warnings& warnings);

 private:
  static constexpr std::size_t most = 7;

  std::size_t read_numbers(std::string_view rest);
  float read_slowly(std::string_view word) const;

  const LineReader& lines_;
  ObjData& data_;
  float numbers_[most] = {};
};

}  // namespace restframe
