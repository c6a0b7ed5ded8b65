// The map of an environment: an OpenEXR file, and how it is turned.

#include <fmt/format.h>

#include <algorithm>

#include "importers/input_file.h"
#include "importers/scene_file.h"

namespace restframe {
namespace {

std::size_t bytes_of(const std::vector<SkyMap>& maps) {
  std::size_t bytes = 0;
  for (const SkyMap& map : maps) bytes += map.pixels.size() * sizeof(Vec3f);
  return bytes;
}

// The file's index in Scene::sky_maps; many lights may share it. -1, and a fault, if there is no such file.
int add_map(TableReader& table, const std::string& name, SceneFile& file) {
  const Path path = named_path(name, table.place("file"), file);
  if (const auto fault = input_file_fault(path)) {
    table.report(table.place("file"), fmt::format("file \"{}\": {}", name, *fault));
    return -1;
  }
  const auto [known, is_new] = file.sky_map_of_path.emplace(
      std::filesystem::canonical(path).string(), static_cast<int>(file.scene.sky_maps.size()));
  if (!is_new) return known->second;
  ImportLimits limits = file.limits;
  limits.total_bytes -= std::min(limits.total_bytes, bytes_of(file.scene.sky_maps));
  using Bytes = std::vector<std::uint8_t>;
  const Bytes bytes = read_input_file<Bytes>(path, limits.total_bytes, path.string());
  file.scene.sky_maps.push_back(decode_sky_map(bytes, path.string(), limits, file.warnings));
  add_source(file.scene, source_name(name, path, file), path);
  return known->second;
}

}  // namespace

void read_sky_map(TableReader& table, SceneFile& file, Light& light) {
  const auto degrees = table.vector("rotation");
  const auto name = table.text("file");
  if (table.has("rotation") && !table.has("file")) {
    table.report(table.key_place("rotation"), "rotation goes with a file only");
  }
  if (degrees) light.rest_from_map = Mat3(rotation_matrix(*degrees));
  if (!name) return;
  try {
    light.sky_map = add_map(table, *name, file);
  } catch (const InputError& error) {
    file.faults.add(table.place("file"), error);
  }
}

}  // namespace restframe
