#include "importers/gltf_accessor.h"
#include "importers/gltf_pose.h"

namespace restframe {
namespace {

using Target = std::map<std::string, int>;

// The accessor of an attribute that both the mesh and the target have, or -1.
template <class Element>
int difference(const Target& target, const std::string& name, const std::vector<Element>& values) {
  const auto found = target.find(name);
  return values.empty() || found == target.end() ? -1 : found->second;
}

template <class Element, class Difference>
void add(const std::vector<Difference>& differences, float weight, std::vector<Element>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int c = 0; c < Difference::length(); ++c) values[i][c] += weight * differences[i][c];
  }
}

void add_target(const GltfContext& context, const tinygltf::Model& model, const Target& target,
                float weight, Mesh& mesh) {
  const auto add_vec3 = [&](const char* name, auto& values) {
    const int accessor = difference(target, name, values);
    if (accessor >= 0) add(read_vec3(context, model, accessor), weight, values);
  };
  add_vec3("POSITION", mesh.positions);
  add_vec3("NORMAL", mesh.normals);
  add_vec3("TANGENT", mesh.tangents);
  for (std::size_t set = 0; set < mesh.uvs.size(); ++set) {
    const int accessor = difference(target, "TEXCOORD_" + std::to_string(set), mesh.uvs[set]);
    if (accessor >= 0) add(read_vec2(context, model, accessor), weight, mesh.uvs[set]);
  }
  const int colors = difference(target, "COLOR_0", mesh.colors);
  if (colors < 0) return;
  if (model.accessors[static_cast<std::size_t>(colors)].type == TINYGLTF_TYPE_VEC3) {
    add(read_vec3(context, model, colors), weight, mesh.colors);
  } else {
    add(read_vec4(context, model, colors), weight, mesh.colors);
  }
}

}  // namespace

void add_targets(const PrimitivePlace& place, const tinygltf::Model& model,
                 const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                 Mesh& mesh) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    add_target(place.context, model, primitive.targets[i], static_cast<float>(weights[i]), mesh);
  }
}

}  // namespace restframe
