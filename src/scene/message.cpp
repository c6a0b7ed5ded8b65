#include "scene/message.h"

#include <algorithm>

namespace restframe {

std::string on_one_line(std::string text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  std::replace_if(text.begin(), text.end(), is_control, '?');
  return text;
}

std::string quote(std::string_view text) {
  constexpr std::size_t longest = 80;
  const char* const end = text.size() > longest ? "...\"" : "\"";
  return on_one_line('"' + std::string(text.substr(0, longest))) + end;
}

}  // namespace restframe
