#include "importers/asset_extras.h"

#include <fmt/format.h>

#include <utility>

#include "importers/json_config.h"
#include "importers/material_change.h"
#include "importers/scene_file_motion.h"

namespace restframe {
namespace {

constexpr std::size_t most_toml = 4'000'000;  // characters of all strings of an asset

Reporter node_reporter(const AssetTree& tree, int node, SceneFile& file) {
  return {file.faults, fmt::format("node \"{}\"", node_name(tree, node))};
}

void read_node(const ConfigTable& table, int node, const AssetTree& tree, SceneFile& file,
               AssetAuthoring& said) {
  TableReader reader(table, node_reporter(tree, node, file));
  NodeMotion motion;
  motion.node = node;
  motion.at = table.at;
  motion.origin = Vec3(tree.nodes[static_cast<std::size_t>(node)].asset_from_node[3]);
  motion.own = read_clocked_worldline(reader, "direction", 1, motion.origin);
  motion.has_velocity = reader.has("velocity") || reader.has("gamma");
  motion.has_clock = reader.has("clock");
  const bool says_place = reader.has("position") || reader.has("time");
  reader.finish();
  if (motion.has_velocity || motion.has_clock || says_place) said.motions.push_back(motion);
}

void read_material(const ConfigTable& table, Material& material, SceneFile& file) {
  TableReader reader(table, {file.faults, fmt::format("material \"{}\"", material.name)});
  MaterialChange change;
  read_material_properties(reader, change, file);
  reader.finish();
  apply(change, material);
}

void read_one(const AssetExtras& extras, ConfigTable table, SceneAsset& asset, SceneFile& file,
              AssetAuthoring& said) {
  switch (extras.of) {
    case ExtrasOf::scene:
      if (extras.index == asset.tree.default_scene) said.scene = std::move(table);
      break;
    case ExtrasOf::node:
      read_node(table, extras.index, asset.tree, file, said);
      break;
    case ExtrasOf::material:
      read_material(table, asset.materials[static_cast<std::size_t>(extras.index)], file);
      break;
    case ExtrasOf::light:
      said.lights.emplace(extras.index, std::move(table));
      break;
    case ExtrasOf::camera:
      said.cameras.emplace(extras.index, std::move(table));
      break;
  }
}

// The nearest motion at or above each node.
std::vector<int> owners_of(const AssetTree& tree, const std::vector<NodeMotion>& motions) {
  std::vector<int> owners(tree.nodes.size(), -1);
  std::size_t next = 0;
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const int parent = tree.nodes[i].parent;
    if (parent >= 0) owners[i] = owners[static_cast<std::size_t>(parent)];
    if (next < motions.size() && motions[next].node == static_cast<int>(i)) {
      owners[i] = static_cast<int>(next++);
    }
  }
  return owners;
}

// A clock or a position alone leaves open whether a node goes on with the one above that moves.
void check_nested(const AssetTree& tree, const AssetAuthoring& said, SceneFile& file) {
  for (const NodeMotion& motion : said.motions) {
    const int parent = tree.nodes[static_cast<std::size_t>(motion.node)].parent;
    const int above = parent < 0 ? -1 : said.owners[static_cast<std::size_t>(parent)];
    if (motion.has_velocity || above < 0) continue;
    const NodeMotion& carrier = said.motions[static_cast<std::size_t>(above)];
    if (!carrier.has_velocity) continue;
    node_reporter(tree, motion.node, file)(
        motion.at, fmt::format("position, time and clock need a velocity here, since node \"{}\" "
                               "above it has one",
                               node_name(tree, carrier.node)));
  }
}

}  // namespace

std::string node_name(const AssetTree& tree, int node) {
  const AssetNode& it = tree.nodes[static_cast<std::size_t>(node)];
  return it.name.empty() ? fmt::format("node_{}", it.number) : it.name;
}

AssetAuthoring read_asset_extras(SceneAsset& asset, const std::filesystem::path& path,
                                 SceneFile& file) {
  AssetAuthoring said;
  said.path = path;
  const std::optional<Path> before = std::exchange(file.asset_being_read, path);
  std::size_t toml = 0;
  for (const AssetExtras& extras : asset.tree.extras) {
    const int place = file.faults.add_place(path.string() + ":" + extras.place);
    if (extras.text.starts_with('"')) toml += extras.text.size();
    if (toml > most_toml) {
      file.faults.add({0, 0, place},
                      fmt::format("more than {} characters of TOML in all", most_toml));
      break;
    }
    std::optional<ConfigTable> table = parse_json_or_toml(extras.text, place, file.faults);
    if (table) read_one(extras, std::move(*table), asset, file, said);
  }
  file.asset_being_read = before;
  if (said.motions.empty()) return said;
  said.owners = owners_of(asset.tree, said.motions);
  check_nested(asset.tree, said, file);
  return said;
}

}  // namespace restframe
