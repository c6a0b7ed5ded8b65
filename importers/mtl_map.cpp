#include "importers/mtl_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "importers/text_lines.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr float largest = 1e15F;

class MapReader {
 public:
  MapReader(std::string_view rest, const LineReader& lines, std::set<std::string>& unused)
      : rest_(rest), lines_(lines), unused_(unused) {}

  MtlMap read(std::string_view key) {
    map_.key = key;
    std::string_view name;
    while (!trimmed(rest_).empty()) {
      const std::string_view before = rest_;
      const std::string_view word = take_word(rest_);
      if (read_option(word)) continue;
      rest_ = before;
      name = take_name();
    }
    map_.file = name;
    map_.smooth = blend_u_ || blend_v_;
    if (blend_u_ != blend_v_) unused_.insert(blend_u_ ? "-blendv" : "-blendu");
    return map_;
  }

 private:
  bool read_option(std::string_view word) {
    if (word == "-o" || word == "-s" || word == "-t") {
      read_vector(word);
    } else if (word == "-mm") {
      map_.base = number_of(word);
      map_.gain = number_of(word);
    } else if (word == "-bm") {
      map_.multiplier = number_of(word);
    } else if (word == "-clamp") {
      map_.clamp = is_on(word);
    } else if (word == "-blendu") {
      blend_u_ = is_on(word);
    } else if (word == "-blendv") {
      blend_v_ = is_on(word);
    } else if (word == "-imfchan") {
      read_channel(word);
    } else if (word == "-texres" || word == "-boost" || word == "-type" || word == "-cc") {
      if (take_word(rest_).empty()) fail(word, "a value");
      unused_.emplace(word);
    } else {
      return false;
    }
    return true;
  }

  // u, u v or u v w.
  void read_vector(std::string_view option) {
    Vec2f& vector = option == "-s" ? map_.scale : map_.offset;
    Vec2f read = vector;
    for (int i = 0; i < 3; ++i) {
      std::string_view after = rest_;
      const std::string_view word = take_word(after);
      double value = 0;
      if (!read_number(word, value)) {
        if (i == 0) fail(option, "a number");
        break;
      }
      rest_ = after;
      if (i < 2) read[i] = limited(value);
    }
    if (option == "-t") {
      unused_.emplace(option);
    } else {
      vector = read;
    }
  }

  float number_of(std::string_view option) {
    const std::string_view word = take_word(rest_);
    double value = 0;
    if (word.empty()) fail(option, "a number");
    if (!read_number(word, value)) lines_.fail(word, number_fault(word));
    return limited(value);
  }

  static float limited(double value) {
    return static_cast<float>(std::clamp(value, -double{largest}, double{largest}));
  }

  bool is_on(std::string_view option) {
    const std::string_view word = take_word(rest_);
    if (word != "on" && word != "off") fail(option, "on or off");
    return word == "on";
  }

  void read_channel(std::string_view option) {
    const std::string_view word = take_word(rest_);
    if (word.size() != 1 || std::string_view("rgbmlz").find(word[0]) == word.npos) {
      fail(option, "one of r, g, b, m, l and z");
    }
    map_.channel = word[0];
    if (word == "z") unused_.insert("-imfchan z");
  }

  // Up to the next option that is known.
  std::string_view take_name() {
    const std::string_view all = trimmed(rest_);
    rest_ = all;
    std::size_t length = 0;
    while (!rest_.empty()) {
      std::string_view after = rest_;
      const std::string_view word = take_word(after);
      if (length > 0 && is_option(word)) break;
      length = static_cast<std::size_t>(word.data() + word.size() - all.data());
      rest_ = trimmed(after);
    }
    return all.substr(0, length);
  }

  static bool is_option(std::string_view word) {
    constexpr std::string_view options[] = {"-o",     "-s",      "-t",      "-mm",     "-bm",
                                            "-clamp", "-blendu", "-blendv", "-texres", "-imfchan",
                                            "-boost", "-type",   "-cc"};
    return std::find(std::begin(options), std::end(options), word) != std::end(options);
  }

  [[noreturn]] void fail(std::string_view option, const char* what) const {
    lines_.fail(option, fmt::format("{} must be followed by {}", option, what));
  }

  std::string_view rest_;
  const LineReader& lines_;
  std::set<std::string>& unused_;
  MtlMap map_;
  bool blend_u_ = true, blend_v_ = true;
};

}  // namespace

MtlMap read_mtl_map(std::string_view key, std::string_view rest, const LineReader& lines,
                    std::set<std::string>& unused) {
  return MapReader(rest, lines, unused).read(key);
}

}  // namespace restframe
