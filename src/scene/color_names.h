#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace restframe {

struct NamedColor {
  std::string_view name;   // lower case
  std::uint32_t srgb = 0;  // 0xrrggbb
};

extern const std::array<NamedColor, 148> color_names;

}  // namespace restframe
