#include "importers/scene_assets.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "importers/asset_extras.h"
#include "importers/material_change.h"
#include "scene/error.h"
#include "scene/material_properties.h"
#include "scene/message.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

template <class T>
void move_into(std::vector<T>& target, std::vector<T>& source) {
  target.insert(target.end(), std::make_move_iterator(source.begin()),
                std::make_move_iterator(source.end()));
}

// Of the nodes from `node` on.
std::vector<Part>::const_iterator first_part(const SceneAsset& asset, int node) {
  const auto is_before = [](const Part& part, int wanted) { return part.node < wanted; };
  return std::lower_bound(asset.parts.begin(), asset.parts.end(), node, is_before);
}

void sort_by_name(const std::vector<AssetNode>& nodes, std::vector<int>& sorted) {
  sorted.resize(nodes.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](int a, int b) {
    return nodes[static_cast<std::size_t>(a)].name < nodes[static_cast<std::size_t>(b)].name;
  });
}

}  // namespace

SceneAsset add_asset(Scene& scene, Asset asset) {
  const int first_mesh = static_cast<int>(scene.meshes.size());
  const int first_texture = static_cast<int>(scene.textures.size());
  const int first_image = static_cast<int>(scene.images.size());
  SceneAsset added;
  added.name = asset.name;
  added.parts = std::move(asset.parts);
  for (Part& part : added.parts) part.mesh += first_mesh;
  added.tree = std::move(asset.tree);
  for (Texture& texture : asset.textures) texture.image += first_image;
  for (Material& material : asset.materials) {
    for (const TextureProperty& property : texture_properties) {
      TextureUse& use = material.*property.member;
      if (use.texture >= 0) use.texture += first_texture;
    }
  }
  added.materials = std::move(asset.materials);
  added.variants = std::move(asset.variants);
  added.variant_slots = std::move(asset.variant_slots);
  move_into(scene.meshes, asset.meshes);
  move_into(scene.textures, asset.textures);
  move_into(scene.images, asset.images);
  return added;
}

int material_of_slot(const SceneAsset& asset, int slot, int variant) {
  const auto index = static_cast<std::size_t>(slot);
  if (index < asset.materials.size()) return slot;
  const VariantSlot& by_variant = asset.variant_slots[index - asset.materials.size()];
  const auto found = by_variant.by_variant.find(variant);
  return found == by_variant.by_variant.end() ? by_variant.material : found->second;
}

int find_variant(const SceneAsset& asset, const std::string& name) {
  const auto found = std::find(asset.variants.begin(), asset.variants.end(), name);
  if (found != asset.variants.end()) return static_cast<int>(found - asset.variants.begin());
  if (asset.variants.empty()) {
    throw InputError(fmt::format("variant {}: the asset has no variants", quote(name)));
  }
  throw InputError(fmt::format("the asset has no variant {}, the nearest is {}", quote(name),
                               quote(nearest(name, asset.variants))));
}

NodeRanges find_nodes(SceneAsset& asset, const std::string& pattern) {
  const std::vector<AssetNode>& nodes = asset.tree.nodes;
  const auto name_of = [&](int node) -> const std::string& {
    return nodes[static_cast<std::size_t>(node)].name;
  };
  if (asset.nodes_by_name.empty()) sort_by_name(nodes, asset.nodes_by_name);
  const std::string beginning = pattern.substr(0, pattern.find('*'));
  auto each =
      std::lower_bound(asset.nodes_by_name.begin(), asset.nodes_by_name.end(), beginning,
                       [&](int node, const std::string& name) { return name_of(node) < name; });
  std::vector<int> found;
  for (; each != asset.nodes_by_name.end() && name_of(*each).starts_with(beginning); ++each) {
    if (matches(pattern, name_of(*each))) found.push_back(*each);
  }
  std::sort(found.begin(), found.end());
  NodeRanges ranges;
  for (const int node : found) {
    if (ranges.empty() || node >= ranges.back().end) ranges.push_back(subtree(asset.tree, node));
  }
  return united(std::move(ranges));
}

void drop_unused_meshes(Scene& scene) {
  std::vector<int> new_index(scene.meshes.size(), -1);
  for (const Object& object : scene.objects) {
    for (const PlacedMesh& part : object.parts) new_index[static_cast<std::size_t>(part.mesh)] = 0;
  }
  std::vector<Mesh> kept;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (new_index[i] < 0) continue;
    new_index[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(scene.meshes[i]));
  }
  scene.meshes = std::move(kept);
  for (Object& object : scene.objects) {
    for (PlacedMesh& part : object.parts) {
      part.mesh = new_index[static_cast<std::size_t>(part.mesh)];
    }
  }
}

std::size_t count_parts(const SceneAsset& asset, const NodeRanges& nodes) {
  std::size_t count = 0;
  for (const NodeRange& range : nodes) {
    count +=
        static_cast<std::size_t>(first_part(asset, range.end) - first_part(asset, range.begin));
  }
  return count;
}

std::vector<PlacedMesh> placed_parts(const SceneAsset& asset, const NodeRanges& nodes,
                                     const Mat4& object_from_asset) {
  std::vector<PlacedMesh> parts;
  parts.reserve(count_parts(asset, nodes));
  for (const NodeRange& range : nodes) {
    const auto end = first_part(asset, range.end);
    for (auto part = first_part(asset, range.begin); part != end; ++part) {
      parts.push_back({part->mesh, object_from_asset * part->asset_from_mesh});
    }
  }
  return parts;
}

bool wants_part_names(const Scene& scene) {
  const std::vector<Layer>& layers = scene.output.layers;
  return std::find(layers.begin(), layers.end(), Layer::crypto_object) != layers.end();
}

bool has_many_nodes(const SceneAsset& asset, const NodeRanges& nodes) {
  int first = -1;
  for (const NodeRange& range : nodes) {
    const auto begin = first_part(asset, range.begin), end = first_part(asset, range.end);
    if (begin == end) continue;
    if (first >= 0 || begin->node != std::prev(end)->node) return true;
    first = begin->node;
  }
  return false;
}

void name_parts(const SceneAsset& asset, const NodeRanges& nodes, const std::string& prefix,
                Object& object) {
  const bool many = has_many_nodes(asset, nodes);
  int named = -1;
  auto placed = object.parts.begin();
  for (const NodeRange& range : nodes) {
    const auto end = first_part(asset, range.end);
    for (auto part = first_part(asset, range.begin); part != end; ++part) {
      const AssetNode& node = asset.tree.nodes[static_cast<std::size_t>(part->node)];
      if (!many && node.name.empty()) return;
      if (part->node != named) {
        object.part_names.push_back(prefix + node_name(asset.tree, part->node));
      }
      named = part->node;
      (placed++)->name = static_cast<int>(object.part_names.size()) - 1;
    }
  }
}

}  // namespace restframe
