#include "app/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

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

namespace {

// Reads a number after `mark`, which is skipped; false if there is something else.
bool read_after(char mark, std::string_view& text, int& number) {
  if (text.empty() || text.front() != mark) return false;
  const auto [stop, fault] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  if (fault != std::errc{} || text[1] == '-') return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return true;
}

}  // namespace

std::vector<PictureRange> parse_pictures(const std::string& text) {
  std::vector<PictureRange> ranges;
  const std::string marked = "," + text;
  std::string_view rest = marked;
  do {
    PictureRange range;
    bool good = read_after(',', rest, range.first);
    range.last = range.first;
    if (good && rest.starts_with('-')) {
      good = read_after('-', rest, range.last);
      if (good && rest.starts_with(':')) good = read_after(':', rest, range.step);
    }
    if (!good || range.last < range.first || range.step < 1 ||
        !(rest.empty() || rest.starts_with(','))) {
      throw InputError(fmt::format(
          "--pictures: {} is neither a number, nor FIRST-LAST, nor FIRST-LAST:STEP, nor "
          "some of these joined by commas",
          quote(text)));
    }
    ranges.push_back(range);
  } while (!rest.empty());
  return ranges;
}

TileShare parse_share(const std::string& text) {
  const std::string marked = "/" + text;
  std::string_view rest = marked;
  TileShare share;
  if (!read_after('/', rest, share.part) || !read_after('/', rest, share.count) || !rest.empty() ||
      !is_share(share)) {
    throw InputError(fmt::format("--tile: {} is not PART/PARTS, as 3/16, with up to {} parts",
                                 quote(text), most_shares));
  }
  return share;
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
