#include "importers/gltf_variants.h"

#include <algorithm>

namespace restframe {
namespace {

constexpr const char* extension_name = "KHR_materials_variants";

// Calls body(material, variant) for all that a primitive maps.
template <class Body>
void for_each_mapping(const tinygltf::Primitive& primitive, const Body& body) {
  const auto extension = primitive.extensions.find(extension_name);
  if (extension == primitive.extensions.end() || !extension->second.Has("mappings")) return;
  const tinygltf::Value& mappings = extension->second.Get("mappings");
  for (std::size_t i = 0; i < mappings.ArrayLen(); ++i) {
    const tinygltf::Value& mapping = mappings.Get(static_cast<int>(i));
    const tinygltf::Value& variants = mapping.Get("variants");
    for (std::size_t k = 0; k < variants.ArrayLen(); ++k) {
      body(mapping.Get("material").GetNumberAsInt(),
           variants.Get(static_cast<int>(k)).GetNumberAsInt());
    }
  }
}

}  // namespace

std::vector<std::string> variant_names(const Json& document) {
  std::vector<std::string> names;
  const Json::json_pointer variants(std::string("/extensions/") + extension_name + "/variants");
  if (!document.contains(variants)) return names;
  for (const Json& variant : document[variants]) {
    names.push_back(variant["name"].get<std::string>());
  }
  return names;
}

std::vector<int> possible_materials(const tinygltf::Primitive& primitive) {
  std::vector<int> materials;
  const auto add = [&](int material) {
    const bool known = std::find(materials.begin(), materials.end(), material) != materials.end();
    if (material >= 0 && !known) materials.push_back(material);
  };
  add(primitive.material);
  for_each_mapping(primitive, [&](int material, int) { add(material); });
  return materials;
}

int SlotTable::slot_of(const tinygltf::Primitive& primitive) {
  const int own = primitive.material >= 0 ? primitive.material : default_slot_;
  std::map<int, int> by_variant;
  for_each_mapping(primitive, [&](int material, int variant) {
    if (material != own) by_variant[variant] = material;
  });
  if (by_variant.empty()) return own;
  const int next = default_slot_ + 1 + static_cast<int>(variant_slots_.size());
  const auto [entry, is_new] = slots_.try_emplace({own, by_variant}, next);
  if (is_new) variant_slots_.push_back({own, std::move(by_variant)});
  return entry->second;
}

std::vector<int> SlotTable::slots_of(const tinygltf::Mesh& mesh) {
  std::vector<int> slots;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    slots.push_back(slot_of(primitive));
  }
  return slots;
}

}  // namespace restframe
