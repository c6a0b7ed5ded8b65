#include "importers/gltf_posed.h"

#include <map>
#include <tuple>

#include "importers/gltf_node_transform.h"

namespace restframe {
namespace {

using Key = std::tuple<int, int, bool, std::vector<double>>;

bool has_weight(const std::vector<double>& weights) {
  for (const double weight : weights) {
    if (weight != 0) return true;
  }
  return false;
}

PosedMesh posed_by(const tinygltf::Model& model, const tinygltf::Node& node, bool mirrored) {
  PosedMesh posed;
  posed.mesh = node.mesh;
  posed.skin = node.skin;
  posed.mirrored = mirrored;
  const auto& own = model.meshes[static_cast<std::size_t>(node.mesh)].weights;
  posed.weights = node.weights.empty() ? own : node.weights;
  if (!has_weight(posed.weights)) posed.weights.clear();
  return posed;
}

struct Cost {
  std::size_t triangles = 0, bytes = 0;
};

std::size_t accessor_count(const tinygltf::Model& model, int accessor) {
  return model.accessors[static_cast<std::size_t>(accessor)].count;
}

// What it makes at most, and the bytes that are read to move its vertices.
Cost cost_of(const tinygltf::Model& model, const PosedMesh& posed) {
  Cost cost;
  for (const tinygltf::Primitive& primitive :
       model.meshes[static_cast<std::size_t>(posed.mesh)].primitives) {
    const std::size_t vertices = accessor_count(model, primitive.attributes.at("POSITION"));
    const std::size_t corners =
        primitive.indices >= 0 ? accessor_count(model, primitive.indices) : vertices;
    const std::size_t triangles = primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners;
    constexpr std::size_t attribute_bytes = 16;
    cost.triangles += triangles;
    cost.bytes +=
        triangles * sizeof(Triangle) + vertices * attribute_bytes * primitive.attributes.size();
    for (std::size_t i = 0; i < posed.weights.size(); ++i) {
      if (posed.weights[i] == 0) continue;
      cost.bytes += vertices * attribute_bytes * primitive.targets[i].size();
    }
  }
  return cost;
}

void check_cost(const GltfContext& context, const tinygltf::Model& model,
                const std::vector<PosedMesh>& poses) {
  Cost total;
  for (const PosedMesh& posed : poses) {
    const Cost cost = cost_of(model, posed);
    total.triangles += cost.triangles;
    total.bytes += cost.bytes;
    const ImportLimits& limits = context.limits;
    const std::string pointer = "/meshes/" + std::to_string(posed.mesh);
    if (total.triangles > limits.triangles) {
      context.fault(pointer, "posed by nodes: more than " + std::to_string(limits.triangles) +
                                 " triangles in all; --max-triangles raises the limit");
    }
    if (total.bytes > limits.total_bytes) {
      context.fault(pointer, "posed by nodes: more than " + std::to_string(limits.total_bytes) +
                                 " bytes in all; --max-bytes raises the limit");
    }
  }
}

bool is_posed(const PosedMesh& posed) {
  return posed.skin >= 0 || !posed.weights.empty();
}

}  // namespace

std::vector<PosedMesh> pose_meshes(const GltfContext& context, tinygltf::Model& model) {
  std::vector<PosedMesh> poses(model.meshes.size());
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].mesh = static_cast<int>(i);
  std::vector<bool> taken(poses.size(), false);
  bool any_posed = false;
  std::map<Key, int> indices;
  std::vector<Mat4> transforms;
  if (!model.skins.empty()) transforms = asset_from_nodes(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    tinygltf::Node& node = model.nodes[i];
    if (node.mesh < 0) continue;
    const bool mirrored = node.skin >= 0 && glm::determinant(Mat3(transforms[i])) < 0;
    PosedMesh posed = posed_by(model, node, mirrored);
    any_posed |= is_posed(posed);
    const auto mesh = static_cast<std::size_t>(node.mesh);
    const int free = taken[mesh] ? static_cast<int>(poses.size()) : node.mesh;
    const auto [found, is_new] =
        indices.try_emplace(Key{posed.mesh, posed.skin, posed.mirrored, posed.weights}, free);
    node.mesh = found->second;
    if (!is_new) continue;
    taken[mesh] = true;
    poses.resize(std::max(poses.size(), static_cast<std::size_t>(free) + 1));
    poses[static_cast<std::size_t>(free)] = std::move(posed);
  }
  if (any_posed) check_cost(context, model, poses);
  return poses;
}

}  // namespace restframe
