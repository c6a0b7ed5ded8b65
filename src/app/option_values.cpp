#include "app/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {

void parse_sizes(const std::string& option, const std::string& text, std::vector<int*> numbers) {
  const char* at = text.data();
  const char* end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [stop, fault] = std::from_chars(at, end, *numbers[i]);
    const bool last = i + 1 == numbers.size();
    if (fault != std::errc{} || *numbers[i] < 1 ||
        (last ? stop != end : stop == end || *stop != 'x')) {
      throw InputError(
          fmt::format("{}: \"{}\" is not {} whole numbers joined by x, each at least 1", option,
                      text, numbers.size()));
    }
    at = stop + 1;
  }
}

PictureRange parse_range(const std::string& text) {
  PictureRange range;
  const char* end = text.data() + text.size();
  std::from_chars_result read = std::from_chars(text.data(), end, range.first);
  range.last = range.first;
  if (read.ec == std::errc{} && read.ptr != end && *read.ptr == '-') {
    read = std::from_chars(read.ptr + 1, end, range.last);
  }
  if (read.ec != std::errc{} || read.ptr != end || range.first < 0 || range.last < range.first) {
    throw InputError(fmt::format("--pictures: \"{}\" is neither a number nor FIRST-LAST", text));
  }
  return range;
}

std::vector<double> parse_speeds(const std::string& text) {
  std::vector<double> speeds;
  const char* end = text.data() + text.size();
  for (const char* at = text.data(); speeds.empty() || at != end;) {
    double speed = 0;
    const auto [stop, fault] = std::from_chars(speeds.empty() ? at : at + 1, end, speed);
    if (fault != std::errc{} || (stop != end && *stop != ',')) {
      throw InputError(
          fmt::format("--speeds: {} is not numbers joined by commas: 0.85,0.9", quote(text)));
    }
    if (!(speed >= 0 && speed < 1)) {
      throw InputError(fmt::format("--speeds: {}, must be at least 0 and below 1", speed));
    }
    if (std::find(speeds.begin(), speeds.end(), speed) != speeds.end()) {
      throw InputError(fmt::format("--speeds: {} is there twice", speed));
    }
    speeds.push_back(speed + 0.0);  // no -0
    at = stop;
  }
  if (speeds.size() > 8) {
    throw InputError(fmt::format("--speeds: {} speeds, at most 8", speeds.size()));
  }
  return speeds;
}

}  // namespace restframe
