#include "film/picture.h"

#include <algorithm>

namespace restframe {

Picture::Picture(int width, int height, std::span<const Layer> layers, const DataUnits& units)
    : width_(width), height_(height), units_(units) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (std::find(layers.begin(), layers.end(), Layer::beauty) != layers.end()) rgba_.resize(pixels);
  for (const DataChannel& channel : data_channels(layers)) {
    ChannelPixels pixels_of{channel, {}, {}};
    if (channel.kind == ChannelKind::plain) {
      pixels_of.values.resize(pixels);
    } else {
      pixels_of.times.resize(pixels);
    }
    channels_.push_back(std::move(pixels_of));
  }
  for (const StatisticChannel& channel : statistic_channels(layers)) {
    statistics_.push_back({channel, std::vector<float>(pixels)});
  }
}

bool Picture::shows_nothing() const {
  return has_beauty() && std::all_of(rgba_.begin(), rgba_.end(),
                                     [](const Vec4f& pixel) { return pixel.w == 0.0F; });
}

void Picture::set_data(int x, int y, const SurfaceData& data) {
  const std::size_t i = index(x, y);
  for (ChannelPixels& pixels : channels_) {
    const double value =
        data.hit ? pixels.channel.value(data, units_) : pixels.channel.where_nothing_is_hit;
    if (pixels.channel.kind == ChannelKind::plain) {
      pixels.values[i] = static_cast<float>(value);
    } else {
      pixels.times[i] = value;
    }
  }
}

void Picture::set_statistics(int x, int y, const SampleStatistics& statistics) {
  for (StatisticPixels& pixels : statistics_) {
    pixels.values[index(x, y)] = pixels.channel.value(statistics);
  }
}

}  // namespace restframe
