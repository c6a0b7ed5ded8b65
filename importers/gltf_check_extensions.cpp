// The KHR_materials_* extensions of a material.

#include "importers/gltf_check.h"

namespace restframe {
namespace {

// Colours and strengths without a bound of their own.
constexpr double brightest = 1e15, longest = 1e30;

void check_ior(const Place& extension) {
  extension.check_number("ior", 0, brightest);
  if (!extension.has("ior")) return;
  const Place ior = extension.member("ior");
  const auto value = ior.value().get<double>();
  if (value > 0 && value < 1) {
    ior.fault("is " + ior.value().dump() + ", must be at least 1, or 0 for a perfect reflector");
  }
}

void check_transmission(const Place& extension, const Place& document) {
  extension.check_number("transmissionFactor", 0, 1);
  check_texture_use(extension, "transmissionTexture", document);
}

void check_volume(const Place& extension, const Place& document) {
  extension.check_number("thicknessFactor", 0, longest);
  extension.check_number("attenuationDistance", 0, longest);
  if (extension.has("attenuationDistance")) {
    const Place distance = extension.member("attenuationDistance");
    if (distance.value().get<double>() == 0) distance.fault("is 0, must be above 0");
  }
  extension.check_numbers("attenuationColor", 3, 0, 1);
  check_texture_use(extension, "thicknessTexture", document);
}

void check_specular(const Place& extension, const Place& document) {
  extension.check_number("specularFactor", 0, 1);
  extension.check_numbers("specularColorFactor", 3, 0, brightest);
  check_texture_use(extension, "specularTexture", document);
  check_texture_use(extension, "specularColorTexture", document);
}

void check_clearcoat(const Place& extension, const Place& document) {
  extension.check_number("clearcoatFactor", 0, 1);
  extension.check_number("clearcoatRoughnessFactor", 0, 1);
  check_texture_use(extension, "clearcoatTexture", document);
  check_texture_use(extension, "clearcoatRoughnessTexture", document);
  check_texture_use(extension, "clearcoatNormalTexture", document);
}

void check_sheen(const Place& extension, const Place& document) {
  extension.check_numbers("sheenColorFactor", 3, 0, 1);
  extension.check_number("sheenRoughnessFactor", 0, 1);
  check_texture_use(extension, "sheenColorTexture", document);
  check_texture_use(extension, "sheenRoughnessTexture", document);
}

}  // namespace

void check_material_extensions(const Place& material, const Place& document) {
  if (!material.has("extensions")) return;
  const Place extensions = material.member("extensions");
  const auto check = [&](const char* name, const auto& body) {
    if (!extensions.has(name)) return;
    const Place extension = extensions.member(name);
    extension.require_object();
    body(extension);
  };
  const auto check_with = [&](const char* name, const auto& body) {
    check(name, [&](const Place& extension) { body(extension, document); });
  };
  check("KHR_materials_unlit", [](const Place&) {});
  check("KHR_materials_emissive_strength",
        [](const Place& emission) { emission.check_number("emissiveStrength", 0, brightest); });
  check("KHR_materials_ior", check_ior);
  check_with("KHR_materials_transmission", check_transmission);
  check_with("KHR_materials_volume", check_volume);
  check_with("KHR_materials_specular", check_specular);
  check_with("KHR_materials_clearcoat", check_clearcoat);
  check_with("KHR_materials_sheen", check_sheen);
}

}  // namespace restframe
