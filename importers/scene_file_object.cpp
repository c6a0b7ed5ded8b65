#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "importers/moving_nodes.h"
#include "importers/scene_file_motion.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

Mat4 read_placement(TableReader& table, double light_speed) {
  const Vec3 degrees = table.vector("rotation").value_or(Vec3(0));
  const double scale = table.number("scale", above(0)).value_or(1);
  return glm::scale(rotation_matrix(degrees), Vec3(scale / light_speed));
}

void add_slot_materials(const ConfigEntry& entry, const SceneAsset& asset, const Reporter& report,
                        ObjectMaterials& materials) {
  const auto name = read_text(entry.value, entry.key, report);
  std::vector<std::string> slots;
  bool found = false;
  for (int slot = 0; slot < slot_count(asset); ++slot) {
    const int material = material_of_slot(asset, slot, materials.variant);
    slots.push_back(asset.materials[static_cast<std::size_t>(material)].name);
    if (slots.back() != entry.key) continue;
    found = true;
    if (name) materials.slots[slot] = {entry.value.at, *name};
  }
  if (!found) {
    report(entry.key_at, fmt::format("the asset has no material \"{}\", the nearest is \"{}\"",
                                     entry.key, nearest(entry.key, slots)));
  }
}

int read_variant(TableReader& table, std::optional<int> asset, const SceneFile& file) {
  const auto name = table.text("variant");
  if (!name || !asset) return no_variant;
  try {
    return find_variant(file.assets[static_cast<std::size_t>(*asset)], *name);
  } catch (const InputError& error) {
    table.report(table.place("variant"), error.what());
    return no_variant;
  }
}

ObjectMaterials read_materials(TableReader& table, std::optional<int> asset,
                               const SceneFile& file) {
  ObjectMaterials materials;
  materials.asset = asset.value_or(-1);
  materials.variant = read_variant(table, asset, file);
  if (const auto name = table.text("material")) {
    materials.all_slots = MaterialReference{table.place("material"), *name};
  }
  const ConfigTable* by_slot = table.table("materials");
  if (!by_slot || !asset) return materials;
  const Reporter report{table.report.faults, table.report.name + ": materials"};
  for (const ConfigEntry& entry : by_slot->entries) {
    add_slot_materials(entry, file.assets[static_cast<std::size_t>(*asset)], report, materials);
  }
  return materials;
}

std::string read_name(const ConfigTable& table, SceneFile& file) {
  const std::string fallback = fmt::format("object_{}", ++file.object_tables);
  TableReader reader(table, {file.faults, fallback});
  std::string name = reader.text("name").value_or(fallback);
  const int index = static_cast<int>(file.scene.objects.size());
  if (!file.object_of_name.emplace(name, index).second) {
    file.faults.add(reader.place("name"), fmt::format("two objects have the name \"{}\"", name));
  }
  return name;
}

// Nodes that have motions of their own move by them, unless the object has one.
NodeGroups read_groups(TableReader& object, const AssetAuthoring& said, const AssetTree& tree,
                       const NodeRanges& nodes) {
  NodeGroups groups = grouped(said, nodes);
  if (groups.moving.empty()) return groups;
  for (const char* key : {"velocity", "gamma"}) {
    if (!object.has(key)) continue;
    const NodeMotion& motion = said.motions[static_cast<std::size_t>(groups.moving.begin()->first)];
    object.report(
        object.key_place(key),
        fmt::format("{} and the asset's own motion of node \"{}\" ({}) exclude each other", key,
                    node_name(tree, motion.node),
                    object.report.faults.place_text(motion.at.place)));
    groups.moving.clear();
  }
  return groups;
}

// Objects share their assets' meshes, but each has its own list of what it places and of materials:
// many that place all of a large asset would take any amount. False where it is too much: the first
// time with a fault.
bool fits(const TableReader& reader, const SceneAsset& asset, const NodeRanges& nodes,
          std::size_t moving, SceneFile& file) {
  const std::size_t limit = file.limits.total_bytes, parts = count_parts(asset, nodes);
  const bool fitted = file.placed_bytes <= limit;
  const std::size_t material_bytes = static_cast<std::size_t>(slot_count(asset)) * sizeof(int);
  file.placed_bytes += parts * sizeof(PlacedMesh) + nodes.size() * sizeof(NodeRange) +
                       (1 + moving) * (sizeof(Object) + material_bytes);
  if (file.placed_bytes <= limit) return true;
  if (fitted) {
    reader.report(reader.place(),
                  fmt::format("places {} of its asset's meshes: the lists of all objects up to "
                              "this one need more than {} bytes, the limit; --max-bytes raises it",
                              parts, limit));
  }
  return false;
}

