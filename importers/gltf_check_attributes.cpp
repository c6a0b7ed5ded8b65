#include "importers/gltf_check_attributes.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "importers/gltf_check.h"
#include "importers/gltf_layout.h"
#include "scene/message.h"

namespace restframe {
namespace {

// A component type that an attribute may have, besides floats.
struct Component {
  std::uint64_t type;
  bool normalized;
  bool quantized = false;  // only with KHR_mesh_quantization
};

struct Semantic {
  std::string_view name;  // one that ends in '_' is followed by a number
  std::span<const char* const> types;
  std::span<const Component> components;
  bool may_be_float = true;
  std::uint64_t bytes = 0;  // of an element as it is kept
};

constexpr auto i8 = component_i8, u8 = component_u8, i16 = component_i16, u16 = component_u16;

constexpr const char* vec2[] = {"VEC2"};
constexpr const char* vec3[] = {"VEC3"};
constexpr const char* vec4[] = {"VEC4"};
constexpr const char* rgb_or_rgba[] = {"VEC3", "VEC4"};

constexpr Component any_integers[] = {{i8, false, true},  {i8, true, true},   {u8, false, true},
                                      {u8, true, true},   {i16, false, true}, {i16, true, true},
                                      {u16, false, true}, {u16, true, true}};
constexpr Component signed_integers[] = {
    {i8, false, true}, {i8, true, true}, {i16, false, true}, {i16, true, true}};
constexpr Component signed_fractions[] = {{i8, true, true}, {i16, true, true}};
constexpr Component fractions[] = {{u8, true}, {u16, true}};
constexpr Component any_fractions[] = {{i8, true}, {i16, true}, {u8, true}, {u16, true}};
constexpr Component uv_integers[] = {{u8, true},        {u16, true},       {i8, false, true},
                                     {i8, true, true},  {u8, false, true}, {i16, false, true},
                                     {i16, true, true}, {u16, false, true}};
constexpr Component counters[] = {{u8, false}, {u16, false}};

// glTF 2.0, 3.7.2.1, and KHR_mesh_quantization.
constexpr Semantic base_semantics[] = {
    {"POSITION", vec3, any_integers, true, 24},  // with the normal that it may get
    {"NORMAL", vec3, signed_fractions, true, 0}, {"TANGENT", vec4, signed_fractions, true, 16},
    {"TEXCOORD_", vec2, uv_integers, true, 8},   {"COLOR_", rgb_or_rgba, fractions, true, 16},
    {"JOINTS_", vec4, counters, false, 16},      {"WEIGHTS_", vec4, fractions, true, 16}};

constexpr Semantic target_semantics[] = {{"POSITION", vec3, signed_integers},
                                         {"NORMAL", vec3, signed_fractions},
                                         {"TANGENT", vec3, signed_fractions},
                                         {"TEXCOORD_", vec2, any_fractions},
                                         {"COLOR_", rgb_or_rgba, any_fractions}};

bool is_numbered(std::string_view name) {
  return name.back() == '_';
}

// Null for those that only the file's author knows, and those that glTF does not have.
const Semantic* semantic_of(std::string_view name, std::span<const Semantic> semantics) {
  for (const Semantic& semantic : semantics) {
    const bool same_start = name.substr(0, semantic.name.size()) == semantic.name;
    if (same_start && (is_numbered(semantic.name) || name == semantic.name)) return &semantic;
  }
  return nullptr;
}

void check_component(const Place& attribute, const Json& accessor, const Semantic& semantic,
                     bool quantized) {
  const auto component = accessor["componentType"].get<std::uint64_t>();
  const bool normalized = accessor.value("normalized", false);
  if (component == component_f32 && semantic.may_be_float) return;
  const auto found = std::find_if(
      semantic.components.begin(), semantic.components.end(), [&](const Component& allowed) {
        return allowed.type == component && allowed.normalized == normalized;
      });
  const bool known = found != semantic.components.end();
  if (known && (quantized || !found->quantized)) return;
  attribute.fault(
      "has componentType " + std::to_string(component) +
      (normalized ? ", normalized" : ", not normalized") +
      (known ? ", which it can have with KHR_mesh_quantization only" : ", which it can not have"));
}

void check_layout(const Place& attribute, const Json& accessor, const Semantic& semantic,
                  bool quantized) {
  const std::string& type = accessor["type"].get_ref<const std::string&>();
  if (std::find(semantic.types.begin(), semantic.types.end(), type) == semantic.types.end()) {
    attribute.fault("has type " + quote(type) + ", which it can not have");
  }
  check_component(attribute, accessor, semantic, quantized);
}

// Every member of `attributes` names an accessor of so many elements.
void check_counts(const Place& attributes, const Place& document, std::uint64_t vertices) {
  for (const auto& [name, value] : attributes.value().items()) {
    const auto count =
        accessor_at(document, value.get<std::int64_t>())["count"].get<std::uint64_t>();
    if (count == vertices) continue;
    attributes.member(name.c_str())
        .fault("has " + std::to_string(count) + " elements, POSITION " + std::to_string(vertices));
  }
}

// How many there are of a numbered attribute; the numbers must run from 0 without a gap.
std::size_t count_sets(const Place& attributes, std::string_view prefix) {
  std::size_t count = 0;
  for (const auto& [name, value] : attributes.value().items()) {
    count += std::string_view(name).substr(0, prefix.size()) == prefix ? 1U : 0U;
  }
  for (std::size_t set = 0; set < count; ++set) {
    const std::string name = std::string(prefix) + std::to_string(set);
    if (attributes.has(name.c_str())) continue;
    attributes.fault("has " + std::to_string(count) + " attributes " + std::string(prefix) +
                     "n, but no " + name);
  }
  return count;
}

void check_semantics(const Place& attributes, const Place& document, bool quantized,
                     std::span<const Semantic> semantics) {
  for (const Semantic& semantic : semantics) {
    if (is_numbered(semantic.name)) count_sets(attributes, semantic.name);
  }
  for (const auto& [name, value] : attributes.value().items()) {
    const Semantic* semantic = semantic_of(name, semantics);
    if (semantic == nullptr) continue;
    const Place attribute = attributes.member(name.c_str());
    check_layout(attribute, accessor_at(document, value.get<std::int64_t>()), *semantic, quantized);
  }
}

void check_indices_of(const Place& attributes, const Place& document) {
  attributes.require_object();
  for (const auto& [name, value] : attributes.value().items()) {
    attributes.index(name.c_str(), count_of(document, "accessors"));
  }
}

}  // namespace

CheckedAttributes check_attributes(const Place& attributes, const Place& document, bool quantized) {
  check_indices_of(attributes, document);
  attributes.require_member("POSITION");
  CheckedAttributes checked;
  checked.vertices =
      accessor_at(document, attributes.value()["POSITION"].get<std::int64_t>())["count"]
          .get<std::uint64_t>();
  check_counts(attributes, document, checked.vertices);
  check_semantics(attributes, document, quantized, base_semantics);
  checked.joint_sets = count_sets(attributes, "JOINTS_");
  if (count_sets(attributes, "WEIGHTS_") != checked.joint_sets) {
    attributes.fault("has " + std::to_string(checked.joint_sets) + " attributes JOINTS_n, but " +
                     std::to_string(count_sets(attributes, "WEIGHTS_")) + " WEIGHTS_n");
  }
  for (const auto& [name, value] : attributes.value().items()) {
    const Semantic* semantic = semantic_of(name, base_semantics);
    if (semantic != nullptr) checked.bytes += checked.vertices * semantic->bytes;
  }
  return checked;
}

std::size_t check_morph_targets(const Place& primitive, const Place& document, bool quantized,
                                std::uint64_t vertices) {
  std::size_t count = 0;
  for_each_object(primitive, "targets", [&](const Place& target) {
    check_indices_of(target, document);
    check_counts(target, document, vertices);
    check_semantics(target, document, quantized, target_semantics);
    for (const auto& [name, value] : target.value().items()) {
      if (semantic_of(name, target_semantics) == nullptr) continue;
      if (primitive.value()["attributes"].contains(name)) continue;
      target.member(name.c_str()).fault("the primitive has no attribute of this name");
    }
    ++count;
  });
  return count;
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

}  // namespace restframe
