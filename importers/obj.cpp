#include <fmt/format.h>

#include "importers/importers.h"
#include "importers/obj_material.h"
#include "importers/obj_mesh.h"
#include "importers/obj_parse.h"
#include "scene/error.h"

namespace restframe {

Asset load_obj(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  ObjData data = parse_obj(path, limits, warnings);
  if (data.groups.size() > limits.nodes) {
    throw InputError(fmt::format("{}: {} groups, at most {} are allowed", path.string(),
                                 data.groups.size(), limits.nodes));
  }
  Asset asset;
  asset.name = path.filename().string();
  const std::vector<int> slots = add_obj_materials(data, path, limits, asset, warnings);
  for (auto& [group, mesh] : build_obj_meshes(data, slots, path.string(), warnings)) {
    asset.parts.push_back({static_cast<int>(asset.meshes.size()), mesh.name, Mat4(1)});
    asset.meshes.push_back(std::move(mesh));
  }
  return asset;
}

}  // namespace restframe
