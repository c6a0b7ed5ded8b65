#include "importers/mixed_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/error.h"

namespace restframe {
namespace {

using Bytes = std::array<std::uint8_t, 256>;

// base + gain times the value, for each value that a byte can have.
Bytes table_of(const ChannelSource& source) {
  Bytes table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const float value = 255 * source.base + source.gain * static_cast<float>(i);
    table[i] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
  }
  return table;
}

bool has_alpha(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) return true;
  }
  return false;
}

// Rec. 709's weights in 1/256.
std::uint8_t luminance(const std::uint8_t* rgba) {
  return static_cast<std::uint8_t>((54 * rgba[0] + 183 * rgba[1] + 19 * rgba[2]) >> 8);
}

void fill_channel(Image& target, std::size_t channel, const ChannelSource& source,
                  const Image& from) {
  const Bytes table = table_of(source);
  const bool is_luminance = source.channel == 'l' || (source.channel == 'm' && !has_alpha(from));
  const std::size_t place = std::string("rgba").find(source.channel);
  const std::size_t offset = place == std::string::npos ? 3 : place;
  const auto width = static_cast<std::size_t>(target.width);
  for (std::size_t i = 0; i < target.rgba.size() / 4; ++i) {
    const std::size_t x = i % width * static_cast<std::size_t>(from.width) / width;
    const std::size_t y =
        i / width * static_cast<std::size_t>(from.height) / static_cast<std::size_t>(target.height);
    const std::uint8_t* rgba =
        from.rgba.data() + 4 * (y * static_cast<std::size_t>(from.width) + x);
    target.rgba[4 * i + channel] = table[is_luminance ? luminance(rgba) : rgba[offset]];
  }
}

void check_pixels(const Image& image, const ImportLimits& limits) {
  const auto pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (pixels <= limits.image_pixels) return;
  throw InputError(fmt::format("{}: mixed with another image has {} by {} pixels, the limit is {}",
                               image.name, image.width, image.height, limits.image_pixels));
}

}  // namespace

Image mix_image(const ChannelSources& sources, const ImportLimits& limits,
                const std::function<Image(const std::string&)>& image) {
  std::map<std::string, Image> images;
  Image result;
  for (const ChannelSource& source : sources) {
    if (source.file.empty()) continue;
    if (!images.count(source.file)) images.emplace(source.file, image(source.file));
    const Image& from = images.at(source.file);
    if (result.name.empty()) result.name = from.name;
    result.width = std::max(result.width, from.width);
    result.height = std::max(result.height, from.height);
  }
  check_pixels(result, limits);
  result.rgba.assign(
      4 * static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height), 255);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const ChannelSource& source = sources[channel];
    if (!source.file.empty()) fill_channel(result, channel, source, images.at(source.file));
  }
  return result;
}

}  // namespace restframe
