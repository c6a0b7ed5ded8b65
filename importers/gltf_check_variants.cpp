// KHR_materials_variants: the names of an asset's looks, and the materials of primitives in them.

#include <set>

#include "importers/gltf_check.h"

namespace restframe {
namespace {

constexpr const char* extension_name = "KHR_materials_variants";

// Calls body(extension) if the element has it.
template <class Body>
void with_extension(const Place& element, const Body& body) {
  if (!element.has("extensions")) return;
  const Place extensions = element.member("extensions");
  extensions.require_object();
  if (!extensions.has(extension_name)) return;
  const Place extension = extensions.member(extension_name);
  extension.require_object();
  body(extension);
}

// Returns their number.
std::size_t check_names(const Place& document) {
  std::size_t count = 0;
  with_extension(document, [&](const Place& extension) {
    extension.require_member("variants");
    for_each_object(extension, "variants", [&](const Place& variant) {
      variant.require_member("name");
      variant.check_string("name");
      ++count;
    });
  });
  return count;
}

void check_mapping(const Place& mapping, const Place& document, std::size_t variants,
                   std::set<std::uint64_t>& mapped) {
  mapping.require_member("material");
  mapping.index("material", count_of(document, "materials"));
  mapping.require_member("variants");
  const Place list = mapping.member("variants");
  list.require_array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Place variant = list.element(i);
    if (variants == 0) variant.fault("there are no variants");
    const std::uint64_t index = variant.as_integer(0, variants - 1);
    if (!mapped.insert(index).second) {
      variant.fault("is " + std::to_string(index) +
                    ", which the primitive has a material for already");
    }
  }
}

void check_primitive(const Place& primitive, const Place& document, std::size_t variants) {
  with_extension(primitive, [&](const Place& extension) {
    extension.require_member("mappings");
    std::set<std::uint64_t> mapped;
    for_each_object(extension, "mappings", [&](const Place& mapping) {
      check_mapping(mapping, document, variants, mapped);
    });
  });
}

}  // namespace

void check_variants(const Place& document) {
  const std::size_t variants = check_names(document);
  for_each_object(document, "meshes", [&](const Place& mesh) {
    for_each_object(mesh, "primitives", [&](const Place& primitive) {
      check_primitive(primitive, document, variants);
    });
  });
}

}  // namespace restframe
