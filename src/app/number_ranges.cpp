#include "app/number_ranges.h"

#include <fmt/format.h>

namespace restframe {

std::vector<PictureRange> ranges_of(std::span<const int> numbers) {
  std::vector<PictureRange> ranges;
  for (const int number : numbers) {
    if (!ranges.empty() && ranges.back().last + 1 == number) {
      ranges.back().last = number;
    } else {
      ranges.push_back({number, number, 1});
    }
  }
  return ranges;
}

std::string ranges_text(std::span<const int> numbers, std::string_view separator) {
  std::string text;
  for (const auto& range : ranges_of(numbers)) {
    if (!text.empty()) text += separator;
    text += fmt::format("{}", range.first);
    if (range.last > range.first) text += fmt::format("-{}", range.last);
  }
  return text;
}

}  // namespace restframe
