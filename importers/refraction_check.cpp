#include "importers/refraction_check.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <tuple>

#include "scene/mesh_closed.h"
#include "scene/message.h"

namespace restframe {
namespace {

// A slot of a mesh that shows a material.
using GlassUse = std::tuple<int, int, int>;  // mesh, slot, material

// Where each is used, by the indices of objects.
std::map<GlassUse, std::set<std::size_t>> find_glass(const Scene& scene) {
  std::map<GlassUse, std::set<std::size_t>> uses;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    for (const PlacedMesh& part : object.parts) {
      for (const MaterialRange& range :
           scene.meshes[static_cast<std::size_t>(part.mesh)].materials) {
        const int material = object.materials[static_cast<std::size_t>(range.slot)];
        if (!refracts(scene.materials[static_cast<std::size_t>(material)])) continue;
        uses[{part.mesh, range.slot, material}].insert(i);
      }
    }
  }
  return uses;
}

}  // namespace

void warn_of_open_glass(const Scene& scene, const Path& file, Warnings& warnings) {
  std::map<std::pair<int, int>, bool> closed;
  for (const auto& [use, objects] : find_glass(scene)) {
    const auto& [mesh_index, slot, material] = use;
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(mesh_index)];
    const auto [known, is_new] = closed.try_emplace({mesh_index, slot}, true);
    if (is_new) known->second = is_closed(mesh, slot) || is_closed(mesh);
    if (known->second) continue;
    const std::string more =
        objects.size() > 1 ? fmt::format(" and {} more", objects.size() - 1) : "";
    warnings.push_back(fmt::format(
        "{}: object {}{}: material {} transmits light, but its mesh{} is not closed: light will "
        "not find its way out, refraction needs closed meshes",
        file.string(), quote(scene.objects[*objects.begin()].name), more,
        quote(scene.materials[static_cast<std::size_t>(material)].name),
        mesh.name.empty() ? "" : fmt::format(" {}", quote(mesh.name))));
  }
}

}  // namespace restframe
