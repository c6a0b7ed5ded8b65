#pragma once

#include <vector>

#include "physics/vectors.h"

namespace restframe {

// Makes linear RGBA within 0..1 of colours as mesh files hold them: in sRGB, as programs show
// them. Where any of red, green and blue is beyond 1, they are 0 to 255 if they may be; likewise
// alpha. Returns whether that was so. Infinite means full, NaN 0.
bool make_linear(std::vector<Vec4f>& colors, bool rgb_may_be_bytes, bool alpha_may_be_bytes);

// Gives all of them an alpha of 1 if none is to be seen otherwise, as some programs write them.
// Returns whether that was so.
bool mend_alpha(std::vector<Vec4f>& colors);

}  // namespace restframe
