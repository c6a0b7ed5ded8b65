#pragma once

// What the light of 16 samples consists of: by the way it came, and by whose it is.

#include <array>

#include "frames/packet.h"
#include "scene/light_groups.h"

namespace restframe {

// By the first surface on the way back from the camera: what emitters send straight to it; what its
// diffuse and sheen lobes scatter, of light straight from emitters and of other light; what its
// glossy lobes scatter; what it lets through. Together they are all light.
enum class LightWay : std::uint8_t { emission, direct, indirect, reflection, transmission };
inline constexpr int light_ways = 5;

// Colours of 16 samples besides their radiance, premultiplied as that: linear Rec. 709.
struct SampleParts {
  // Columns: the ways, the albedo, then light by its groups, the rest of them first.
  static constexpr int albedo = light_ways;
  static constexpr int rest_of_lights = albedo + 1;
  static constexpr int most_columns = rest_of_lights + 1 + static_cast<int>(most_light_groups);

  std::array<Vec3fLanes, most_columns> columns;

  void clear(const LightGroups& groups) {
    for (int i = 0; i < rest_of_lights + 1 + groups.count; ++i) at(i) = {};
  }
  Vec3fLanes& at(int column) { return columns[static_cast<std::size_t>(column)]; }
  const Vec3fLanes& at(int column) const { return columns[static_cast<std::size_t>(column)]; }

  void add(int column, int lane, const Vec3f& light) {
    at(column).set(lane, at(column).at(lane) + light);
  }
  void add(LightWay way, int lane, const Vec3f& light) { add(static_cast<int>(way), lane, light); }
  // group: as LightGroups tell it.
  void add_to_group(int group, int lane, const Vec3f& light) {
    add(rest_of_lights + group, lane, light);
  }
};

}  // namespace restframe
