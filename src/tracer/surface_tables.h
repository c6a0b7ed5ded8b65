#pragma once

// What is worked out of a scene before rays are traced, for its textures.

#include <span>
#include <vector>

#include "scene/mip_chain.h"
#include "scene/scene.h"
#include "scene/tangents.h"

namespace restframe {

// Tangents of all of a mesh's corners, for normal textures that are placed in this way.
struct TangentTable {
  int uv_set = 0;
  UvTransform transform;
  std::vector<CornerTangent> corners;
};

class SurfaceTables {
 public:
  explicit SurfaceTables(const Scene& scene);

  bool has_textures() const { return !chain_of_.empty(); }

  // A texture's smaller copies; those that it does not use are not there.
  const MipChain& mips(int texture) const {
    return chains_[static_cast<std::size_t>(chain_of_[static_cast<std::size_t>(texture)])];
  }

  // Three a triangle of the mesh; none where it has no texture coordinates for `use`, or tangents
  // of its own everywhere.
  std::span<const CornerTangent> tangents(int mesh, const TextureUse& use) const;

  std::size_t bytes() const;

 private:
  void build_chains(const Scene& scene);
  void build_tangents(const Scene& scene);
  void add_tangents(const Scene& scene, const Object& object, int mesh_index);
  void add_tangents(const Mesh& mesh, const TextureUse& use, std::vector<TangentTable>& tables);

  std::vector<int> chain_of_;  // a texture each
  std::vector<MipChain> chains_;
  std::vector<std::vector<TangentTable>> tangents_;  // of each mesh
};

}  // namespace restframe
