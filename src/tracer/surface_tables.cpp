#include "tracer/surface_tables.h"

#include <algorithm>
#include <tuple>

#include "scene/material_properties.h"

namespace restframe {
namespace {

// What of a transform matters to tangents: offsets do not, nor scaling along the axes.
UvTransform direction_of(const UvTransform& t) {
  const bool along_axes = t.along_u.y == 0 && t.along_v.x == 0;
  if (along_axes && t.along_u.x > 0 && t.along_v.y > 0) return {};
  return {t.along_u, t.along_v, {0, 0}};
}

bool is_same(const UvTransform& a, const UvTransform& b) {
  return a.along_u == b.along_u && a.along_v == b.along_v;
}

const TangentTable* find(const std::vector<TangentTable>& tables, const TextureUse& use) {
  const UvTransform transform = direction_of(use.transform);
  for (const TangentTable& table : tables) {
    if (table.uv_set == use.uv_set && is_same(table.transform, transform)) return &table;
  }
  return nullptr;
}

// By textures: colours of materials that are seen through where their alpha is low.
std::vector<bool> seen_through(const Scene& scene) {
  std::vector<bool> result(scene.textures.size(), false);
  for (const Material& material : scene.materials) {
    const int texture = material.base_color_texture.texture;
    if (texture >= 0 && material.alpha_mode != AlphaMode::opaque) {
      result[static_cast<std::size_t>(texture)] = true;
    }
  }
  return result;
}

bool lacks_tangents(const Mesh& mesh) {
  return mesh.tangents.empty() ||
         std::any_of(mesh.tangents.begin(), mesh.tangents.end(),
                     [](const Vec4f& tangent) { return Vec3f(tangent) == Vec3f(0); });
}

}  // namespace

SurfaceTables::SurfaceTables(const Scene& scene) {
  build_chains(scene);
  build_tangents(scene);
}

// Textures that show the same image in the same way share a chain.
void SurfaceTables::build_chains(const Scene& scene) {
  struct Known {
    int image;
    bool has_mips;
    PixelMeaning meaning;
  };
  std::vector<Known> known;
  const std::vector<bool> weighed = seen_through(scene);
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture& texture = scene.textures[i];
    const bool has_mips = texture.mip_filter != MipFilter::none;
    const PixelMeaning meaning{texture.srgb, weighed[i]};
    const auto same = std::find_if(known.begin(), known.end(), [&](const Known& k) {
      return k.has_mips == has_mips &&
             (!has_mips || (k.image == texture.image && k.meaning == meaning));
    });
    chain_of_.push_back(static_cast<int>(same - known.begin()));
    if (same != known.end()) continue;
    known.push_back({texture.image, has_mips, meaning});
    chains_.push_back(has_mips
                          ? MipChain(scene.images[static_cast<std::size_t>(texture.image)], meaning)
                          : MipChain());
  }
}

void SurfaceTables::build_tangents(const Scene& scene) {
  tangents_.resize(scene.meshes.size());
  for (const Object& object : scene.objects) {
    for (const PlacedMesh& part : object.parts) add_tangents(scene, object, part.mesh);
  }
}

// What the normal maps of the object's materials need.
void SurfaceTables::add_tangents(const Scene& scene, const Object& object, int mesh_index) {
  const auto index = static_cast<std::size_t>(mesh_index);
  const Mesh& mesh = scene.meshes[index];
  for (const MaterialRange& range : mesh.materials) {
    const int material = object.materials[static_cast<std::size_t>(range.slot)];
    const Material& m = scene.materials[static_cast<std::size_t>(material)];
    for (const TextureUse& use : {m.normal_texture, m.clearcoat_normal_texture}) {
      if (use.texture >= 0) add_tangents(mesh, use, tangents_[index]);
    }
  }
}

void SurfaceTables::add_tangents(const Mesh& mesh, const TextureUse& use,
                                 std::vector<TangentTable>& tables) {
  if (find(tables, use) != nullptr) return;
  TangentTable table{use.uv_set, direction_of(use.transform), {}};
  if (lacks_tangents(mesh)) table.corners = corner_tangents(mesh, use.uv_set, table.transform);
  tables.push_back(std::move(table));
}

std::span<const CornerTangent> SurfaceTables::tangents(int mesh, const TextureUse& use) const {
  const TangentTable* table = find(tangents_[static_cast<std::size_t>(mesh)], use);
  if (table == nullptr) return {};
  return table->corners;
}

std::size_t SurfaceTables::bytes() const {
  std::size_t sum = 0;
  for (const MipChain& chain : chains_) sum += chain.bytes();
  for (const std::vector<TangentTable>& tables : tangents_) {
    for (const TangentTable& table : tables) sum += table.corners.size() * sizeof(CornerTangent);
  }
  return sum;
}

}  // namespace restframe
