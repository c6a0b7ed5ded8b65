#include "importers/gltf_mesh.h"

#include "importers/gltf_primitive.h"
#include "scene/mesh_append.h"

namespace restframe {
namespace {

// The first part becomes the mesh, with room for the whole: the others are appended in place.
void join(Mesh& mesh, Mesh part, int slot, WholeMesh& whole) {
  if (mesh.triangles.empty()) {
    mesh = std::move(part);
    mesh.positions.reserve(whole.vertices + 1);
    whole.vertices = whole.triangles = 0;  // further parts need no room but their own
    mesh.materials = {{0, slot}};
  } else {
    append_and_free(mesh, std::move(part), slot);
  }
}

}  // namespace

Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, const PosedMesh& posed,
               Skins& skins, const std::vector<int>& slots) {
  const tinygltf::Mesh& source = model.meshes[static_cast<std::size_t>(posed.mesh)];
  const std::vector<tinygltf::Primitive>& primitives = source.primitives;
  const std::string pointer = "/meshes/" + std::to_string(posed.mesh);
  WholeMesh whole = whole_of(context, model, source);
  std::size_t surfaces = 0;
  Mesh mesh;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (!is_surface(primitives[i])) continue;
    ++surfaces;
    const PrimitivePlace place{context, pointer + "/primitives/" + std::to_string(i)};
    Mesh part = read_primitive(place, model, primitives[i], posed, skins, whole);
    if (!part.triangles.empty()) join(mesh, std::move(part), slots[i], whole);
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
