#include <fmt/format.h>

#include <algorithm>

#include "scene/light_groups.h"
#include "scene/validate_data.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

bool is_part_of_beauty(Layer layer) {
  constexpr Layer parts[] = {Layer::emission,   Layer::direct,       Layer::indirect,
                             Layer::reflection, Layer::transmission, Layer::lights};
  return std::find(std::begin(parts), std::end(parts), layer) != std::end(parts);
}

bool is_of_one_sample(Layer layer) {
  constexpr Layer data[] = {
      Layer::z,  Layer::time, Layer::doppler, Layer::normal,          Layer::position,
      Layer::uv, Layer::id,   Layer::depth,   Layer::apparent_normal, Layer::motion};
  return std::find(std::begin(data), std::end(data), layer) != std::end(data);
}

void check_group(const std::string& group, const std::string& name, Faults& faults) {
  if (is_group_name(group)) return;
  faults.push_back(fmt::format("{}: group is \"{}\", must be up to {} letters, digits, _ and -",
                               name, group, longest_group_name));
}

}  // namespace

bool takes_all_samples(const std::vector<Layer>& layers) {
  return !std::all_of(layers.begin(), layers.end(), is_of_one_sample);
}

void validate_layers(const Scene& scene, Faults& faults) {
  for (const Light& light : scene.lights) {
    check_group(light.group, fmt::format("light \"{}\"", light.name), faults);
  }
  for (const Material& material : scene.materials) {
    check_group(material.group, fmt::format("material \"{}\"", material.name), faults);
  }
  const std::vector<Layer>& layers = scene.output.layers;
  const bool has_parts = std::any_of(layers.begin(), layers.end(), is_part_of_beauty);
  if (has_parts && scene.exposure.count > 1 && scene.exposure.combine == Combine::max) {
    faults.emplace_back(
        "output: what exposures combined by \"max\" show is no sum of parts: leave out the layers "
        "\"emission\", \"direct\", \"indirect\", \"reflection\", \"transmission\" and \"lights\", "
        "or combine by \"sum\" or \"mean\"");
  }
  const std::size_t groups = light_groups(scene).size();
  if (has_layer(scene.output.layers, Layer::lights) && groups > most_light_groups) {
    faults.push_back(
        fmt::format("output: the layer \"lights\" would hold {} groups, at most {} "
                    "can be",
                    groups, most_light_groups));
  }
}

}  // namespace restframe
