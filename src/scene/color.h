#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "physics/vectors.h"

namespace restframe {

// Between sRGB's encoding and linear Rec. 709 (IEC 61966-2-1), a component at a time. Black to
// white is 0 to 1; what lies beyond is continued, with its sign.
Vec3f linear_from_srgb(const Vec3f& srgb);
Vec3f srgb_from_linear(const Vec3f& linear);

// 0xrrggbb in sRGB.
Vec3f linear_from_srgb_hex(std::uint32_t rrggbb);

// Linear Rec. 709 of a CSS colour name (any case), "#rgb" or "#rrggbb"; nothing if the text is
// none.
std::optional<Vec3f> color_from_text(std::string_view text);

// The CSS colour name that is spelled most like `text`.
std::string nearest_color_name(std::string_view text);

}  // namespace restframe
