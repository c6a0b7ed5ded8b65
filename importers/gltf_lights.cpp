#include "importers/gltf_lights.h"

#include <numbers>

namespace restframe {
namespace {

const char* const extension = "KHR_lights_punctual";

// At 555 nm a watt is 683 lumens. glTF gives candela (lm/sr) and lux (lm/m^2); taken as light of
// that wavelength they are W/sr and W/m^2, the convention of Blender's exporter and the Khronos
// samples.
constexpr double lumens_of_a_watt = 683;

// The extension in an element that may have it, or null.
const Json* extension_of(const Json& element) {
  const auto extensions = element.find("extensions");
  if (extensions == element.end()) return nullptr;
  const auto found = extensions->find(extension);
  return found == extensions->end() ? nullptr : &*found;
}

LightKind kind_of(const std::string& type) {
  if (type == "directional") return LightKind::sun;
  return type == "spot" ? LightKind::spot : LightKind::point;
}

Light read_light(const Json& source) {
  Light light;
  light.name = source.value("name", "");
  light.kind = kind_of(source["type"].get<std::string>());
  light.intensity.value = static_cast<float>(source.value("intensity", 1.0) / lumens_of_a_watt);
  if (const auto color = source.find("color"); color != source.end()) {
    for (int i = 0; i < 3; ++i) light.color.value[i] = (*color)[static_cast<std::size_t>(i)];
  }
  if (light.kind != LightKind::spot) return light;
  light.inner_cone = source["spot"].value("innerConeAngle", 0.0);
  light.outer_cone = source["spot"].value("outerConeAngle", std::numbers::pi / 4);
  return light;
}

AssetCamera read_camera(const Json& source) {
  AssetCamera camera;
  camera.name = source.value("name", "");
  camera.is_perspective = source["type"] == "perspective";
  if (camera.is_perspective) camera.vertical_fov = source["perspective"]["yfov"].get<double>();
  return camera;
}

}  // namespace

std::vector<Light> read_gltf_lights(const Json& document) {
  std::vector<Light> lights;
  const Json* punctual = extension_of(document);
  if (punctual == nullptr) return lights;
  for (const Json& light : (*punctual)["lights"]) lights.push_back(read_light(light));
  return lights;
}

std::vector<AssetCamera> read_gltf_cameras(const Json& document) {
  std::vector<AssetCamera> cameras;
  const auto found = document.find("cameras");
  if (found == document.end()) return cameras;
  for (const Json& camera : *found) cameras.push_back(read_camera(camera));
  return cameras;
}

std::vector<int> read_light_indices(const Json& document) {
  std::vector<int> indices;
  const auto nodes = document.find("nodes");
  if (nodes == document.end()) return indices;
  for (const Json& node : *nodes) {
    const Json* punctual = extension_of(node);
    indices.push_back(punctual == nullptr ? -1 : (*punctual)["light"].get<int>());
  }
  return indices;
}

}  // namespace restframe
