// Which of an asset's nodes an object shows: `scene`, `node` and `without`.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "importers/material_change.h"
#include "importers/scene_file.h"
#include "scene/message.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

constexpr std::size_t most_candidates = 2'000;  // that a misspelt name is compared with

std::string nearest_words(const std::string& name, const std::vector<std::string>& known) {
  return fmt::format("the nearest is {}", quote(nearest(name, known)));
}

std::optional<int> scene_of_name(const std::string& name, const AssetTree& tree) {
  for (std::size_t i = 0; i < tree.scenes.size(); ++i) {
    if (tree.scenes[i].name == name) return static_cast<int>(i);
  }
  return std::nullopt;
}

// The index of the scene that `scene` asks for by name or number.
int read_scene(TableReader& object, const AssetTree& tree) {
  const ConfigValue* value = object.find("scene");
  if (!value) return tree.default_scene;
  const auto last = static_cast<std::int64_t>(tree.scenes.size()) - 1;
  const auto* name = std::get_if<std::string>(&value->data);
  if (tree.scenes.empty()) {
    object.report(value->at, "the asset has no scenes to choose from, leave out scene");
  } else if (!name) {
    const auto number = object.whole_number("scene", 0, last);
    return static_cast<int>(number.value_or(tree.default_scene));
  } else if (const auto found = scene_of_name(*name, tree)) {
    return *found;
  } else {
    std::vector<std::string> known;
    for (const AssetScene& scene : tree.scenes) {
      if (!scene.name.empty() && known.size() < most_candidates) known.push_back(scene.name);
    }
    object.report(value->at, fmt::format("the asset has no scene {}, {}", quote(*name),
                                         known.empty() ? "its scenes have no names: give a number"
                                                       : nearest_words(*name, known)));
  }
  return tree.default_scene;
}

// Patterns, each with its place; a single text or a list of them.
using PlacedText = std::pair<TextPosition, std::string>;
std::vector<PlacedText> read_patterns(TableReader& object, const std::string& key) {
  std::vector<PlacedText> patterns;
  const ConfigValue* value = object.find(key);
  if (!value) return patterns;
  const auto add = [&](const ConfigValue& element) {
    if (const auto text = read_text(element, key, object.report)) {
      patterns.emplace_back(element.at, *text);
    }
  };
  const auto* list = std::get_if<ConfigArray>(&value->data);
  if (!list) {
    add(*value);
  } else if (list->empty()) {
    object.report(value->at, fmt::format("{} is an empty list, name at least one node", key));
  } else {
    std::for_each(list->begin(), list->end(), add);
  }
  return patterns;
}

std::vector<std::string> some_names(const AssetTree& tree, const NodeRanges& nodes) {
  std::set<std::string> names;
  for (const NodeRange& range : nodes) {
    for (int i = range.begin; i < range.end && names.size() < most_candidates; ++i) {
      const std::string& name = tree.nodes[static_cast<std::size_t>(i)].name;
      if (!name.empty()) names.insert(name);
    }
  }
  return {names.begin(), names.end()};
}

// What all the patterns mean together: nodes of that name, with what is below them.
NodeRanges find_all(const std::vector<PlacedText>& patterns, SceneAsset& asset,
                    const NodeRanges& scene, const Reporter& report) {
  std::vector<NodeRange> found;
  for (const auto& [at, pattern] : patterns) {
    NodeRanges matching = common(find_nodes(asset, pattern), scene);
    if (matching.empty()) {
      const std::vector<std::string> names = some_names(asset.tree, scene);
      report(at, fmt::format(
                     "no node of the asset is called {}, {}", quote(pattern),
                     names.empty() ? "its nodes have no names" : nearest_words(pattern, names)));
    }
    found.insert(found.end(), matching.begin(), matching.end());
  }
  return united(std::move(found));
}

}  // namespace

NodeRanges read_nodes(TableReader& object, SceneAsset& asset) {
  const NodeRanges scene = nodes_of_scene(asset.tree, read_scene(object, asset.tree));
  const auto wanted = read_patterns(object, "node");
  const auto unwanted = read_patterns(object, "without");
  NodeRanges nodes = object.has("node") ? find_all(wanted, asset, scene, object.report) : scene;
  if (unwanted.empty()) return nodes;
  return without(nodes, find_all(unwanted, asset, scene, object.report));
}

}  // namespace restframe
