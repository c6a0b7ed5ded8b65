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

// Blender reads layers of three channels, and misreads those of two: A tells where a surface is.
constexpr std::array uv_channels{
    DataChannel{"UV.U", ChannelKind::plain, 0.0, [](Data d, Units) { return double(d.uv.x); }},
    DataChannel{"UV.V", ChannelKind::plain, 0.0, [](Data d, Units) { return double(d.uv.y); }},
    DataChannel{"UV.A", ChannelKind::plain, 0.0, [](Data, Units) { return 1.0; }}};

constexpr std::array id_channels{DataChannel{"id_object.V", ChannelKind::plain, 0.0,
                                             [](Data d, Units) { return d.object + 1.0; }},
                                 DataChannel{"id_material.V", ChannelKind::plain, 0.0,
                                             [](Data d, Units) { return d.material + 1.0; }}};

constexpr std::array depth_channels{
    DataChannel{"depth_planar.Z", ChannelKind::plain, infinite,
                [](Data d, Units u) { return d.depth * u.light_speed; }}};

constexpr std::array apparent_normal_channels{
    DataChannel{"normal.X", ChannelKind::plain, 0.0,
                [](Data d, Units) { return d.apparent_normal.x; }},
    DataChannel{"normal.Y", ChannelKind::plain, 0.0,
                [](Data d, Units) { return d.apparent_normal.y; }},
    DataChannel{"normal.Z", ChannelKind::plain, 0.0,
                [](Data d, Units) { return d.apparent_normal.z; }}};

constexpr std::array motion_channels{
    DataChannel{"motion.U", ChannelKind::plain, 0.0, [](Data d, Units) { return d.motion.x; }},
    DataChannel{"motion.V", ChannelKind::plain, 0.0, [](Data d, Units) { return d.motion.y; }},
    DataChannel{"motion.A", ChannelKind::plain, 0.0, [](Data, Units) { return 1.0; }}};

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

constexpr LayerInfo part(Layer layer, const char* name, int column) {
  return {layer, name, {}, {}, {}, column};
}
constexpr LayerInfo part(Layer layer, const char* name, LightWay way) {
  return part(layer, name, static_cast<int>(way));
}

constexpr std::array table{
    LayerInfo{Layer::beauty, "beauty", {}},
    part(Layer::emission, "emission", LightWay::emission),
    part(Layer::direct, "direct", LightWay::direct),
    part(Layer::indirect, "indirect", LightWay::indirect),
    part(Layer::reflection, "reflection", LightWay::reflection),
    part(Layer::transmission, "transmission", LightWay::transmission),
    part(Layer::lights, "lights", SampleParts::rest_of_lights),
    part(Layer::albedo, "albedo", SampleParts::albedo),
    LayerInfo{Layer::z, "Z", distance_channels},
    LayerInfo{Layer::depth, "depth", depth_channels},
    LayerInfo{Layer::time, "time", time_channels},
    LayerInfo{Layer::doppler, "doppler", doppler_channels},
    LayerInfo{Layer::normal, "N", normal_channels},
    LayerInfo{Layer::apparent_normal, "normal", apparent_normal_channels},
    LayerInfo{Layer::position, "P", position_channels},
    LayerInfo{Layer::uv, "UV", uv_channels},
    LayerInfo{Layer::id, "id", id_channels},
    LayerInfo{Layer::motion, "motion", motion_channels},
    LayerInfo{Layer::variance, "variance", {}, variance_channels},
    LayerInfo{Layer::samples, "samples", {}, sample_channels},
    LayerInfo{Layer::crypto_object, "crypto_object", {}, {}, MatteKind::object},
    LayerInfo{Layer::crypto_material, "crypto_material", {}, {}, MatteKind::material},
    LayerInfo{Layer::crypto_asset, "crypto_asset", {}, {}, MatteKind::asset}};

template <class Channel>
std::vector<Channel> channels_of(std::span<const Layer> layers,
                                 std::span<const Channel> LayerInfo::*of_layer) {
  std::vector<Channel> channels;
  for (const LayerInfo& info : table) {
    if (!has_layer(layers, info.layer)) continue;
    const std::span<const Channel> own = info.*of_layer;
    channels.insert(channels.end(), own.begin(), own.end());
  }
  return channels;
}

// The layer of what belongs to no group comes first, as its column does.
void add_light_layers(std::span<const std::string> groups, std::vector<PartLayer>& layers) {
  int column = SampleParts::rest_of_lights;
  layers.push_back({std::string("light_") + rest_of_lights, column});
  for (const std::string& group : groups.first(std::min(groups.size(), most_light_groups))) {
    layers.push_back({"light_" + group, ++column});
  }
}

}  // namespace

std::span<const LayerInfo> layer_table() {
  return table;
}

std::vector<std::string> layer_names(std::span<const Layer> layers) {
  std::vector<std::string> names;
  for (const LayerInfo& info : table) {
    const bool wanted = has_layer(layers, info.layer);
    if (wanted) names.emplace_back(info.scene_name);
  }
  return names;
}

std::string layer_of_channel(const std::string& exr_name) {
  const auto is_it = [&](const auto& channel) { return exr_name == channel.exr_name; };
  for (const LayerInfo& info : table) {
    if (std::any_of(info.channels.begin(), info.channels.end(), is_it)) return info.scene_name;
  }
  const std::size_t dot = exr_name.find('.');
  if (dot == std::string::npos) return "beauty";
  if (exr_name.starts_with("light_")) return "lights";
  // Cryptomatte has a number for each four channels.
  const bool numbered = exr_name.starts_with("crypto_");
  const std::size_t last = numbered ? exr_name.find_last_not_of("0123456789", dot - 1) : dot - 1;
  return exr_name.substr(0, last + 1);
}

bool is_light(const std::string& layer_name) {
  const auto* info = std::find_if(table.begin(), table.end(), [&](const LayerInfo& layer) {
    return layer_name == layer.scene_name;
  });
  return info != table.end() && (info->layer == Layer::beauty || info->column != no_column);
}

std::vector<DataChannel> data_channels(std::span<const Layer> layers) {
  return channels_of(layers, &LayerInfo::channels);
}

std::vector<StatisticChannel> statistic_channels(std::span<const Layer> layers) {
  return channels_of(layers, &LayerInfo::statistics);
}

std::vector<PartLayer> part_layers(std::span<const Layer> layers,
                                   std::span<const std::string> groups) {
  std::vector<PartLayer> parts;
  for (const LayerInfo& info : table) {
    if (info.column == no_column || !has_layer(layers, info.layer)) continue;
    if (info.layer == Layer::lights) {
      add_light_layers(groups, parts);
    } else {
      parts.push_back({info.scene_name, info.column});
    }
  }
  return parts;
}

std::vector<LayerInfo> matte_layers(std::span<const Layer> layers) {
  std::vector<LayerInfo> mattes;
  for (const LayerInfo& info : table) {
    if (info.matte && has_layer(layers, info.layer)) mattes.push_back(info);
  }
  return mattes;
}

}  // namespace restframe
