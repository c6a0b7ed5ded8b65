#include "film/stored_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace restframe {
namespace {

// Floats keep blink phases up to here; beyond, an origin is taken off.
constexpr double longest_float_time = 1024.0;

constexpr auto largest_half = static_cast<float>(HALF_MAX);

double time_origin(std::span<const Picture> views, ChannelKind kind) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  const auto take = [&](double t) {
    if (std::isnan(t)) return;
    least = std::min(least, t);
    most = std::max(most, t);
  };
  for (const Picture& picture : views) {
    for (const Plane& plane : picture.planes()) {
      if (plane.kind == kind) std::for_each(plane.times.begin(), plane.times.end(), take);
    }
  }
  const bool small = std::max(std::abs(least), std::abs(most)) <= longest_float_time;
  return least > most || small ? 0.0 : std::floor(least);
}

std::vector<float> float_times(const std::vector<double>& times, double origin) {
  std::vector<float> result(times.size());
  std::transform(times.begin(), times.end(), result.begin(), [origin](double t) {
    return std::isnan(t) ? 0.0F : static_cast<float>(t - origin);
  });
  return result;
}

float within(float value, float largest) {
  return std::isnan(value) ? 0.0F : glm::clamp(value, -largest, largest);
}

// The beauty within the range of the type in which it is stored.
template <class Stored>
std::vector<Stored> stored_beauty(const Picture& picture, float largest, std::size_t& changed) {
  std::vector<Stored> result;
  result.reserve(4 * picture.rgba().size());
  for (const Vec4f& pixel : picture.rgba()) {
    for (int i = 0; i < 4; ++i) {
      const float value = within(pixel[i], largest);
      if (value != pixel[i]) ++changed;
      result.emplace_back(value);
    }
  }
  return result;
}

// Infinities mean something, and stay.
std::vector<half> stored_data(const std::vector<float>& values, std::size_t& changed) {
  std::vector<half> result;
  result.reserve(values.size());
  for (const float value : values) {
    const float within = glm::clamp(value, -largest_half, largest_half);
    const bool fits = !std::isfinite(value) || within == value;
    if (!fits) ++changed;
    result.emplace_back(fits ? value : within);
  }
  return result;
}

}  // namespace

float stored_light(float value, bool as_float) {
  if (as_float) return within(value, std::numeric_limits<float>::max());
  return static_cast<float>(half(within(value, largest_half)));
}

StoredPicture::StoredPicture(std::span<const Picture> views, const PictureInfo& info)
    : time_origins_(time_origin(views, ChannelKind::time_proper),
                    time_origin(views, ChannelKind::time_world)) {
  const auto wanted = [&](const std::string& layer) {
    return info.only_layer.empty() || info.only_layer == layer;
  };
  for (std::size_t view = 0; view < views.size(); ++view) {
    const Picture& picture = views[view];
    if (picture.has_beauty() && wanted("beauty")) add_beauty(picture, view, info.float_beauty);
    for (const Plane& plane : picture.planes()) {
      StoredChannel channel{plane.name, layer_of_channel(plane.name), view};
      if (!wanted(channel.layer)) continue;
      const auto& halves = info.half_layers;
      const bool as_half = std::find(halves.begin(), halves.end(), channel.layer) != halves.end();
      add_plane(plane, std::move(channel), as_half);
    }
  }
}

void StoredPicture::add_beauty(const Picture& picture, std::size_t view, bool as_float) {
  const auto add = [&](Imf::PixelType type, const auto& rgba) {
    constexpr const char* names[4] = {"R", "G", "B", "A"};
    for (std::size_t i = 0; i < 4; ++i) {
      channels_.push_back({names[i], "beauty", view, type, &rgba[i], 4 * sizeof(rgba[i])});
    }
  };
  std::size_t& changed = report_.clamped;
  if (as_float) {
    const float largest = std::numeric_limits<float>::max();
    add(Imf::FLOAT, floats_.emplace_back(stored_beauty<float>(picture, largest, changed)));
  } else {
    add(Imf::HALF, halves_.emplace_back(stored_beauty<half>(picture, largest_half, changed)));
  }
}

void StoredPicture::add_plane(const Plane& plane, StoredChannel channel, bool as_half) {
  const std::vector<float>* values = &plane.values;
  if (plane.kind != ChannelKind::plain) {
    const bool proper = plane.kind == ChannelKind::time_proper;
    const double origin = proper ? time_origins_.first : time_origins_.second;
    values = &floats_.emplace_back(float_times(plane.times, origin));
  }
  if (as_half) {
    channel.type = Imf::HALF;
    channel.stride = sizeof(half);
    channel.pixels = halves_.emplace_back(stored_data(*values, report_.clamped_data)).data();
  } else {
    channel.stride = sizeof(float);
    channel.pixels = values->data();
  }
  channels_.push_back(std::move(channel));
}

}  // namespace restframe
