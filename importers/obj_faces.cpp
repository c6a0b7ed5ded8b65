#include "importers/obj_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "importers/text_lines.h"
#include "scene/message.h"

namespace restframe {
namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// So far beyond any count that more digits make no difference.
constexpr std::int64_t huge = std::int64_t{1} << 58U;

}  // namespace

void ObjFaces::add(std::string_view line, std::string_view rest) {
  corners_.clear();
  const char* p = rest.data();
  const char* const end = p + rest.size();
  for (;;) {
    while (p != end && is_blank(*p)) ++p;
    if (p == end || *p == '#') break;
    p = read_corner(p, end);
  }
  const std::size_t count = corners_.size();
  if (count < 3) {
    lines_.fail(line, fmt::format("a face of {} corners, must be at least 3", count));
  }
  std::vector<Triangle>& triangles = data_.triangles;
  if (triangles.size() + count - 2 > limits_.triangles) {
    lines_.fail(line, fmt::format("more than {} triangles, the limit", limits_.triangles));
  }
  if (count > 3) {
    data_.polygons.push_back(
        {static_cast<std::uint32_t>(triangles.size()), static_cast<std::uint32_t>(count - 2)});
  }
  for (std::size_t i = 2; i < count; ++i) {
    triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
  }
  check_size(line);
}

// v, v/vt, v//vn or v/vt/vn; empty ones at the end are taken as absent. Returns its end.
const char* ObjFaces::read_corner(const char* begin, const char* end) {
  Kind* const kinds[] = {&vertices_, &uvs_, &normals_};
  IndexTable::Key key{0, 0, 0};
  const char* p = begin;
  for (std::size_t i = 0; i < 3; ++i) {
    if (p != end && !is_blank(*p) && *p != '/') {
      p = read_index(p, end, *kinds[i], key[i]);
    } else if (i == 0) {
      const std::string_view word = between(begin, std::find_if(begin, end, is_blank));
      lines_.fail(word, fmt::format("{} has no vertex index", quote(word)));
    }
    if (p == end || is_blank(*p)) {
      --key[0];
      corners_.push_back(data_.vertices.insert(key));
      return p;
    }
    ++p;  // a slash
  }
  const std::string_view word = between(begin, std::find_if(begin, end, is_blank));
  lines_.fail(word, fmt::format("{} must be v, v/vt, v//vn or v/vt/vn", quote(word)));
}

// Up to a slash, a blank or the end.
const char* ObjFaces::read_index(const char* begin, const char* end, Kind& kind,
                                 std::uint32_t& index) {
  const bool is_negative = *begin == '-';
  const char* const digits = begin + (is_negative ? 1 : 0);
  const char* p = digits;
  std::int64_t value = 0;
  for (; p != end && is_digit(*p); ++p) value = std::min(10 * value + (*p - '0'), huge);
  if (p == digits || (p != end && !is_blank(*p) && *p != '/')) {
    const auto ends = [](char c) { return is_blank(c) || c == '/'; };
    const std::string_view word = between(begin, std::find_if(begin, end, ends));
    lines_.fail(word, fmt::format("{} is not a {} index", quote(word), kind.name));
  }
  index = absolute(between(begin, p), is_negative ? -value : value, kind);
  return p;
}

std::int64_t ObjFaces::count(const Kind& kind) const {
  const std::size_t size = &kind == &vertices_ ? data_.positions.size()
                           : &kind == &uvs_    ? data_.uvs.size()
                                               : data_.normals.size();
  return static_cast<std::int64_t>(size);
}

// From 1, or counted back from the last with -1.
std::uint32_t ObjFaces::absolute(std::string_view word, std::int64_t index, Kind& kind) {
  const std::int64_t known = count(kind);
  if (index == 0) lines_.fail(word, fmt::format("{} index 0: the first is 1", kind.name));
  if (index < -known) {
    lines_.fail(word, fmt::format("{} index {}: only {} {} lines come before it", kind.name, word,
                                  known, kind.name));
  }
  if (index < 0) return static_cast<std::uint32_t>(known + index + 1);
  if (index > known && index > kind.greatest) {
    kind.greatest = index;
    kind.written = word.substr(0, 24);
    kind.place = lines_.place(word);
  }
  constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  return static_cast<std::uint32_t>(std::min(index, most));
}

void ObjFaces::check_size(std::string_view line) const {
  const std::uint64_t bytes =
      12 * (data_.positions.size() + data_.normals.size() + data_.triangles.size()) +
      8 * (data_.uvs.size() + data_.polygons.size()) + 16 * data_.colors.size() +
      24 * data_.vertices.keys().size();
  if (bytes > limits_.total_bytes) {
    lines_.fail(line, fmt::format("needs more than {} bytes, the limit", limits_.total_bytes));
  }
}

void ObjFaces::check_greatest() const {
  for (const Kind* kind : {&vertices_, &uvs_, &normals_}) {
    if (kind->greatest <= count(*kind)) continue;
    lines_.fail(kind->place, fmt::format("{} index {}: there are only {} {} lines", kind->name,
                                         kind->written, count(*kind), kind->name));
  }
}

}  // namespace restframe
