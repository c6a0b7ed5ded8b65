// Texture coordinates that materials ask for and meshes lack.

#include <map>
#include <set>

#include "importers/gltf_material.h"
#include "importers/gltf_variants.h"
#include "scene/material_properties.h"

namespace restframe {
namespace {

// Of the primitives with one material.
struct Users {
  std::size_t count = 0;
  std::map<int, std::size_t> having;  // that set of texture coordinates, how many
};

std::string named(int set) {
  return "TEXCOORD_" + std::to_string(set);
}

void add_user(const tinygltf::Primitive& primitive, Users& users) {
  ++users.count;
  for (int set = 0; primitive.attributes.count(named(set)) > 0; ++set) ++users.having[set];
}

std::map<int, Users> users_of_materials(const tinygltf::Model& model) {
  std::map<int, Users> users;
  for (const tinygltf::Mesh& mesh : model.meshes) {
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      for (const int material : possible_materials(primitive)) {
        add_user(primitive, users[material]);
      }
    }
  }
  return users;
}

}  // namespace

void check_uv_sets(const GltfContext& context, const tinygltf::Model& model, Asset& asset) {
  for (const auto& [index, users] : users_of_materials(model)) {
    Material& material = asset.materials[static_cast<std::size_t>(index)];
    const std::string pointer = "/materials/" + std::to_string(index);
    std::set<int> warned;
    for (const TextureProperty& property : texture_properties) {
      TextureUse& use = material.*property.member;
      if (use.texture < 0) continue;
      const int wanted = use.uv_set;
      const auto found = users.having.find(wanted);
      const std::size_t having = found == users.having.end() ? 0 : found->second;
      if (having == 0) use.uv_set = 0;
      if (having == users.count || !warned.insert(wanted).second) continue;
      const bool replaced = having == 0 && wanted > 0;
      context.warn(pointer, std::to_string(users.count - having) + " of " +
                                std::to_string(users.count) +
                                " primitives of this material have no " + named(wanted) +
                                (replaced ? "; TEXCOORD_0 is used" : "; 0 is used"));
    }
  }
}

}  // namespace restframe
