#include "scene/light_groups.h"

#include <algorithm>

namespace restframe {
namespace {

void add_name(const std::string& name, std::vector<std::string>& names) {
  if (name.empty() || name == rest_of_lights) return;
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::int32_t index_of(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0 : static_cast<std::int32_t>(found - names.begin()) + 1;
}

}  // namespace

bool is_group_name(const std::string& name) {
  if (name.size() > longest_group_name) return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

std::vector<std::string> light_groups(const Scene& scene) {
  std::vector<std::string> names;
  for (const Light& light : scene.lights) add_name(light.group, names);
  for (const Material& material : scene.materials) add_name(material.group, names);
  return names;
}

LightGroups::LightGroups(const Scene& scene) {
  std::vector<std::string> names = light_groups(scene);
  names.resize(std::min(names.size(), most_light_groups));
  count = static_cast<int>(names.size());
  for (const Light& light : scene.lights) of_light.push_back(index_of(light.group, names));
  for (const Material& m : scene.materials) of_material.push_back(index_of(m.group, names));
}

}  // namespace restframe
