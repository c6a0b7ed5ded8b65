#include <fmt/format.h>

#include "importers/scene_file.h"

namespace restframe {
namespace {

std::optional<MaterialReference> read_object_name(TableReader& material, const SceneFile& file) {
  const std::optional<int> index = read_object_reference(material, "object", file);
  if (!index) return std::nullopt;
  return MaterialReference{material.place("object"),
                           file.scene.objects[static_cast<std::size_t>(*index)].name};
}

void read_properties(TableReader& material, MaterialChange& change, SceneFile& file) {
  const ValueRule reflectance{true, from_to(0, 1)}, fraction{false, from_to(0, 1)};
  change.base_color = read_property(material, "base_color", reflectance, file);
  change.metallic = read_property(material, "metallic", fraction, file);
  change.roughness = read_property(material, "roughness", fraction, file);
  change.emission = read_property(material, "emission", {true, at_least(0)}, file);
  change.emission_strength =
      read_property(material, "emission_strength", {false, at_least(0)}, file);
  change.opacity = read_property(material, "opacity", fraction, file);
  change.base_color_texture = material.boolean("base_color_texture");
  change.unlit = material.boolean("unlit");
  change.ior = read_property(material, "ior", {false, at_least(1)}, file);
  change.transmission = read_property(material, "transmission", fraction, file);
  change.attenuation_color = read_property(material, "attenuation_color", reflectance, file);
  change.attenuation_distance =
      read_property(material, "attenuation_distance", {false, at_least(0)}, file);
  material.not_supported({"specular", "specular_color", "clearcoat", "clearcoat_roughness",
                          "sheen_color", "sheen_roughness", "normal_scale"});
}

std::optional<MaterialChange> read_change(const ConfigTable& table, SceneFile& file) {
  TableReader unnamed(table, {file.faults, "material"});
  const auto name = unnamed.text("name");
  if (!unnamed.has("name")) unnamed.report(table.at, "name is missing");
  TableReader material(table, {file.faults, fmt::format("material \"{}\"", name.value_or(""))});
  material.find("name");
  MaterialChange change;
  change.at = material.place("name");
  change.name = name.value_or("");
  change.object = read_object_name(material, file);
  const bool lost = !name || (material.has("object") && !change.object);
  read_properties(material, change, file);
  material.finish();
  if (!lost) return change;
  file.names_complete = false;
  return std::nullopt;
}

}  // namespace

void read_material_properties(TableReader& material, MaterialChange& change, SceneFile& file) {
  read_properties(material, change, file);
}

std::vector<MaterialChange> read_material_changes(TableReader& root, SceneFile& file) {
  std::vector<MaterialChange> changes;
  for (const ConfigTable* table : root.tables("material")) {
    if (auto change = read_change(*table, file)) changes.push_back(std::move(*change));
  }
  return changes;
}

}  // namespace restframe
