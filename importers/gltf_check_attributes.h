#pragma once

// Vertex attributes: of types that glTF and its quantization allow, one element a vertex.

#include "importers/gltf_place.h"

namespace restframe {

struct CheckedAttributes {
  std::uint64_t vertices = 0;
  std::uint64_t bytes = 0;     // of what is kept of them
  std::size_t joint_sets = 0;  // four joints a vertex each
};

// The `attributes` of a primitive. `quantized`: KHR_mesh_quantization is in use.
CheckedAttributes check_attributes(const Place& attributes, const Place& document, bool quantized);

// The `targets` of a primitive; returns how many there are.
std::size_t check_morph_targets(const Place& primitive, const Place& document, bool quantized,
                                std::uint64_t vertices);

bool uses_quantization(const Json& document);

}  // namespace restframe
