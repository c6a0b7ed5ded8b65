#include "importers/scene_assets.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

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

}  // namespace

SceneAsset add_asset(Scene& scene, Asset asset) {
  const int first_mesh = static_cast<int>(scene.meshes.size());
  const int first_texture = static_cast<int>(scene.textures.size());
  const int first_image = static_cast<int>(scene.images.size());
  SceneAsset added;
  for (const Part& part : asset.parts) {
    added.parts.push_back({first_mesh + part.mesh, part.asset_from_mesh});
  }
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

std::vector<PlacedMesh> placed_parts(const SceneAsset& asset, const Mat4& object_from_asset) {
  std::vector<PlacedMesh> parts = asset.parts;
  for (PlacedMesh& part : parts) part.object_from_mesh = object_from_asset * part.object_from_mesh;
  return parts;
}

}  // namespace restframe
