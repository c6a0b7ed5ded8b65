#include "film/aov.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace restframe {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_hit = std::numeric_limits<double>::quiet_NaN();  // written as 0
using Data = const SurfaceData&;
using Units = const DataUnits&;

constexpr std::array distance_channels{DataChannel{
    "Z", ChannelKind::plain, infinite, [](Data d, Units u) { return d.distance * u.light_speed; }}};

constexpr std::array time_channels{DataChannel{"time_proper.V", ChannelKind::time_proper, not_hit,
                                               [](Data d, Units) { return d.time_proper; }},
                                   DataChannel{"time_world.V", ChannelKind::time_world, not_hit,
                                               [](Data d, Units) { return d.time_world; }}};

constexpr std::array doppler_channels{
    DataChannel{"doppler.D", ChannelKind::plain, 0.0, [](Data d, Units) { return d.doppler; }}};

constexpr std::array normal_channels{
    DataChannel{"N.X", ChannelKind::plain, 0.0, [](Data d, Units) { return d.normal.x; }},
    DataChannel{"N.Y", ChannelKind::plain, 0.0, [](Data d, Units) { return d.normal.y; }},
    DataChannel{"N.Z", ChannelKind::plain, 0.0, [](Data d, Units) { return d.normal.z; }}};

constexpr std::array position_channels{
    DataChannel{"P.X", ChannelKind::plain, 0.0,
                [](Data d, Units u) { return d.position.x * u.light_speed; }},
    DataChannel{"P.Y", ChannelKind::plain, 0.0,
                [](Data d, Units u) { return d.position.y * u.light_speed; }},
    DataChannel{"P.Z", ChannelKind::plain, 0.0,
                [](Data d, Units u) { return d.position.z * u.light_speed; }}};

// Blender reads layers of three channels with these letters, and misreads any of two.
constexpr std::array uv_channels{
    DataChannel{"UV.U", ChannelKind::plain, 0.0, [](Data d, Units) { return double(d.uv.x); }},
    DataChannel{"UV.V", ChannelKind::plain, 0.0, [](Data d, Units) { return double(d.uv.y); }},
    DataChannel{"UV.A", ChannelKind::plain, 0.0, [](Data, Units) { return 1.0; }}};

constexpr std::array id_channels{DataChannel{"id_object.V", ChannelKind::plain, 0.0,
                                             [](Data d, Units) { return d.object + 1.0; }},
                                 DataChannel{"id_material.V", ChannelKind::plain, 0.0,
                                             [](Data d, Units) { return d.material + 1.0; }}};

using Statistics = const SampleStatistics&;

float within_float(float value) {
  return std::isnan(value) ? 0.0F : std::min(value, std::numeric_limits<float>::max());
}

constexpr std::array variance_channels{
    StatisticChannel{"variance.R", [](Statistics s) { return within_float(s.variance.x); }},
    StatisticChannel{"variance.G", [](Statistics s) { return within_float(s.variance.y); }},
    StatisticChannel{"variance.B", [](Statistics s) { return within_float(s.variance.z); }}};

constexpr std::array sample_channels{
    StatisticChannel{"samples.V", [](Statistics s) { return static_cast<float>(s.samples); }}};

constexpr std::array table{LayerInfo{Layer::beauty, "beauty", {}},
                           LayerInfo{Layer::z, "Z", distance_channels},
                           LayerInfo{Layer::time, "time", time_channels},
                           LayerInfo{Layer::doppler, "doppler", doppler_channels},
                           LayerInfo{Layer::normal, "N", normal_channels},
                           LayerInfo{Layer::position, "P", position_channels},
                           LayerInfo{Layer::uv, "UV", uv_channels},
                           LayerInfo{Layer::id, "id", id_channels},
                           LayerInfo{Layer::variance, "variance", {}, variance_channels},
                           LayerInfo{Layer::samples, "samples", {}, sample_channels}};

template <class Channel>
std::vector<Channel> channels_of(std::span<const Layer> layers,
                                 std::span<const Channel> LayerInfo::*of_layer) {
  std::vector<Channel> channels;
  for (const LayerInfo& info : table) {
    if (std::find(layers.begin(), layers.end(), info.layer) == layers.end()) continue;
    const std::span<const Channel> own = info.*of_layer;
    channels.insert(channels.end(), own.begin(), own.end());
  }
  return channels;
}

}  // namespace

std::span<const LayerInfo> layer_table() {
  return table;
}

std::vector<DataChannel> data_channels(std::span<const Layer> layers) {
  return channels_of(layers, &LayerInfo::channels);
}

std::vector<StatisticChannel> statistic_channels(std::span<const Layer> layers) {
  return channels_of(layers, &LayerInfo::statistics);
}

}  // namespace restframe
