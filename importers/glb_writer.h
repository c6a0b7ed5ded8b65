#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/material.h"
#include "scene/mesh.h"

namespace restframe {

// Collects a binary glTF 2.0 file: one scene with one root node, under which all others are.
// Vertices, triangles and translations are referred to, not copied: they must stay as they are
// until write().
class GlbWriter {
 public:
  explicit GlbWriter(const std::string& root_name);

  // Constant base colour, metallic, roughness, sidedness. Returns its index, as the next ones do.
  int add_material(const Material& material);

  // Positions, normals, triangles: one primitive a material range, slots being indices of
  // materials.
  int add_mesh(const Mesh& mesh);

  // A mesh, turned by a rotation, then moved.
  void add_node(const std::string& name, int mesh, const Mat3& rotation, const Vec3& translation);

  // A mesh at many places (EXT_mesh_gpu_instancing), which `rotation` turns as a whole.
  void add_instances(const std::string& name, int mesh, const Mat3& rotation,
                     const std::vector<Vec3f>& translations);

  // Throws OutputError.
  void write(const std::filesystem::path& path);

 private:
  using Json = nlohmann::ordered_json;

  std::size_t add_view(std::span<const std::byte> bytes, int target);
  std::size_t add_vectors(std::span<const Vec3f> vectors, int target, bool bounds);
  std::size_t add_indices(std::span<const Triangle> triangles);
  Json primitive(const Mesh& mesh, std::size_t range);
  Json& add_placed(const std::string& name, const Mat3& rotation);

  Json json_;
  std::vector<std::span<const std::byte>> blocks_;  // of the binary chunk, each of whole 4 bytes
  std::uint64_t binary_size_ = 0;
  std::list<std::vector<Triangle>> rebased_;  // triangles that had to be copied
};

}  // namespace restframe
