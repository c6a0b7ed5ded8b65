#include <fmt/format.h>

#include "importers/importers.h"
#include "importers/obj_material.h"
#include "importers/obj_mesh.h"
#include "importers/obj_parse.h"
#include "scene/error.h"

namespace restframe {

Asset load_obj(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  const ObjData data = parse_obj(path, limits, warnings);
  if (data.groups.size() > limits.nodes) {
    throw InputError(fmt::format("{}: {} groups, at most {} are allowed", path.string(),
                                 data.groups.size(), limits.nodes));
  }
  Asset asset;
  asset.name = path.filename().string();
  const std::vector<int> slots = add_obj_materials(data, path, limits, asset, warnings);
  asset.meshes = build_obj_meshes(data, slots, path.string(), warnings);
  for (std::size_t i = 0; i < asset.meshes.size(); ++i) {
    add_part(asset, static_cast<int>(i), asset.meshes[i].name);
  }
  return asset;
}

}  // namespace restframe
