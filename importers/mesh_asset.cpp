#include "importers/mesh_asset.h"

#include <fmt/format.h>

#include <algorithm>

#include "importers/complete_normals.h"
#include "importers/orientation.h"
#include "importers/vertex_colors.h"

namespace restframe {
namespace {

struct Mended {
  std::size_t degenerate = 0, turned = 0, normals = 0;
};

void mend(Mesh& mesh, Mended& mended) {
  mended.degenerate += count_degenerate(mesh);
  if (mesh.normals.empty()) mended.turned += orient_outwards(mesh);
  mended.normals += complete_normals(mesh);
  if (mesh.materials.empty()) mesh.materials = {{0, 0}};
  pad_for_embree(mesh);
}

void warn(const Mended& mended, const std::string& file, Warnings& warnings) {
  if (mended.degenerate > 0) {
    warnings.push_back(fmt::format("{}: {} triangles have no area", file, mended.degenerate));
  }
  if (mended.turned > 0) warnings.push_back(turned_over(file, mended.turned));
  if (mended.normals > 0) {
    warnings.push_back(
        fmt::format("{}: {} normals have no direction, computed instead", file, mended.normals));
  }
}

Material default_material(const std::vector<Mesh>& meshes) {
  constexpr float grey = 0.8F;
  Material material;
  material.name = "default";
  material.metallic.value = 0;
  material.double_sided = true;
  const auto is_colored = [](const Mesh& mesh) { return !mesh.colors.empty(); };
  const bool colored = std::any_of(meshes.begin(), meshes.end(), is_colored);
  material.base_color.value = Vec3f(colored ? 1.0F : grey);
  for (const Mesh& mesh : meshes) {
    const bool clear = std::any_of(mesh.colors.begin(), mesh.colors.end(),
                                   [](const Vec4f& color) { return color.a < 1; });
    if (clear) material.alpha_mode = AlphaMode::blend;
  }
  return material;
}

}  // namespace

Asset make_mesh_asset(const Path& path, std::vector<Mesh> meshes, Warnings& warnings) {
  const std::string file = path.string();
  Asset asset;
  asset.name = path.filename().string();
  asset.meshes = std::move(meshes);
  Mended mended;
  for (Mesh& mesh : asset.meshes) {
    if (mesh.name.empty()) mesh.name = path.stem().string();
    if (mend_alpha(mesh.colors)) {
      warnings.push_back(file + ": every colour has alpha 0, taken as 1");
    }
    mend(mesh, mended);
    add_part(asset, static_cast<int>(asset.parts.size()), mesh.name);
  }
  warn(mended, file, warnings);
  asset.materials.push_back(default_material(asset.meshes));
  return asset;
}

}  // namespace restframe
