#include "importers/gltf_nodes.h"

#include <algorithm>
#include <cmath>

#include "importers/gltf_accessor.h"
#include "importers/gltf_node_transform.h"

namespace restframe {
namespace {

std::vector<int> roots_of_all(const tinygltf::Model& model) {
  std::vector<bool> has_parent(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) has_parent[static_cast<std::size_t>(child)] = true;
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < has_parent.size(); ++i) {
    if (!has_parent[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

bool is_bounded(const Mat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    if (!is_within(matrix[column], largest_coordinate)) return false;
  }
  return true;
}

// Whether the matrix makes volumes vanish: its columns are dependent, whatever their lengths.
bool is_flat(const Mat4& matrix) {
  const Vec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
  const double lengths = glm::length(x) * glm::length(y) * glm::length(z);
  return !(std::abs(glm::dot(x, glm::cross(y, z))) > 1e-12 * lengths);
}

const char* const instancing = "EXT_mesh_gpu_instancing";

// node_from_instance of every instance.
std::vector<Mat4> read_instances(const GltfContext& context, const tinygltf::Model& model,
                                 const tinygltf::Node& node) {
  const tinygltf::Value& attributes = node.extensions.at(instancing).Get("attributes");
  const auto accessor = [&](const char* name) {
    return attributes.Has(name) ? attributes.Get(name).GetNumberAsInt() : -1;
  };
  const int translation = accessor("TRANSLATION"), rotation = accessor("ROTATION"),
            scale = accessor("SCALE");
  std::vector<Vec3f> translations, scales;
  std::vector<Vec4f> rotations;
  if (translation >= 0) translations = read_vec3(context, model, translation);
  if (rotation >= 0) rotations = read_vec4(context, model, rotation);
  if (scale >= 0) scales = read_vec3(context, model, scale);
  const std::string any = attributes.Keys().front();
  std::vector<Mat4> matrices(
      model.accessors[static_cast<std::size_t>(accessor(any.c_str()))].count);
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    NodePlacement pose;
    if (translation >= 0) pose.translation = Vec3(translations[i]);
    if (rotation >= 0) {
      pose.rotation = glm::dquat(rotations[i].w, rotations[i].x, rotations[i].y, rotations[i].z);
    }
    if (scale >= 0) pose.scale = Vec3(scales[i]);
    matrices[i] = matrix_of(pose);
  }
  return matrices;
}

// A walk over the nodes of all scenes, parents before children, in the file's order.
class Placing {
 public:
  Placing(const GltfContext& context, const tinygltf::Model& model,
          const std::vector<int>& light_indices, Asset& asset)
      : context_(context),
        model_(model),
        light_indices_(light_indices),
        asset_(asset),
        new_index_(model.nodes.size(), -1) {}

  std::vector<int> all() {
    if (model_.scenes.empty()) walk(roots_of_all(model_));
    for (const tinygltf::Scene& scene : model_.scenes) {
      walk(scene.nodes);
      AssetScene added{scene.name, {}};
      for (const int root : scene.nodes) {
        added.roots.push_back(new_index_[static_cast<std::size_t>(root)]);
      }
      asset_.tree.scenes.push_back(std::move(added));
    }
    asset_.tree.default_scene = std::max(model_.defaultScene, 0);
    if (flat_ > 0) {
      context_.warn("/nodes/" + std::to_string(first_flat_),
                    "flattened by its transform (singular matrix), left out: " +
                        std::to_string(flat_) + " placements of meshes in all");
    }
    return std::move(new_index_);
  }

 private:
  struct Waiting {
    int node, parent;  // the model's index, the tree's
    Mat4 asset_from_parent;
  };

  void walk(const std::vector<int>& roots) {
    push(roots, -1, Mat4(1));
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      int& new_index = new_index_[static_cast<std::size_t>(next.node)];
      if (new_index >= 0) continue;  // a root of two scenes
      new_index = static_cast<int>(asset_.tree.nodes.size());
      const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(next.node)];
      const Mat4 asset_from_node = next.asset_from_parent * parent_from_node(node);
      add_node(next, node, asset_from_node);
      if (node.mesh >= 0) place(node, new_index);
      push(node.children, new_index, asset_from_node);
    }
  }

  void push(const std::vector<int>& nodes, int parent, const Mat4& asset_from_parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      waiting_.push_back({*node, parent, asset_from_parent});
    }
  }

  void add_node(const Waiting& at, const tinygltf::Node& source, const Mat4& asset_from_node) {
    AssetNode node;
    node.name = source.name;
    node.parent = at.parent;
    node.number = at.node;
    node.light = light_indices_[static_cast<std::size_t>(at.node)];
    node.camera = source.camera;
    node.asset_from_node = asset_from_node;
    if (node.light >= 0 || node.camera >= 0) require_bounded(context_, at.node, asset_from_node);
    asset_.tree.nodes.push_back(std::move(node));
  }

  void place(const tinygltf::Node& node, int new_index) {
    // Joints alone place a skinned mesh (glTF 2.0, 3.7.3.3), wherever its node is.
    const Mat4 asset_from_node =
        node.skin >= 0 ? Mat4(1) : asset_.tree.nodes.back().asset_from_node;
    if (node.extensions.count(instancing) == 0) {
      add_part(node, new_index, asset_from_node);
      return;
    }
    for (const Mat4& node_from_instance : read_instances(context_, model_, node)) {
      add_part(node, new_index, asset_from_node * node_from_instance);
    }
  }

  void add_part(const tinygltf::Node& node, int new_index, const Mat4& asset_from_mesh) {
    const int number = asset_.tree.nodes[static_cast<std::size_t>(new_index)].number;
    require_bounded(context_, number, asset_from_mesh);
    if (is_flat(asset_from_mesh)) {
      if (flat_++ == 0) first_flat_ = number;
      return;
    }
    asset_.parts.push_back({node.mesh, new_index, asset_from_mesh});
  }

  const GltfContext& context_;
  const tinygltf::Model& model_;
  const std::vector<int>& light_indices_;
  Asset& asset_;
  std::vector<int> new_index_;  // in the tree, of the model's nodes; -1: in none of its scenes
  std::vector<Waiting> waiting_;
  std::size_t flat_ = 0;
  int first_flat_ = 0;
};

}  // namespace

void require_bounded(const GltfContext& context, int node, const Mat4& asset_from_node) {
  if (is_bounded(asset_from_node)) return;
  context.fault("/nodes/" + std::to_string(node), "its transform is not finite or beyond 1e15");
}

std::vector<int> place_nodes(const GltfContext& context, const tinygltf::Model& model,
                             const std::vector<int>& light_indices, Asset& asset) {
  asset.tree.number_prefix = "/nodes/";
  return Placing(context, model, light_indices, asset).all();
}

}  // namespace restframe
