#include "importers/gltf_nodes.h"

#include <cmath>

#include "importers/gltf_accessor.h"
#include "importers/gltf_node_transform.h"

namespace restframe {
namespace {

std::vector<int> root_nodes(const tinygltf::Model& model) {
  if (!model.scenes.empty()) {
    const int scene = std::max(model.defaultScene, 0);
    return model.scenes[static_cast<std::size_t>(scene)].nodes;
  }
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

// A walk over the nodes, parents before children, in the file's order.
class Placing {
 public:
  Placing(const GltfContext& context, const tinygltf::Model& model)
      : context_(context), model_(model) {}

  std::vector<Part> all() {
    push(root_nodes(model_), Mat4(1));
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(next.node)];
      const Mat4 asset_from_node = next.asset_from_parent * parent_from_node(node);
      // Joints alone place a skinned mesh (glTF 2.0, 3.7.3.3), wherever its node is.
      if (node.mesh >= 0) place(next.node, node, node.skin >= 0 ? Mat4(1) : asset_from_node);
      push(node.children, asset_from_node);
    }
    if (flat_ > 0) {
      context_.warn("/nodes/" + std::to_string(first_flat_),
                    "flattened by its transform (singular matrix), left out: " +
                        std::to_string(flat_) + " placements of meshes in all");
    }
    return std::move(parts_);
  }

 private:
  struct Waiting {
    int node;
    Mat4 asset_from_parent;
  };

  void push(const std::vector<int>& nodes, const Mat4& asset_from_parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      waiting_.push_back({*node, asset_from_parent});
    }
  }

  void place(int index, const tinygltf::Node& node, const Mat4& asset_from_node) {
    if (node.extensions.count(instancing) == 0) {
      add(index, node, asset_from_node);
      return;
    }
    for (const Mat4& node_from_instance : read_instances(context_, model_, node)) {
      add(index, node, asset_from_node * node_from_instance);
    }
  }

  void add(int index, const tinygltf::Node& node, const Mat4& asset_from_mesh) {
    if (!is_bounded(asset_from_mesh)) {
      context_.fault("/nodes/" + std::to_string(index),
                     "its transform is not finite or beyond 1e15");
    }
    if (is_flat(asset_from_mesh)) {
      if (flat_++ == 0) first_flat_ = index;
      return;
    }
    parts_.push_back({node.mesh, node.name, asset_from_mesh});
  }

  const GltfContext& context_;
  const tinygltf::Model& model_;
  std::vector<Waiting> waiting_;
  std::vector<Part> parts_;
  std::size_t flat_ = 0;
  int first_flat_ = 0;
};

}  // namespace

std::vector<Part> place_meshes(const GltfContext& context, const tinygltf::Model& model) {
  return Placing(context, model).all();
}

}  // namespace restframe
