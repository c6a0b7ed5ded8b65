#include "importers/obj_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scene/error.h"
#include "scene/mesh.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t most_libraries = 1000;
constexpr std::size_t most_keywords = 16;  // unused ones that get a warning each

// "v" lines (x y z), with w, with r g b, with r g b a.
bool fits_vertex(std::size_t numbers) {
  return numbers == 3 || numbers == 4 || numbers == 6 || numbers == 7;
}

std::string_view until(std::string_view line, std::string_view word) {
  return line.substr(0, static_cast<std::size_t>(word.data() - line.data()));
}

// Blanks slashes that no index follows: tinyobjloader would take the next corner's.
std::string without_open_ends(std::string_view line) {
  std::string result(line);
  bool open = true;
  for (auto c = result.rbegin(); c != result.rend(); ++c) {
    if (*c == '/' && open) *c = ' ';
    open = *c == ' ' || *c == '\t';
  }
  return result;
}

const char* why_unused(std::string_view keyword) {
  if (keyword == "p") return "points are not renderable, skipped";
  if (keyword == "l") return "lines are not renderable, skipped";
  return "not used";
}

}  // namespace

bool ObjChecker::next_line(std::string_view& line) {
  while (file_.next_line(line)) {
    if (check(line)) return true;
  }
  return false;
}

bool ObjChecker::check(std::string_view& line) {
  const std::string_view whole = line;
  std::string_view rest = line;
  const std::string_view keyword = take_word(rest);
  if (keyword.empty() || keyword[0] == '#') return false;
  if (keyword == "v") {
    check_vertex(line, rest);
  } else if (keyword == "f") {
    check_face(line, rest);
  } else if (keyword == "vn") {
    check_vector(line, rest, normals_, 3);
  } else if (keyword == "vt") {
    check_vector(line, rest, uvs_, 1);
  } else if (keyword == "mtllib") {
    add_library(line, rest);
    return false;
  } else if (keyword == "s") {
    return false;  // smoothing groups: normals go by the crease angle
  } else if (keyword != "g" && keyword != "o" && keyword != "usemtl") {
    note_unused(keyword);
    return false;
  }
  check_size(whole);
  return true;
}

// Cuts a comment off the line.
void ObjChecker::read_numbers(std::string_view& line, std::string_view rest) {
  numbers_.clear();
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    if (word[0] == '#') {
      line = until(line, word);
      return;
    }
    double number = 0;
    if (!read_number(word, number)) file_.fail(word, number_fault(word));
    if (std::abs(number) > largest_coordinate) {
      file_.fail(word, fmt::format("{} is beyond the limit of 1e15", quote(word)));
    }
    numbers_.push_back(number);
  }
}

void ObjChecker::check_vertex(std::string_view& line, std::string_view rest) {
  read_numbers(line, rest);
  if (!fits_vertex(numbers_.size())) {
    file_.fail(line, fmt::format("v with {} numbers: must be 3, or 4, 6 or 7 with weight or colour",
                                 numbers_.size()));
  }
  if (numbers_.size() >= 6 || !colors_.empty()) add_color(numbers_);
  ++vertices_.count;
}

void ObjChecker::add_color(const std::vector<double>& numbers) {
  colors_.resize(static_cast<std::size_t>(vertices_.count), Vec4f(1));
  Vec4f color(1);
  for (std::size_t i = 3; i < numbers.size() && numbers.size() >= 6; ++i) {
    color[static_cast<int>(i) - 3] = static_cast<float>(std::max(numbers[i], 0.0));
  }
  colors_.push_back(color);
}

void ObjChecker::check_vector(std::string_view& line, std::string_view rest, Elements& elements,
                              int least) {
  read_numbers(line, rest);
  const std::size_t count = numbers_.size();
  if (count < static_cast<std::size_t>(least) || count > 3) {
    const char* expected = least == 3 ? "3" : "1 to 3";
    file_.fail(line, fmt::format("{} with {} numbers, must be {}", elements.name, count, expected));
  }
  ++elements.count;
}

void ObjChecker::check_face(std::string_view& line, std::string_view rest) {
  std::uint64_t corners = 0;
  bool open_end = false;  // "1/" or "1//"
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    if (word[0] == '#') {
      line = until(line, word);
      break;
    }
    check_corner(word);
    open_end = open_end || word.back() == '/';
    ++corners;
  }
  if (corners < 3)
    file_.fail(line, fmt::format("a face of {} corners, must be at least 3", corners));
  corners_ += corners;
  triangles_ += corners - 2;
  if (triangles_ > limits_.triangles) {
    file_.fail(line, fmt::format("more than {} triangles, the limit", limits_.triangles));
  }
  if (open_end) line = mended_ = without_open_ends(line);
}