// Of nodes that are there, but have nothing to show.
void warn_if_empty(TableReader& reader, const SceneAsset& asset, const Object& object,
                   const NodeGroups& groups, SceneFile& file) {
  const bool picks = reader.has("node") || reader.has("without") || reader.has("scene");
  const bool is_empty = object.parts.empty() && groups.moving.empty() && !asset.parts.empty();
  if (!picks || !is_empty || !file.faults.empty()) return;
  file.warnings.push_back(file.faults.located(
      reader.place(), reader.report.name + ": the nodes that it picks hold no triangles"));
}

void read_object(const ConfigTable& table, SceneFile& file) {
  Object object;
  object.name = read_name(table, file);
  TableReader reader(table, {file.faults, fmt::format("object \"{}\"", object.name)});
  reader.find("name");
  const ClockedWorldline own = read_clocked_worldline(reader, "direction", file.scene.light_speed);
  object.worldline = own.worldline;
  object.clock = own.clock;
  object.frame_clock = own.frame_clock;
  const Mat4 object_from_asset = read_placement(reader, file.scene.light_speed);
  const std::optional<int> asset = read_asset(reader, file);
  for (const char* key : {"scene", "node", "without", "lights"}) reader.find(key);
  NodeGroups groups;
  NodeRanges nodes;
  if (asset) {
    SceneAsset& its_asset = file.assets[static_cast<std::size_t>(*asset)];
    nodes = read_nodes(reader, its_asset);
    groups = read_groups(reader, file.authoring[static_cast<std::size_t>(*asset)], its_asset.tree,
                         nodes);
    if (!fits(reader, its_asset, nodes, groups.moving.size(), file)) {
      groups = {};
      nodes.clear();
    }
    object.parts = placed_parts(its_asset, groups.resting, object_from_asset);
    if (wants_part_names(file.scene) && has_many_nodes(its_asset, groups.resting)) {
      name_parts(its_asset, groups.resting, object.name + "/", object);
    }
    warn_if_empty(reader, its_asset, object, groups, file);
  }
  file.object_from_asset.push_back(object_from_asset);
  file.object_materials.push_back(read_materials(reader, asset, file));
  const bool with_lights = reader.boolean("lights").value_or(true);
  reader.finish();
  const auto index = static_cast<int>(file.scene.objects.size());
  const std::string prefix = object.name + "/";
  file.scene.objects.push_back(std::move(object));
  const std::map<int, int> moving = add_moving_nodes(index, groups.moving, prefix, file);
  if (asset && with_lights) file.lit_objects.push_back({index, moving, prefix, std::move(nodes)});
}

}  // namespace

Mat4 rotation_matrix(const Vec3& degrees) {
  const Vec3 angle = glm::radians(degrees);
  return glm::rotate(Mat4(1), angle.z, Vec3(0, 0, 1)) *
         glm::rotate(Mat4(1), angle.y, Vec3(0, 1, 0)) *
         glm::rotate(Mat4(1), angle.x, Vec3(1, 0, 0));
}

std::optional<int> read_object_reference(TableReader& table, const std::string& key,
                                         const SceneFile& file) {
  const auto name = table.text(key);
  if (!name) return std::nullopt;
  const auto found = file.object_of_name.find(*name);
  if (found != file.object_of_name.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, index] : file.object_of_name) names.push_back(known);
  table.report(table.place(key), fmt::format("there is no object \"{}\", the nearest is \"{}\"",
                                             *name, nearest(*name, names)));
  return std::nullopt;
}

Vec3 object_point(const SceneFile& file, int object, const Vec3& point) {
  return Vec3(file.object_from_asset[static_cast<std::size_t>(object)] * glm::dvec4(point, 1.0));
}

void read_objects(TableReader& root, SceneFile& file) {
  for (const ConfigTable* table : root.tables("object")) read_object(*table, file);
  if (!root.has("object")) {
    root.report(root.place(), "there is no [[object]], must be at least one");
  }
}

}  // namespace restframe
