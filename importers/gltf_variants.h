#pragma once

// KHR_materials_variants: an asset's looks by name. A primitive says which material it has in each.

#include <tiny_gltf.h>

#include <map>
#include <string>
#include <vector>

#include "importers/gltf_json.h"
#include "scene/asset.h"

namespace restframe {

// The names of the variants of a checked document.
std::vector<std::string> variant_names(const Json& document);

// A primitive's own material, if it has one, and those of its variants; each once.
std::vector<int> possible_materials(const tinygltf::Primitive& primitive);

// The material slots of primitives: the material, or one beyond them all for those whose material
// depends on the variant.
class SlotTable {
 public:
  // Primitives without a material have `default_slot`, the last before those that depend on the
  // variant.
  explicit SlotTable(int default_slot) : default_slot_(default_slot) {}

  // Of each primitive of a mesh.
  std::vector<int> slots_of(const tinygltf::Mesh& mesh);

  // In the order of their slots.
  std::vector<VariantSlot> take() { return std::move(variant_slots_); }

 private:
  int slot_of(const tinygltf::Primitive& primitive);

  int default_slot_;
  std::map<std::pair<int, std::map<int, int>>, int> slots_;
  std::vector<VariantSlot> variant_slots_;
};

}  // namespace restframe
