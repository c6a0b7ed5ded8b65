// Meshes: accessors of the right kind, as many elements as there are vertices, and not too much in
// all.

#include <initializer_list>

#include "importers/gltf_check.h"
#include "importers/gltf_layout.h"

namespace restframe {
namespace {

std::uint64_t accessor_count(const Json& accessor) {
  return accessor["count"].get<std::uint64_t>();
}

// What an attribute may be made of: types, and component types with whether they must be
// normalized.
struct Layout {
  std::initializer_list<const char*> types;
  std::initializer_list<std::uint64_t> normalized;  // besides float
  std::initializer_list<std::uint64_t> quantized;   // with KHR_mesh_quantization, normalized or not
};

bool contains(std::initializer_list<std::uint64_t> list, std::uint64_t value) {
  for (const std::uint64_t each : list) {
    if (each == value) return true;
  }
  return false;
}

bool uses_quantization(const Json& document) {
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    if (!document.contains(key)) continue;
    for (const Json& name : document[key]) {
      if (name == "KHR_mesh_quantization") return true;
    }
  }
  return false;
}

void check_layout(const Place& attribute, const Json& accessor, const Layout& layout,
                  bool quantized) {
  bool type_fits = false;
  for (const char* type : layout.types) type_fits |= accessor["type"] == type;
  if (!type_fits)
    attribute.fault("has type " + accessor["type"].dump() + ", which it can not have");
  const auto component = accessor["componentType"].get<std::uint64_t>();
  const bool normalized = accessor.value("normalized", false);
  if (component == component_f32 || (normalized && contains(layout.normalized, component)) ||
      (quantized && contains(layout.quantized, component))) {
    return;
  }
  attribute.fault("has componentType " + std::to_string(component) +
                  (normalized ? ", normalized" : ", not normalized") + ", which it can not have");
}

void check_attribute(const Place& attributes, const char* name, const Layout& layout,
                     const Place& document, bool quantized) {
  if (!attributes.has(name)) return;
  const Place attribute = attributes.member(name);
  check_layout(attribute, accessor_at(document, attribute.value().get<std::int64_t>()), layout,
               quantized);
}

// The number of vertices.
std::uint64_t check_attributes(const Place& attributes, const Place& document, bool quantized) {
  attributes.require_object();
  for (const auto& [name, value] : attributes.value().items()) {
    attributes.index(name.c_str(), count_of(document, "accessors"));
  }
  attributes.require_member("POSITION");
  const std::uint64_t vertices =
      accessor_count(accessor_at(document, attributes.value()["POSITION"].get<std::int64_t>()));
  for (const auto& [name, value] : attributes.value().items()) {
    const std::uint64_t count = accessor_count(accessor_at(document, value.get<std::int64_t>()));
    if (count == vertices) continue;
    attributes.member(name.c_str())
        .fault("has " + std::to_string(count) + " elements, POSITION " + std::to_string(vertices));
  }
  constexpr auto i8 = component_i8, u8 = component_u8, i16 = component_i16, u16 = component_u16;
  check_attribute(attributes, "POSITION", {{"VEC3"}, {}, {i8, u8, i16, u16}}, document, quantized);
  check_attribute(attributes, "NORMAL", {{"VEC3"}, {}, {i8, i16}}, document, quantized);
  for (const char* name : {"TEXCOORD_0", "TEXCOORD_1"}) {
    check_attribute(attributes, name, {{"VEC2"}, {u8, u16}, {i8, u8, i16, u16}}, document,
                    quantized);
  }
  check_attribute(attributes, "COLOR_0", {{"VEC3", "VEC4"}, {u8, u16}, {}}, document, quantized);
  return vertices;
}

std::uint64_t check_indices(const Place& primitive, const Place& document) {
  const std::int64_t index = primitive.index("indices", count_of(document, "accessors"));
  const Json& accessor = accessor_at(document, index);
  const auto component = accessor["componentType"].get<std::uint64_t>();
  if (accessor["type"] != "SCALAR" || accessor.value("normalized", false) ||
      !(component == component_u8 || component == component_u16 || component == component_u32)) {
    primitive.member("indices").fault(
        "must be scalars of componentType 5121, 5123 or 5125, not normalized");
  }
  return accessor_count(accessor);
}

struct Totals {
  std::uint64_t triangles = 0, bytes = 0;
};

void check_primitive(const Place& primitive, const Place& document, bool quantized,
                     Totals& totals) {
  primitive.require_member("attributes");
  const Place attributes = primitive.member("attributes");
  const std::uint64_t vertices = check_attributes(attributes, document, quantized);
  const std::uint64_t corners =
      primitive.has("indices") ? check_indices(primitive, document) : vertices;
  const std::uint64_t mode = primitive.integer("mode", 0, 6, 4);
  primitive.index("material", count_of(document, "materials"));
  if (primitive.has("extensions")) primitive.member("extensions").require_object();

  const std::uint64_t triangles = mode == 4 ? corners / 3 : mode > 4 ? corners : 0;
  totals.triangles += triangles;
  totals.bytes += triangles * sizeof(Triangle) + vertices * (sizeof(Vec3f) + sizeof(Vec3f));
  const ImportLimits& limits = document.context().limits;
  if (totals.triangles > limits.triangles) {
    primitive.fault("more than " + std::to_string(limits.triangles) +
                    " triangles in all; --max-triangles raises the limit");
  }
  if (totals.bytes > limits.total_bytes) {
    primitive.fault("geometry of more than " + std::to_string(limits.total_bytes) +
                    " bytes in all; --max-bytes raises the limit");
  }
}

}  // namespace

void check_meshes(const Place& document) {
  const bool quantized = uses_quantization(document.value());
  Totals totals;
  bool morphs = false;
  for_each_object(document, "meshes", [&](const Place& mesh) {
    mesh.require_member("primitives");
    for_each_object(mesh, "primitives", [&](const Place& primitive) {
      check_primitive(primitive, document, quantized, totals);
      morphs |= primitive.has("targets");
    });
  });
  if (morphs)
    document.context().warn("/meshes", "morph targets are left out: read in its rest pose");
}

}  // namespace restframe
