// Whether meshes have the UV sets that the textures of their materials are placed by.

#include <algorithm>
#include <string_view>

#include "importers/gltf_check.h"

namespace restframe {
namespace {

bool is_texture(std::string_view key) {
  constexpr std::string_view end = "Texture";
  return key.size() > end.size() && key.substr(key.size() - end.size()) == end;
}

std::uint64_t set_of(const Json& texture) {
  const auto stated = [](const Json& place, std::uint64_t otherwise) {
    const auto found = place.find("texCoord");
    return found != place.end() && found->is_number_unsigned() ? found->get<std::uint64_t>()
                                                               : otherwise;
  };
  const std::uint64_t own = stated(texture, 0);
  const Json::json_pointer transform("/extensions/KHR_texture_transform");
  if (!texture.contains(transform) || !texture[transform].is_object()) return own;
  return stated(texture[transform], own);
}

// How many UV sets the textures of a material, or of a part of it, need; 0 without textures.
std::uint64_t sets_needed(const Json& material) {
  std::uint64_t sets = 0;
  for (const auto& [key, value] : material.items()) {
    if (!value.is_object()) continue;
    sets = std::max(sets, is_texture(key) ? set_of(value) + 1 : sets_needed(value));
  }
  return sets;
}

}  // namespace

void check_uvs(const Place& document) {
  std::vector<std::uint64_t> needed;
  for_each_object(document, "materials",
                  [&](const Place& material) { needed.push_back(sets_needed(material.value())); });
  std::size_t lacking = 0;
  std::string first;
  for_each_object(document, "meshes", [&](const Place& mesh) {
    for_each_object(mesh, "primitives", [&](const Place& primitive) {
      const std::int64_t material = primitive.index("material", needed.size());
      const std::uint64_t sets = material < 0 ? 0 : needed[static_cast<std::size_t>(material)];
      if (sets == 0) return;
      const std::string name = "TEXCOORD_" + std::to_string(sets - 1);
      if (primitive.value()["attributes"].contains(name)) return;
      if (lacking++ == 0) first = primitive.pointer() + ": has no " + name;
    });
  });
  if (lacking == 0) return;
  const std::size_t colon = first.find(':');
  document.context().warn(first.substr(0, colon),
                          first.substr(colon + 2) +
                              " for its material's textures, (0, 0) is used; " +
                              std::to_string(lacking) + " primitives in all");
}

}  // namespace restframe
