#pragma once

#include <string>
#include <string_view>

namespace restframe {

// A message is one line, whatever texts of files are in it: control characters become '?'.
std::string on_one_line(std::string text);

// A text of a file in quotes, on one line, cut if it is long.
std::string quote(std::string_view text);

}  // namespace restframe
