#include "film/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace restframe {

Picture::Picture(const PixelWindow& window, std::span<const Layer> layers, const DataUnits& units,
                 std::span<const std::string> groups)
    : window_(window),
      units_(units),
      data_(data_channels(layers)),
      statistics_(statistic_channels(layers)) {
  if (has_layer(layers, Layer::beauty)) {
    rgba_.resize(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()));
  }
  for (const DataChannel& channel : data_) add_plane(channel.exr_name, channel.kind);
  for (const StatisticChannel& channel : statistics_) {
    add_plane(channel.exr_name, ChannelKind::plain);
  }
  for (const LayerInfo& matte : matte_layers(layers)) {
    mattes_.push_back(*matte.matte);
    for (std::string& name : matte_channels(matte.scene_name)) {
      add_plane(std::move(name), ChannelKind::plain);
    }
  }
  first_part_ = planes_.size();
  for (const PartLayer& part : part_layers(layers, groups)) {
    part_columns_.push_back(part.column);
    for (const char* color : {".R", ".G", ".B"}) {
      add_plane(part.exr_name + color, ChannelKind::plain);
    }
  }
}

void Picture::add_plane(std::string name, ChannelKind kind) {
  const auto pixels = static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  Plane plane{std::move(name), kind, {}, {}};
  if (kind == ChannelKind::plain) {
    plane.values.resize(pixels);
  } else {
    plane.times.resize(pixels);
  }
  planes_.push_back(std::move(plane));
}

bool Picture::shows_nothing() const {
  return has_beauty() && std::all_of(rgba_.begin(), rgba_.end(),
                                     [](const Vec4f& pixel) { return pixel.w == 0.0F; });
}

void Picture::set_data(int x, int y, const SurfaceData& data) {
  const std::size_t i = index(x, y);
  Plane* plane = planes_.data();
  for (const DataChannel& channel : data_) {
    const double value = data.hit ? channel.value(data, units_) : channel.where_nothing_is_hit;
    if (channel.kind == ChannelKind::plain) {
      plane->values[i] = static_cast<float>(value);
    } else {
      plane->times[i] = value;
    }
    ++plane;
  }
}

void Picture::set_statistics(int x, int y, const SampleStatistics& statistics) {
  Plane* plane = planes_.data() + data_.size();
  for (const StatisticChannel& channel : statistics_) {
    (plane++)->values[index(x, y)] = channel.value(statistics);
  }
}

void Picture::set_matte(int x, int y, MatteKind kind, const MatteRanks& ranks) {
  const auto before = std::find(mattes_.begin(), mattes_.end(), kind) - mattes_.begin();
  Plane* plane = planes_.data() + data_.size() + statistics_.size() +
                 2 * ranks.size() * static_cast<std::size_t>(before);
  for (const MatteRank& rank : ranks) {
    (plane++)->values[index(x, y)] = rank.id;
    (plane++)->values[index(x, y)] = rank.coverage;
  }
}

// Within what a float holds, as the beauty.
void Picture::set_parts(int x, int y, std::span<const Vec3f> colors) {
  constexpr float largest = std::numeric_limits<float>::max();
  Plane* plane = planes_.data() + first_part_;
  for (const Vec3f& color : colors) {
    for (int i = 0; i < 3; ++i) {
      const float value = std::isnan(color[i]) ? 0.0F : glm::clamp(color[i], -largest, largest);
      (plane++)->values[index(x, y)] = value;
    }
  }
}

}  // namespace restframe
