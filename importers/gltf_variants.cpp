#include "importers/gltf_variants.h"

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

MeshVariant variant_of(const tinygltf::Model& model, const tinygltf::Node& node, bool mirrored) {
  MeshVariant variant;
  variant.mesh = node.mesh;
  variant.skin = node.skin;
  variant.mirrored = mirrored;
  const auto& own = model.meshes[static_cast<std::size_t>(node.mesh)].weights;
  variant.weights = node.weights.empty() ? own : node.weights;
  if (!has_weight(variant.weights)) variant.weights.clear();
  return variant;
}

struct Cost {
  std::size_t triangles = 0, bytes = 0;
};

std::size_t accessor_count(const tinygltf::Model& model, int accessor) {
  return model.accessors[static_cast<std::size_t>(accessor)].count;
}

// What a variant is at most, and the bytes that are read to move its vertices.
Cost cost_of(const tinygltf::Model& model, const MeshVariant& variant) {
  Cost cost;
  for (const tinygltf::Primitive& primitive :
       model.meshes[static_cast<std::size_t>(variant.mesh)].primitives) {
    const std::size_t vertices = accessor_count(model, primitive.attributes.at("POSITION"));
    const std::size_t corners =
        primitive.indices >= 0 ? accessor_count(model, primitive.indices) : vertices;
    const std::size_t triangles = primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners;
    constexpr std::size_t attribute_bytes = 16;
    cost.triangles += triangles;
    cost.bytes +=
        triangles * sizeof(Triangle) + vertices * attribute_bytes * primitive.attributes.size();
    for (std::size_t i = 0; i < variant.weights.size(); ++i) {
      if (variant.weights[i] == 0) continue;
      cost.bytes += vertices * attribute_bytes * primitive.targets[i].size();
    }
  }
  return cost;
}

void check_cost(const GltfContext& context, const tinygltf::Model& model,
                const std::vector<MeshVariant>& variants) {
  Cost total;
  for (const MeshVariant& variant : variants) {
    const Cost cost = cost_of(model, variant);
    total.triangles += cost.triangles;
    total.bytes += cost.bytes;
    const ImportLimits& limits = context.limits;
    const std::string pointer = "/meshes/" + std::to_string(variant.mesh);
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

bool is_posed(const MeshVariant& variant) {
  return variant.skin >= 0 || !variant.weights.empty();
}

}  // namespace

std::vector<MeshVariant> make_variants(const GltfContext& context, tinygltf::Model& model) {
  std::vector<MeshVariant> variants(model.meshes.size());
  for (std::size_t i = 0; i < variants.size(); ++i) variants[i].mesh = static_cast<int>(i);
  std::vector<bool> taken(variants.size(), false);
  bool any_posed = false;
  std::map<Key, int> indices;
  std::vector<Mat4> transforms;
  if (!model.skins.empty()) transforms = asset_from_nodes(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    tinygltf::Node& node = model.nodes[i];
    if (node.mesh < 0) continue;
    const bool mirrored = node.skin >= 0 && glm::determinant(Mat3(transforms[i])) < 0;
    MeshVariant variant = variant_of(model, node, mirrored);
    any_posed |= is_posed(variant);
    const auto mesh = static_cast<std::size_t>(node.mesh);
    const int free = taken[mesh] ? static_cast<int>(variants.size()) : node.mesh;
    const auto [found, is_new] = indices.try_emplace(
        Key{variant.mesh, variant.skin, variant.mirrored, variant.weights}, free);
    node.mesh = found->second;
    if (!is_new) continue;
    taken[mesh] = true;
    variants.resize(std::max(variants.size(), static_cast<std::size_t>(free) + 1));
    variants[static_cast<std::size_t>(free)] = std::move(variant);
  }
  if (any_posed) check_cost(context, model, variants);
  return variants;
}

}  // namespace restframe
