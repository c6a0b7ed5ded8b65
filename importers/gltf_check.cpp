#include "importers/gltf_check.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::array supported_extensions = {
    "KHR_draco_mesh_compression",      "KHR_lights_punctual",        "KHR_materials_clearcoat",
    "KHR_materials_emissive_strength", "KHR_materials_ior",          "KHR_materials_sheen",
    "KHR_materials_specular",          "KHR_materials_transmission", "KHR_materials_unlit",
    "KHR_materials_variants",          "KHR_materials_volume",       "KHR_texture_transform",
    "KHR_mesh_quantization",           "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression"};

struct Version {
  int major = 0, minor = 0;
};

Version read_version(const Place& place) {
  const std::string text = place.as_string();
  Version version;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%3d.%3d%c", &version.major, &version.minor, &rest) != 2) {
    place.fault("is " + quote(text) + ", must be like \"2.0\"");
  }
  return version;
}

// glTF 1.0 was also written with a number, in which case that is the least of its faults.
void check_number_of_version(const Place& version) {
  if (!version.value().is_number() || version.value() == 2) return;
  const Json number = version.value().get<double>();
  version.fault("glTF " + number.dump() + ", only 2.0 can be read");
}

void check_asset(const Place& document) {
  document.require_member("asset");
  const Place asset = document.member("asset");
  asset.require_object();
  asset.require_member("version");
  const Place version = asset.member("version");
  check_number_of_version(version);
  if (read_version(version).major != 2) {
    version.fault("glTF " + version.as_string() + ", only 2.0 can be read");
  }
  if (!asset.has("minVersion")) return;
  const Place least = asset.member("minVersion");
  const Version needed = read_version(least);
  if (needed.major != 2 || needed.minor > 0) {
    least.fault("needs glTF " + least.as_string() + ", only 2.0 can be read");
  }
}

bool is_supported(const std::string& extension) {
  return std::find(supported_extensions.begin(), supported_extensions.end(), extension) !=
         supported_extensions.end();
}

void check_extensions(const Place& document) {
  if (document.has("extensionsRequired")) {
    const Place required = document.member("extensionsRequired");
    required.require_array();
    for (std::size_t i = 0; i < required.size(); ++i) {
      const Place name = required.element(i);
      if (!is_supported(name.as_string())) {
        name.fault("extension " + quote(name.as_string()) + " is required but not supported");
      }
    }
  }
  if (!document.has("extensionsUsed")) return;
  const Place used = document.member("extensionsUsed");
  used.require_array();
  std::set<std::string> warned;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const Place place = used.element(i);
    const std::string name = place.as_string();
    if (is_supported(name) || !warned.insert(name).second) continue;
    document.context().warn(place.pointer(), "extension " + quote(name) + " is left out");
  }
}

// An extension that `known` does not hold: those that extensionsUsed names are warned of already.
void warn_of_undeclared(const Place& element, std::set<std::string>& known) {
  const Place extensions = element.member("extensions");
  extensions.require_object();
  for (const auto& [name, value] : extensions.value().items()) {
    if (is_supported(name) || !known.insert(name).second) continue;
    element.context().warn(extensions.pointer(), "extension " + quote(name) +
                                                     ", which extensionsUsed does not name, is "
                                                     "left out");
  }
}

void check_sections(const Place& document) {
  std::set<std::string> known;
  if (document.has("extensionsUsed")) {
    for (const Json& name : document.value()["extensionsUsed"]) known.insert(name);
  }
  for (const char* key :
       {"accessors", "animations", "buffers", "bufferViews", "cameras", "images", "materials",
        "meshes", "nodes", "samplers", "scenes", "skins", "textures"}) {
    for_each_object(document, key, [&](const Place& element) {
      element.check_string("name");
      if (element.has("extensions")) warn_of_undeclared(element, known);
    });
  }
}

}  // namespace

std::size_t count_of(const Place& document, const char* key) {
  return document.has(key) ? document.member(key).size() : 0;
}

void check_gltf(const GltfContext& context, const Json& json) {
  const Place document(context, json);
  document.require_object();
  check_asset(document);
  check_extensions(document);
  check_sections(document);
  check_buffers(document);
  check_accessors(document);
  check_textures(document);
  check_materials(document);
  check_meshes(document);
  check_variants(document);
  check_nodes(document);
  check_lights(document);
  check_cameras(document);
  check_skins(document);
  check_unread(document);
}

}  // namespace restframe
