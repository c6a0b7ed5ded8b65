#include "fuzz/sound_asset.h"

#include <cmath>
#include <stdexcept>

namespace restframe::fuzz {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("not sound: ") + what);
}

template <class T>
bool is_index(int index, const std::vector<T>& of) {
  return index >= 0 && static_cast<std::size_t>(index) < of.size();
}

template <class T>
bool fits(const std::vector<T>& attribute, const Mesh& mesh) {
  return attribute.empty() || attribute.size() == mesh.positions.size();
}

void require_sound(const Mesh& mesh, const Asset& asset) {
  require(mesh.positions.capacity() > mesh.positions.size(), "room for Embree");
  for (const Vec3f& position : mesh.positions) {
    for (int i = 0; i < 3; ++i) require(std::abs(position[i]) <= largest_coordinate, "position");
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) require(vertex < mesh.positions.size(), "index");
  }
  require(fits(mesh.normals, mesh) && fits(mesh.colors, mesh), "count of an attribute");
  for (const auto& uvs : mesh.uvs) require(fits(uvs, mesh), "count of an attribute");
  require(!mesh.materials.empty() && mesh.materials[0].first_triangle == 0, "material ranges");
  for (const MaterialRange& range : mesh.materials) {
    const std::size_t slots = asset.materials.size() + asset.variant_slots.size();
    require(range.slot >= 0 && static_cast<std::size_t>(range.slot) < slots, "material slot");
  }
}

}  // namespace

void require_sound(const Asset& asset) {
  require(!asset.materials.empty(), "at least one material");
  for (const Part& part : asset.parts) require(is_index(part.mesh, asset.meshes), "mesh of a part");
  for (const Mesh& mesh : asset.meshes) require_sound(mesh, asset);
  for (const Texture& texture : asset.textures) {
    require(is_index(texture.image, asset.images), "image of a texture");
  }
  for (const Material& material : asset.materials) {
    for (const TextureUse& use : {material.base_color_texture, material.metallic_roughness_texture,
                                  material.emission_texture}) {
      require(use.texture < 0 || is_index(use.texture, asset.textures), "texture of a material");
    }
  }
  for (const Image& image : asset.images) {
    require(image.width > 0 && image.height > 0, "size of an image");
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    require(image.rgba.size() == 4 * pixels, "pixels of an image");
  }
}

}  // namespace restframe::fuzz
