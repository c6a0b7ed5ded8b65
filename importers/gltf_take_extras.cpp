#include "importers/gltf_take_extras.h"

namespace restframe {
namespace {

// The value of `extras.restframe`, which is taken away with all of `extras`; or nothing.
std::optional<Json> take_from(Json& element) {
  const auto extras = element.find("extras");
  if (extras == element.end()) return std::nullopt;
  std::optional<Json> taken;
  if (extras->is_object() && extras->contains("restframe")) {
    taken = std::move((*extras)["restframe"]);
  }
  element.erase(extras);
  return taken;
}

void take_all(Json& holder, const char* key, ExtrasOf of, const std::string& prefix,
              std::vector<AssetExtras>& taken) {
  const auto elements = holder.find(key);
  if (elements == holder.end()) return;
  int index = 0;
  for (Json& element : *elements) {
    if (const std::optional<Json> extras = take_from(element)) {
      const std::string pointer = prefix + "/" + key + "/" + std::to_string(index);
      taken.push_back({of, index, extras->dump(), pointer + "/extras/restframe"});
    }
    ++index;
  }
}

// Blender writes the custom properties of a mesh's data there, which is one step from its object.
void warn_of_meshes(const GltfContext& context, Json& document) {
  std::vector<AssetExtras> unread;
  take_all(document, "meshes", ExtrasOf::node, "", unread);
  for (const AssetExtras& extras : unread) {
    context.warn(extras.place, "is not read: write it to the node that places the mesh");
  }
}

}  // namespace

std::vector<AssetExtras> take_extras(const GltfContext& context, Json& document) {
  std::vector<AssetExtras> taken;
  take_all(document, "scenes", ExtrasOf::scene, "", taken);
  take_all(document, "nodes", ExtrasOf::node, "", taken);
  take_all(document, "materials", ExtrasOf::material, "", taken);
  if (document.contains("extensions") && document["extensions"].contains("KHR_lights_punctual")) {
    take_all(document["extensions"]["KHR_lights_punctual"], "lights", ExtrasOf::light,
             "/extensions/KHR_lights_punctual", taken);
  }
  take_all(document, "cameras", ExtrasOf::camera, "", taken);
  warn_of_meshes(context, document);
  return taken;
}

}  // namespace restframe
