// Materials, textures, samplers and images.

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "importers/gltf_check.h"
#include "scene/message.h"

namespace restframe {
namespace {

// Enough for any asset; tinygltf takes 4 kB for each.
constexpr std::size_t most_materials = 50'000;

void check_one_of(const Place& place, const char* key,
                  std::initializer_list<std::uint64_t> allowed) {
  if (!place.has(key)) return;
  const Place member = place.member(key);
  const std::uint64_t value = member.as_integer(0, 0xFFFF);
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
    member.fault("is " + std::to_string(value) + ", not one of glTF's");
  }
}

void check_texture_use(const Place& place, const char* key, const Place& document) {
  if (!place.has(key)) return;
  const Place use = place.member(key);
  use.require_object();
  use.require_member("index");
  use.index("index", count_of(document, "textures"));
  use.integer("texCoord", 0, 1000, 0);
}

void check_glass_textures(const Place& extension, const Place& document) {
  for (const char* key : {"transmissionTexture", "thicknessTexture"}) {
    check_texture_use(extension, key, document);
  }
}

void check_material_extensions(const Place& material, const Place& document) {
  if (!material.has("extensions")) return;
  const Place extensions = material.member("extensions");
  const auto check = [&](const char* name, const auto& body) {
    if (!extensions.has(name)) return;
    const Place extension = extensions.member(name);
    extension.require_object();
    body(extension);
  };
  check("KHR_materials_unlit", [](const Place&) {});
  check("KHR_materials_emissive_strength",
        [](const Place& emission) { emission.check_number("emissiveStrength", 0, 1e15); });
  check("KHR_materials_ior", [](const Place& ior) { ior.check_number("ior", 0, 1e15); });
  check("KHR_materials_transmission", [&](const Place& transmission) {
    transmission.check_number("transmissionFactor", 0, 1);
    check_glass_textures(transmission, document);
  });
  check("KHR_materials_volume", [&](const Place& volume) {
    volume.check_number("thicknessFactor", 0, 1e30);
    volume.check_number("attenuationDistance", 0, 1e30);
    volume.check_numbers("attenuationColor", 3, 0, 1);
    check_glass_textures(volume, document);
  });
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
  for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
    check_texture_use(material, key, document);
  }
  material.check_numbers("emissiveFactor", 3, 0, 1);
  if (material.has("alphaMode")) {
    const Place mode = material.member("alphaMode");
    const std::string name = mode.as_string();
    if (name != "OPAQUE" && name != "MASK" && name != "BLEND") {
      mode.fault("is " + quote(name) + ", must be OPAQUE, MASK or BLEND");
    }
  }
  material.check_number("alphaCutoff", 0, 1e15);
  material.check_boolean("doubleSided");
  check_material_extensions(material, document);
}

void check_image(const Place& image, const Place& document) {
  if (image.has("uri") == image.has("bufferView")) {
    image.fault("must have either a uri or a bufferView");
  }
  image.check_string("uri");
  image.check_string("mimeType");
  image.index("bufferView", count_of(document, "bufferViews"));
}

void check_sampler(const Place& sampler) {
  constexpr std::uint64_t nearest = 9728, linear = 9729, clamp = 33071, mirrored = 33648,
                          repeat = 10497;
  check_one_of(sampler, "magFilter", {nearest, linear});
  check_one_of(sampler, "minFilter", {nearest, linear, 9984, 9985, 9986, 9987});
  check_one_of(sampler, "wrapS", {clamp, mirrored, repeat});
  check_one_of(sampler, "wrapT", {clamp, mirrored, repeat});
}

void warn_of_maps(const Place& document, const char* map, std::size_t count) {
  if (count == 0) return;
  document.context().warn(
      "/materials", std::string(map) + " of " + std::to_string(count) + " materials is left out");
}

void warn_of_unused_maps(const Place& document) {
  for (const char* key : {"normalTexture", "occlusionTexture"}) {
    std::size_t count = 0;
    for_each_object(document, "materials",
                    [&](const Place& material) { count += material.has(key); });
    warn_of_maps(document, key, count);
  }
  using Map = std::pair<const char*, const char*>;
  for (const auto& [extension, key] : {Map{"KHR_materials_transmission", "transmissionTexture"},
                                       Map{"KHR_materials_volume", "thicknessTexture"}}) {
    std::size_t count = 0;
    for_each_object(document, "materials", [&, name = extension, map = key](const Place& material) {
      if (!material.has("extensions")) return;
      const Place extensions = material.member("extensions");
      count += extensions.has(name) && extensions.member(name).has(map);
    });
    warn_of_maps(document, key, count);
  }
}

}  // namespace

void check_materials(const Place& document) {
  if (count_of(document, "materials") > most_materials) {
    document.member("materials")
        .fault("has " + std::to_string(count_of(document, "materials")) +
               " elements, the limit is " + std::to_string(most_materials));
  }
  for_each_object(document, "images", [&](const Place& image) { check_image(image, document); });
  for_each_object(document, "samplers", check_sampler);
  for_each_object(document, "textures", [&](const Place& texture) {
    texture.index("source", count_of(document, "images"));
    texture.index("sampler", count_of(document, "samplers"));
  });
  for_each_object(document, "materials",
                  [&](const Place& material) { check_material(material, document); });
  warn_of_unused_maps(document);
}

}  // namespace restframe
