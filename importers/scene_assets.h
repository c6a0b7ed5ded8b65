#pragma once

#include <string>
#include <vector>

#include "scene/asset.h"
#include "scene/scene.h"

namespace restframe {

// What the objects made of one asset share, in the scene's indices.
struct SceneAsset {
  std::string name;                 // of its file, for messages
  std::vector<Part> parts;          // of all the asset's scenes, in the order of their nodes
  std::vector<Material> materials;  // by slot
  AssetTree tree;
  std::vector<int> nodes_by_name;  // the tree's, sorted; made when somebody first looks for a name
  std::vector<std::string> variants;
  std::vector<VariantSlot> variant_slots;
};

// The slots of the asset's meshes: one a material, then those that depend on the variant.
inline int slot_count(const SceneAsset& asset) {
  return static_cast<int>(asset.materials.size() + asset.variant_slots.size());
}

// Which of the asset's materials the slot has in this variant; no_variant: as the asset is.
inline constexpr int no_variant = -1;
int material_of_slot(const SceneAsset& asset, int slot, int variant);

// The asset's variant of that name. Throws InputError if it has none: "the asset has no variant
// ..., the nearest is ...".
int find_variant(const SceneAsset& asset, const std::string& name);

// Moves the asset's meshes, textures and images into the scene.
SceneAsset add_asset(Scene& scene, Asset asset);

// The nodes whose names match the pattern (* stands for anything), with all that is below them.
NodeRanges find_nodes(SceneAsset& asset, const std::string& pattern);

// Removes the meshes that no object places: those of an asset's other scenes or nodes.
void drop_unused_meshes(Scene& scene);

// How many parts placed_parts gives.
std::size_t count_parts(const SceneAsset& asset, const NodeRanges& nodes);

// The parts of an object that holds these nodes, and whose coordinates are object_from_asset times
// the asset's.
std::vector<PlacedMesh> placed_parts(const SceneAsset& asset, const NodeRanges& nodes,
                                     const Mat4& object_from_asset);

// Whether a layer tells parts by their names. Without one, nobody needs them.
bool wants_part_names(const Scene& scene);

// Whether more than one of the nodes has a mesh.
bool has_many_nodes(const SceneAsset& asset, const NodeRanges& nodes);

// Calls the parts of an object, which placed_parts gave for these nodes, by the nodes' names after
// the prefix. A single node without a name leaves them the object's.
void name_parts(const SceneAsset& asset, const NodeRanges& nodes, const std::string& prefix,
                Object& object);

}  // namespace restframe
