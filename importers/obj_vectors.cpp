#include "importers/obj_vectors.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "importers/text_lines.h"
#include "scene/color.h"
#include "scene/message.h"

namespace restframe {

// How many there are; those past the seventh are only checked. A comment ends them.
std::size_t ObjVectors::read_numbers(std::string_view rest) {
  std::size_t count = 0;
  const char* p = rest.data();
  const char* const end = p + rest.size();
  for (;; ++count) {
    while (p != end && is_blank(*p)) ++p;
    if (p == end || *p == '#') return count;
    float value = 0;
    const auto [stop, error] = std::from_chars(p, end, value);
    const bool whole = error == std::errc() && (stop == end || is_blank(*stop)) &&
                       std::abs(value) <= static_cast<float>(largest_coordinate);
    const char* const word = p;
    p = whole ? stop : std::find_if(p, end, is_blank);
    if (!whole) value = read_slowly({word, static_cast<std::size_t>(p - word)});
    if (count < most) numbers_[count] = value;
  }
}

// What from_chars does not take: a plus sign, numbers too small for a float, and faults.
float ObjVectors::read_slowly(std::string_view word) const {
  double number = 0;
  if (!read_number(word, number)) lines_.fail(word, number_fault(word));
  if (std::abs(number) > largest_coordinate) {
    lines_.fail(word, fmt::format("{} is beyond the limit of 1e15", quote(word)));
  }
  return static_cast<float>(number);
}

// x y z, with a weight (of curves, not used), with r g b, or with r g b a.
void ObjVectors::add_vertex(std::string_view line, std::string_view rest) {
  const std::size_t count = read_numbers(rest);
  if (count != 3 && count != 4 && count != 6 && count != 7) {
    lines_.fail(
        line,
        fmt::format("v with {} numbers: must be 3, or 4, 6 or 7 with weight or colour", count));
  }
  const float* n = numbers_;
  if (count >= 6 || !data_.colors.empty()) {
    data_.colors.resize(data_.positions.size(), Vec4f(1));
    const Vec4f color(n[3], n[4], n[5], count == 7 ? n[6] : 1.0F);
    data_.colors.push_back(count >= 6 ? glm::max(color, Vec4f(0)) : Vec4f(1));
  }
  data_.positions.emplace_back(n[0], n[1], n[2]);
}

void ObjVectors::add_uv(std::string_view line, std::string_view rest) {
  const std::size_t count = read_numbers(rest);
  if (count < 1 || count > 3) {
    lines_.fail(line, fmt::format("vt with {} numbers, must be 1 to 3", count));
  }
  data_.uvs.emplace_back(numbers_[0], count > 1 ? numbers_[1] : 0.0F);
}

void ObjVectors::add_normal(std::string_view line, std::string_view rest) {
  const std::size_t count = read_numbers(rest);
  if (count != 3) lines_.fail(line, fmt::format("vn with {} numbers, must be 3", count));
  data_.normals.emplace_back(numbers_[0], numbers_[1], numbers_[2]);
}

void ObjVectors::finish_colors(Warnings& warnings) {
  std::vector<Vec4f>& colors = data_.colors;
  if (colors.empty()) return;
  colors.resize(data_.positions.size(), Vec4f(1));
  const bool bytes = std::any_of(colors.begin(), colors.end(), [](const Vec4f& c) {
    return std::max({c.r, c.g, c.b, c.a}) > 1;
  });
  if (bytes) {
    warnings.push_back(lines_.path().string() + ": vertex colours beyond 1 are taken as 0 to 255");
  }
  for (Vec4f& color : colors) {
    const bool is_absent = color == Vec4f(1);  // else white would turn black next to bytes
    const float scale = bytes && !is_absent ? 1 / 255.0F : 1.0F;
    const float alpha = color.a > 1 ? color.a / 255 : color.a;  // 1 where none is given
    const Vec3f encoded = glm::min(Vec3f(color) * scale, Vec3f(1));
    color = Vec4f(linear_from_srgb(encoded), std::min(alpha, 1.0F));
  }
}

}  // namespace restframe
