#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/options.h"

namespace restframe {

// Neighbours joined: 3, 4, 5, 12 are 3 to 5, and 12. `numbers` must ascend.
std::vector<PictureRange> ranges_of(std::span<const int> numbers);

// Likewise, as text: "3-5, 12".
std::string ranges_text(std::span<const int> numbers, std::string_view separator = ", ");

}  // namespace restframe
