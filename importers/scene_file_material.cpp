#include <fmt/format.h>

#include <limits>

#include "importers/scene_file.h"
#include "importers/scene_file_spectrum.h"
#include "scene/material_properties.h"

namespace restframe {
namespace {

std::optional<MaterialReference> read_object_name(TableReader& material, const SceneFile& file) {
  const std::optional<int> index = read_object_reference(material, "object", file);
  if (!index) return std::nullopt;
  return MaterialReference{material.place("object"),
                           file.scene.objects[static_cast<std::size_t>(*index)].name};
}

Range range_of(float low, float high) {
  constexpr float unlimited = std::numeric_limits<float>::max();
  if (low <= -unlimited) return {};
  return high < unlimited ? from_to(low, high) : at_least(low);
}

void read_properties(TableReader& material, MaterialChange& change, SceneFile& file) {
  for (const ColorProperty& p : color_properties) {
    const auto property = read_property(material, p.name, {true, range_of(0, p.high)}, file);
    if (property) change.colors.emplace_back(p.member, *property);
  }
  change.spectrum = read_spectrum(material, "emission_", file);
  for (const NumberProperty& p : number_properties) {
    const auto property = read_property(material, p.name, {false, range_of(p.low, p.high)}, file);
    if (property) change.numbers.emplace_back(p.member, *property);
  }
  change.base_color_texture = material.boolean("base_color_texture");
  change.thin_walled = material.boolean("thin_walled");
  change.unlit = material.boolean("unlit");
  change.group = read_group(material);
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
