#include "importers/gltf_mesh.h"

#include "importers/gltf_primitive.h"

namespace restframe {
namespace {

bool is_surface(const tinygltf::Primitive& primitive) {
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

void join(Mesh& mesh, Mesh part, int slot) {
  if (mesh.triangles.empty()) {
    mesh = std::move(part);
    mesh.materials = {{0, slot}};
  } else {
    append(mesh, part, slot);
  }
}

}  // namespace

Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, const PosedMesh& posed,
               Skins& skins, const std::vector<int>& slots) {
  const tinygltf::Mesh& source = model.meshes[static_cast<std::size_t>(posed.mesh)];
  const std::vector<tinygltf::Primitive>& primitives = source.primitives;
  const std::string pointer = "/meshes/" + std::to_string(posed.mesh);
  std::size_t surfaces = 0;
  for (const tinygltf::Primitive& primitive : primitives) surfaces += is_surface(primitive);
  Mesh mesh;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (!is_surface(primitives[i])) continue;
    const PrimitivePlace place{context, pointer + "/primitives/" + std::to_string(i)};
    Mesh part = read_primitive(place, model, primitives[i], posed, skins, surfaces > 1);
    if (!part.triangles.empty()) join(mesh, std::move(part), slots[i]);
  }
  mesh.name = source.name.empty() ? "mesh_" + std::to_string(posed.mesh) : source.name;
  if (surfaces < primitives.size()) {
    context.warn(pointer, std::to_string(primitives.size() - surfaces) +
                              " primitives of points or lines are not renderable, skipped");
  }
  pad_for_embree(mesh);
  return mesh;
}

}  // namespace restframe