// v, v/vt, v//vn or v/vt/vn; empty ones at the end are taken as absent.
void ObjChecker::check_corner(std::string_view corner) {
  Elements* const kinds[] = {&vertices_, &uvs_, &normals_};
  std::string_view rest = corner;
  for (Elements* kind : kinds) {
    const std::size_t slash = rest.find('/');
    const std::string_view word = rest.substr(0, slash);
    if (!word.empty()) {
      check_index(word, *kind);
    } else if (kind == &vertices_) {
      file_.fail(corner, fmt::format("{} has no vertex index", quote(corner)));
    }
    if (slash == rest.npos) return;
    rest.remove_prefix(slash + 1);
  }
  file_.fail(corner, fmt::format("{} must be v, v/vt, v//vn or v/vt/vn", quote(corner)));
}

void ObjChecker::check_index(std::string_view word, Elements& elements) {
  std::int64_t index = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, index);
  if (error == std::errc::invalid_argument || stop != end) {
    file_.fail(word, fmt::format("{} is not a {} index", quote(word), elements.name));
  }
  if (error == std::errc::result_out_of_range) index = word[0] == '-' ? INT64_MIN : INT64_MAX;
  if (index == 0) file_.fail(word, fmt::format("{} index 0: the first is 1", elements.name));
  if (index < -elements.count) {
    file_.fail(word, fmt::format("{} index {}: only {} {} lines come before it", elements.name,
                                 word, elements.count, elements.name));
  }
  if (index > elements.count && index > elements.greatest) {
    elements.greatest = index;
    elements.greatest_offset = file_.offset(word);
  }
}

void ObjChecker::add_library(std::string_view line, std::string_view rest) {
  const std::string_view names = trimmed(rest);
  if (names.empty()) file_.fail(line, "mtllib without a file name");
  if (!library_names_.emplace(names).second) return;
  if (libraries_.size() >= most_libraries) {
    file_.fail(line, fmt::format("more than {} mtllib statements, the limit", most_libraries));
  }
  libraries_.push_back({std::string(names), file_.position(names)});
}

void ObjChecker::note_unused(std::string_view keyword) {
  const auto known = unused_.find(keyword);
  if (known != unused_.end()) {
    ++known->second.lines;
    return;
  }
  const bool full = unused_.size() >= most_keywords;
  Unused& unused = unused_[full ? std::string() : std::string(keyword)];
  if (unused.lines++ == 0) unused.offset = file_.offset(keyword);
}

void ObjChecker::check_size(std::string_view line) const {
  const auto count = [](const Elements& elements) {
    return static_cast<std::uint64_t>(elements.count);
  };
  const std::uint64_t bytes = 12 * (count(vertices_) + count(normals_) + corners_ + triangles_) +
                              8 * count(uvs_) + 16 * colors_.size();
  if (bytes > limits_.total_bytes) {
    file_.fail(line, fmt::format("needs more than {} bytes, the limit", limits_.total_bytes));
  }
}

void ObjChecker::finish(Warnings& warnings) {
  for (const Elements* elements : {&vertices_, &uvs_, &normals_}) {
    if (elements->greatest <= elements->count) continue;
    file_.fail(elements->greatest_offset,
               fmt::format("{} index {}: there are only {} {} lines", elements->name,
                           elements->greatest, elements->count, elements->name));
  }
  for (const auto& [keyword, unused] : unused_) {
    const std::string what = keyword.empty() ? "other" : quote(keyword);
    warnings.push_back(fmt::format("{}: {} {} lines: {}", file_.position(unused.offset),
                                   unused.lines, what, why_unused(keyword)));
  }
  if (triangles_ == 0) throw InputError(file_.path().string() + ": nothing to render: no faces");
  const bool bytes = std::any_of(colors_.begin(), colors_.end(), [](const Vec4f& c) {
    return std::max({c.r, c.g, c.b, c.a}) > 1;
  });
  if (bytes) {
    for (Vec4f& color : colors_) {
      const float alpha = color.a > 1 ? color.a / 255 : color.a;  // 1 where none is given
      color = glm::min(Vec4f(Vec3f(color) / 255.0F, alpha), Vec4f(1));
    }
    warnings.push_back(file_.path().string() + ": vertex colours beyond 1 are taken as 0 to 255");
  }
}

}  // namespace restframe
