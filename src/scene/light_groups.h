#pragma once

// Whose light is whose: lights, and materials that shine, belong to groups by name.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace restframe {

inline constexpr std::size_t most_light_groups = 16;  // with a layer of their own

// The group of all that belongs to no other.
inline constexpr const char* rest_of_lights = "rest";

// Letters, digits, _ and -: it names a layer. May be empty.
inline constexpr std::size_t longest_group_name = 64;  // OpenEXR cuts channels' names off at 255
bool is_group_name(const std::string& name);

// The groups of a scene but for the rest, in the order in which lights, then materials, name them.
std::vector<std::string> light_groups(const Scene& scene);

// The group of each light and each material: 0 for the rest, else 1 for the first of light_groups()
// and so on. Beyond the most that may have layers, all belong to the rest.
struct LightGroups {
  std::vector<std::int32_t> of_light, of_material;
  int count = 0;  // but for the rest

  LightGroups() = default;
  explicit LightGroups(const Scene& scene);
};

}  // namespace restframe
