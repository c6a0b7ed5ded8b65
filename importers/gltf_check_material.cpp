// Materials: glTF's own members, and which of all that they have is left out.

#include <array>
#include <string>

#include "importers/gltf_check.h"
#include "scene/message.h"

namespace restframe {
namespace {

// Enough for any asset; tinygltf takes 4 kB for each.
constexpr std::size_t most_materials = 50'000;

void check_alpha(const Place& material) {
  if (material.has("alphaMode")) {
    const Place mode = material.member("alphaMode");
    const std::string name = mode.as_string();
    if (name != "OPAQUE" && name != "MASK" && name != "BLEND") {
      mode.fault("is " + quote(name) + ", must be OPAQUE, MASK or BLEND");
    }
  }
  material.check_number("alphaCutoff", 0, 1e15);
}

void check_material(const Place& material, const Place& document) {
  if (material.has("pbrMetallicRoughness")) {
    const Place pbr = material.member("pbrMetallicRoughness");
    pbr.require_object();
    pbr.check_numbers("baseColorFactor", 4, 0, 1);
    pbr.check_number("metallicFactor", 0, 1);
    pbr.check_number("roughnessFactor", 0, 1);
    check_texture_use(pbr, "baseColorTexture", document);
    check_texture_use(pbr, "metallicRoughnessTexture", document);
  }
  check_texture_use(material, "normalTexture", document);
  check_texture_use(material, "occlusionTexture", document);
  if (material.has("occlusionTexture")) {
    const Place occlusion = material.member("occlusionTexture");
    occlusion.check_number("strength", 0, 1);
  }
  check_texture_use(material, "emissiveTexture", document);
  material.check_numbers("emissiveFactor", 3, 0, 1);
  check_alpha(material);
  material.check_boolean("doubleSided");
  check_material_extensions(material, document);
}

// Something that materials may have: a member, a member of an extension, or an extension.
struct Feature {
  const char* extension;  // nullptr: of the material itself
  const char* key;        // nullptr: the extension as such
  const char* name() const { return key ? key : extension; }
};

bool has(const Place& material, const Feature& feature) {
  if (feature.extension == nullptr) return material.has(feature.key);
  if (!material.has("extensions")) return false;
  const Place extensions = material.member("extensions");
  if (!extensions.has(feature.extension)) return false;
  const Place extension = extensions.member(feature.extension);
  return feature.key == nullptr || extension.has(feature.key);
}

std::size_t count_having(const Place& document, const Feature& feature) {
  std::size_t count = 0;
  for_each_object(document, "materials",
                  [&](const Place& material) { count += has(material, feature); });
  return count;
}

// A path tracer finds out by itself what ambient occlusion stands in for, and a mesh tells how thick
// it is.
void warn_of_left_out(const Place& document) {
  constexpr std::array features = {Feature{nullptr, "occlusionTexture"},
                                   Feature{"KHR_materials_volume", "thicknessTexture"}};
  for (const Feature& feature : features) {
    const std::size_t count = count_having(document, feature);
    if (count == 0) continue;
    document.context().warn("/materials", std::string(feature.name()) + " of " +
                                              std::to_string(count) + " materials is left out");
  }
}

}  // namespace

void check_materials(const Place& document) {
  if (count_of(document, "materials") > most_materials) {
    document.member("materials")
        .fault("has " + std::to_string(count_of(document, "materials")) +
               " elements, the limit is " + std::to_string(most_materials));
  }
  for_each_object(document, "materials",
                  [&](const Place& material) { check_material(material, document); });
  warn_of_left_out(document);
}

}  // namespace restframe
