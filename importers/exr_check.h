#pragma once

// What an OpenEXR file says of itself at its beginning, read with care before OpenEXR believes it.

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace restframe {

struct ExrChannel {
  std::string name;
  int type = 0;  // 0: 32-bit integers, 1: half, 2: float
  int x_sampling = 1, y_sampling = 1;
};

struct ExrWindow {
  std::int32_t min_x = 0, min_y = 0, max_x = -1, max_y = -1;  // inclusive

  std::int64_t width() const { return std::int64_t{1} + max_x - min_x; }
  std::int64_t height() const { return std::int64_t{1} + max_y - min_y; }
  bool operator==(const ExrWindow&) const = default;
};

struct ExrHeader {
  std::vector<ExrChannel> channels;
  ExrWindow data, display;
  int compression = 0;
  // Where the types of the attributes stand that the picture needs none of (offset and length). What
  // OpenEXR takes for a type that it knows it reads as long as that should be, whatever the file says.
  std::vector<std::pair<std::size_t, std::size_t>> needless_types;
  // x and y of red, green, blue and white; empty: Rec. 709's.
  std::vector<float> chromaticities;
};

// Throws InputError, `what` before the reason, where the file is none of one plain picture in scan
// lines, or its header can not be right.
ExrHeader read_exr_header(std::span<const std::uint8_t> bytes, const std::string& what);

}  // namespace restframe
