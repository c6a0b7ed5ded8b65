#pragma once

#include <array>
#include <functional>
#include <string>
#include <tuple>

#include "importers/importers.h"

namespace restframe {

// Where one channel of an image comes from: base + gain times a channel of another one.
struct ChannelSource {
  std::string file;  // empty: the channel is 1 throughout
  // r, g, b or a; l: luminance; m: the alpha of an image that has any, else its luminance.
  char channel = 'r';
  float base = 0, gain = 1;

  bool operator==(const ChannelSource& other) const = default;
  bool operator<(const ChannelSource& other) const {
    return std::tie(file, channel, base, gain) <
           std::tie(other.file, other.channel, other.base, other.gain);
  }
};

using ChannelSources = std::array<ChannelSource, 4>;  // of red, green, blue, alpha

// An image mixed of others, as large as the largest of them, without interpolation. `image` returns
// the image of a file. Throws InputError if there would be too many pixels.
Image mix_image(const ChannelSources& sources, const ImportLimits& limits,
                const std::function<Image(const std::string&)>& image);

}  // namespace restframe
