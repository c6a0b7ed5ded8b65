#include "importers/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "importers/gltf_layout.h"

namespace restframe {
namespace {

// A matrix as it lies in a buffer, column after column.
struct Sixteen {
  std::array<float, 16> numbers{};

  explicit Sixteen(float all) { numbers.fill(all); }
  float& operator[](int i) { return numbers[static_cast<std::size_t>(i)]; }
  static int length() { return 16; }
};

// Equal elements somewhere in a buffer.
struct Run {
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0, count = 0;
  int component_type = 0, components = 0;
  bool normalized = false;
};

Run run_in_view(const tinygltf::Model& model, int view_index, std::size_t offset) {
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
  const tinygltf::Buffer& buffer = model.buffers[static_cast<std::size_t>(view.buffer)];
  Run run;
  run.first = buffer.data.data() + view.byteOffset + offset;
  run.stride = view.byteStride;
  return run;
}

Run run_of(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
  Run run;
  if (accessor.bufferView >= 0) run = run_in_view(model, accessor.bufferView, accessor.byteOffset);
  run.count = accessor.count;
  run.component_type = accessor.componentType;
  run.components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  run.normalized = accessor.normalized;
  if (run.stride == 0) {
    run.stride = static_cast<std::size_t>(run.components) *
                 component_size(static_cast<std::uint64_t>(run.component_type));
  }
  return run;
}

template <class Component>
Component load(const std::uint8_t* bytes) {
  Component value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <class Component>
float convert(Component component, bool normalized) {
  if constexpr (std::is_same_v<Component, float>) {
    return component;
  } else {
    const auto value = static_cast<float>(component);
    if (!normalized) return value;
    // glTF 2.0, 3.11: signed integers have two representations of -1.
    return std::max(value / static_cast<float>(std::numeric_limits<Component>::max()), -1.0F);
  }
}

template <class Component, class Element>
void copy_run(const Run& run, Element* elements) {
  const int components = std::min(run.components, static_cast<int>(Element::length()));
  for (std::size_t i = 0; i < run.count; ++i) {
    const std::uint8_t* bytes = run.first + i * run.stride;
    for (int c = 0; c < components; ++c) {
      const auto component =
          load<Component>(bytes + static_cast<std::size_t>(c) * sizeof(Component));
      elements[i][c] = convert(component, run.normalized);
    }
  }
}

template <class Element>
void copy_elements(const Run& run, Element* elements) {
  if (run.component_type == component_f32 &&
      run.components == static_cast<int>(Element::length()) && run.stride == sizeof(Element)) {
    std::memcpy(static_cast<void*>(elements), run.first, run.count * sizeof(Element));
    return;
  }
  switch (run.component_type) {
    case component_i8:
      return copy_run<std::int8_t>(run, elements);
    case component_u8:
      return copy_run<std::uint8_t>(run, elements);
    case component_i16:
      return copy_run<std::int16_t>(run, elements);
    case component_u16:
      return copy_run<std::uint16_t>(run, elements);
    case component_u32:
      return copy_run<std::uint32_t>(run, elements);
    default:
      return copy_run<float>(run, elements);
  }
}

void copy_integers(const Run& run, std::uint32_t* values) {
  if (run.component_type == component_u32 && run.stride == sizeof(std::uint32_t)) {
    std::memcpy(values, run.first, run.count * sizeof(std::uint32_t));
    return;
  }
  for (std::size_t i = 0; i < run.count; ++i) {
    const std::uint8_t* bytes = run.first + i * run.stride;
    values[i] = run.component_type == component_u8    ? *bytes
                : run.component_type == component_u16 ? load<std::uint16_t>(bytes)
                                                      : load<std::uint32_t>(bytes);
  }
}

// The indices of the elements that a sparse accessor replaces: increasing, and all in range.
std::vector<std::uint32_t> sparse_indices(const GltfContext& context, const tinygltf::Model& model,
                                          int index) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  Run run = run_in_view(model, accessor.sparse.indices.bufferView,
                        static_cast<std::size_t>(accessor.sparse.indices.byteOffset));
  run.count = static_cast<std::size_t>(accessor.sparse.count);
  run.component_type = accessor.sparse.indices.componentType;
  run.stride = component_size(static_cast<std::uint64_t>(run.component_type));
  std::vector<std::uint32_t> indices(run.count);
  copy_integers(run, indices.data());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < accessor.count && (i == 0 || indices[i] > indices[i - 1])) continue;
    context.fault("/accessors/" + std::to_string(index) + "/sparse/indices",
                  "index " + std::to_string(indices[i]) + " at " + std::to_string(i) +
                      (indices[i] < accessor.count
                           ? " is not above the one before"
                           : " is not below the count of " + std::to_string(accessor.count)));
  }
  return indices;
}

// The values that a sparse accessor puts in the places of others.
Run sparse_values(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
  Run run = run_of(model, accessor);
  run.first = run_in_view(model, accessor.sparse.values.bufferView,
                          static_cast<std::size_t>(accessor.sparse.values.byteOffset))
                  .first;
  run.count = static_cast<std::size_t>(accessor.sparse.count);
  run.stride = static_cast<std::size_t>(run.components) *
               component_size(static_cast<std::uint64_t>(run.component_type));
  return run;
}

