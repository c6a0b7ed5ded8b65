#include <fmt/format.h>

#include "importers/importers.h"
#include "importers/obj_material.h"
#include "importers/obj_mesh.h"
#include "importers/obj_parse.h"
#include "scene/error.h"

namespace restframe {
namespace {

// An object is a node, its groups are nodes below it; without an object, groups are roots.
class NodeMaker {
 public:
  explicit NodeMaker(AssetTree& tree) : tree_(tree) {}

  // The node of a group's faces. Groups of one object come one after the other, the faces that are
  // in none of them first.
  int node_of(const ObjGroup& group) {
    if (group.object_index != object_) {
      object_ = group.object_index;
      object_node_ = group.object.empty() ? -1 : add(group.object, -1, group.object_line);
    }
    if (group.group.empty() && object_node_ >= 0) return object_node_;
    return add(group.group, object_node_, group.group_line);
  }

 private:
  int add(const std::string& name, int parent, int line) {
    AssetNode node;
    node.name = name;
    node.parent = parent;
    node.number = line;
    tree_.nodes.push_back(node);
    return static_cast<int>(tree_.nodes.size()) - 1;
  }

  AssetTree& tree_;
  int object_ = -1, object_node_ = -1;
};

}  // namespace

Asset load_obj(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  ObjData data = parse_obj(path, limits, warnings);
  if (data.groups.size() > limits.nodes) {
    throw InputError(fmt::format("{}: {} groups, at most {} are allowed", path.string(),
                                 data.groups.size(), limits.nodes));
  }
  Asset asset;
  asset.name = path.filename().string();
  const std::vector<int> slots = add_obj_materials(data, path, limits, asset, warnings);
  NodeMaker nodes(asset.tree);
  for (auto& [group, mesh] : build_obj_meshes(data, slots, path.string(), warnings)) {
    const int node = nodes.node_of(data.groups[static_cast<std::size_t>(group)]);
    asset.parts.push_back({static_cast<int>(asset.meshes.size()), node, Mat4(1)});
    asset.meshes.push_back(std::move(mesh));
  }
  return asset;
}

}  // namespace restframe
