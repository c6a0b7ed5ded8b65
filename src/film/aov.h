#pragma once

// The one table of layers: what each is called in a scene file and in an EXR, and where its values
// come from (design, section 7).

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/settings.h"
#include "tracer/cover_counts.h"
#include "tracer/sample.h"
#include "tracer/sample_parts.h"

namespace restframe {

// Factors between what the tracer holds and what a picture holds.
struct DataUnits {
  double light_speed = 1;  // scene lengths a light-second
};

// How a channel's values are kept until the picture is written.
enum class ChannelKind : std::uint8_t {
  plain,        // float
  time_proper,  // double: the header's timeOrigin is taken off first
  time_world,
};

struct DataChannel {
  const char* exr_name;
  ChannelKind kind;
  double where_nothing_is_hit;
  double (*value)(const SurfaceData&, const DataUnits&);
};

// What a pixel's samples tell of its mean.
struct SampleStatistics {
  Vec3f variance{0};  // of the mean of red, green and blue
  int samples = 0;    // of all exposures
};

struct StatisticChannel {
  const char* exr_name;
  float (*value)(const SampleStatistics&);
};

// A colour that is added up over samples: three channels.
struct PartLayer {
  std::string exr_name;  // before .R, .G and .B
  int column = 0;        // of SampleParts
};

inline constexpr int no_column = -1;

struct LayerInfo {
  Layer layer;
  const char* scene_name;                             // in the scene file's output.layers
  std::span<const DataChannel> channels;              // empty for the beauty
  std::span<const StatisticChannel> statistics = {};  // of the beauty
  std::optional<MatteKind> matte = {};                // Cryptomatte's channels, by scene_name
  // Of SampleParts, whose layer is called as in the scene file; of the light groups: the first, and
  // there are as many layers as groups.
  int column = no_column;
};

std::span<const LayerInfo> layer_table();

// Names of layers, in the table's order.
std::vector<std::string> layer_names(std::span<const Layer> layers);

// The layer of a picture's channel: "N.X" is of "N", "time_world.V" of "time", "R" of "beauty".
std::string layer_of_channel(const std::string& exr_name);
// Whether it is only looked at: a lossy compression may change it.
bool is_light(const std::string& layer_name);

// The channels of these layers, in the table's order.
std::vector<DataChannel> data_channels(std::span<const Layer> layers);
std::vector<StatisticChannel> statistic_channels(std::span<const Layer> layers);
// groups: of the scene's lights, but for the rest.
std::vector<PartLayer> part_layers(std::span<const Layer> layers,
                                   std::span<const std::string> groups);

// Those of these layers that are mattes, likewise.
std::vector<LayerInfo> matte_layers(std::span<const Layer> layers);

}  // namespace restframe