// Those elements of a run that are wanted, as stretches that lie side by side.
template <class Element>
void copy_wanted(Run run, const Wanted& wanted, Element* elements) {
  if (wanted.elements == nullptr) return copy_elements(run, elements);
  const std::vector<std::uint32_t>& which = *wanted.elements;
  const std::uint8_t* begin = run.first;
  for (std::size_t i = 0; i < which.size(); i += run.count) {
    run.first = begin + which[i] * run.stride;
    run.count = 1;
    while (i + run.count < which.size() && which[i + run.count] == which[i] + run.count) {
      ++run.count;
    }
    copy_elements(run, elements + i);
  }
}

// Puts the values of a sparse accessor in their places.
template <class Element>
void replace_sparse(const GltfContext& context, const tinygltf::Model& model, int index,
                    const Element& missing, const Wanted& wanted, std::vector<Element>& elements) {
  const std::vector<std::uint32_t> replaced = sparse_indices(context, model, index);
  std::vector<Element> values(replaced.size(), missing);
  copy_elements(sparse_values(model, model.accessors[static_cast<std::size_t>(index)]),
                values.data());
  for (std::size_t i = 0; i < replaced.size(); ++i) {
    std::size_t place = replaced[i];
    if (wanted.elements != nullptr) {
      const std::vector<std::uint32_t>& which = *wanted.elements;
      const auto found = std::lower_bound(which.begin(), which.end(), replaced[i]);
      if (found == which.end() || *found != replaced[i]) continue;
      place = static_cast<std::size_t>(found - which.begin());
    }
    elements[place] = values[i];
  }
}

template <class Element>
std::vector<Element> read_elements(const GltfContext& context, const tinygltf::Model& model,
                                   int index, const Element& missing, const Wanted& wanted = {}) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const Run run = run_of(model, accessor);
  const std::size_t count = wanted.elements == nullptr ? run.count : wanted.elements->size();
  std::vector<Element> elements;
  elements.reserve(std::max(count, wanted.room) +
                   1);  // one more for Embree's reads past the last vertex
  elements.resize(count, run.first == nullptr ? Element(0) : missing);
  if (run.first != nullptr) copy_wanted(run, wanted, elements.data());
  if (accessor.sparse.isSparse) replace_sparse(context, model, index, missing, wanted, elements);
  return elements;
}

}  // namespace

std::vector<Vec2f> read_vec2(const GltfContext& context, const tinygltf::Model& model, int accessor,
                             const Wanted& wanted) {
  return read_elements(context, model, accessor, Vec2f(1), wanted);
}

std::vector<Vec3f> read_vec3(const GltfContext& context, const tinygltf::Model& model, int accessor,
                             const Wanted& wanted) {
  return read_elements(context, model, accessor, Vec3f(1), wanted);
}

std::vector<Vec4f> read_vec4(const GltfContext& context, const tinygltf::Model& model, int accessor,
                             const Wanted& wanted) {
  return read_elements(context, model, accessor, Vec4f(1), wanted);
}

std::vector<Mat4> read_mat4(const GltfContext& context, const tinygltf::Model& model,
                            int accessor) {
  std::vector<Mat4> matrices;
  for (Sixteen& source : read_elements(context, model, accessor, Sixteen(1))) {
    Mat4& matrix = matrices.emplace_back();
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = source[i];
  }
  return matrices;
}

void read_indices(const GltfContext& context, const tinygltf::Model& model, int index,
                  std::uint32_t* indices) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const Run run = run_of(model, accessor);
  if (run.first == nullptr) {
    std::fill_n(indices, run.count, 0U);
  } else {
    copy_integers(run, indices);
  }
  if (!accessor.sparse.isSparse) return;
  const std::vector<std::uint32_t> replaced = sparse_indices(context, model, index);
  std::vector<std::uint32_t> values(replaced.size());
  copy_integers(sparse_values(model, accessor), values.data());
  for (std::size_t i = 0; i < replaced.size(); ++i) indices[replaced[i]] = values[i];
}

std::size_t count_indices(const GltfContext& context, const tinygltf::Model& model, int index,
                          std::size_t end) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const Run run = run_of(model, accessor);
  const bool is_plain = run.first != nullptr && !accessor.sparse.isSparse;
  std::vector<std::uint32_t> block(is_plain ? std::min<std::size_t>(run.count, 4096) : run.count);
  std::vector<bool> is_there(end, false);
  for (std::size_t first = 0; first < run.count; first += block.size()) {
    Run part = run;
    part.first += is_plain ? first * run.stride : 0;
    part.count = std::min(block.size(), run.count - first);
    if (is_plain) {
      copy_integers(part, block.data());
    } else {
      read_indices(context, model, index, block.data());
    }
    for (std::size_t i = 0; i < part.count; ++i) {
      if (block[i] < end) is_there[block[i]] = true;
    }
  }
  return static_cast<std::size_t>(std::count(is_there.begin(), is_there.end(), true));
}

}  // namespace restframe
