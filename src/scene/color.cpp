#include "scene/color.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <vector>

#include "scene/color_names.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

double linear_from_srgb(double srgb) {
  const double size = std::abs(srgb);
  const double linear = size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4);
  return std::copysign(linear, srgb);
}

double srgb_from_linear(double linear) {
  const double size = std::abs(linear);
  const double srgb = size <= 0.0031308 ? size * 12.92 : 1.055 * std::pow(size, 1 / 2.4) - 0.055;
  return std::copysign(srgb, linear);
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// The digits of "#rgb" or "#rrggbb" as 0xrrggbb.
std::optional<std::uint32_t> parse_hex(std::string_view digits) {
  std::uint32_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  if (digits.size() == 6) return value;
  if (digits.size() != 3) return std::nullopt;
  return 0x11 * ((value & 0xf00) << 8 | (value & 0x0f0) << 4 | (value & 0x00f));
}

}  // namespace

Vec3f linear_from_srgb(const Vec3f& srgb) {
  return Vec3f(linear_from_srgb(double{srgb.x}), linear_from_srgb(double{srgb.y}),
               linear_from_srgb(double{srgb.z}));
}

Vec3f srgb_from_linear(const Vec3f& linear) {
  return Vec3f(srgb_from_linear(double{linear.x}), srgb_from_linear(double{linear.y}),
               srgb_from_linear(double{linear.z}));
}

Vec3f linear_from_srgb_hex(std::uint32_t rrggbb) {
  const auto component = [&](int shift) {
    return linear_from_srgb(((rrggbb >> shift) & 0xff) / 255.0);
  };
  return Vec3f(component(16), component(8), component(0));
}

std::optional<Vec3f> color_from_text(std::string_view text) {
  if (!text.empty() && text.front() == '#') {
    const std::optional<std::uint32_t> hex = parse_hex(text.substr(1));
    return hex ? std::optional(linear_from_srgb_hex(*hex)) : std::nullopt;
  }
  const std::string name = in_lower_case(text);
  const auto found =
      std::lower_bound(color_names.begin(), color_names.end(), name,
                       [](const NamedColor& a, const std::string& b) { return a.name < b; });
  if (found == color_names.end() || found->name != name) return std::nullopt;
  return linear_from_srgb_hex(found->srgb);
}

std::string nearest_color_name(std::string_view text) {
  std::vector<std::string> names;
  names.reserve(color_names.size());
  for (const NamedColor& color : color_names) names.emplace_back(color.name);
  return nearest(in_lower_case(text), names);
}

}  // namespace restframe
