#pragma once

// glTF files compressed by Draco's and meshoptimizer's own encoders.

#include <cstdint>
#include <vector>

#include "support/gltf_builder.h"

namespace restframe::test {

struct DracoSettings {
  bool edgebreaker = true;
  int position_bits = 0;  // 0: floats as they are
};

// A mesh as the tests make it: positions and UVs, three and two numbers a vertex.
struct PlainMesh {
  std::vector<float> positions, uvs;
  std::vector<std::uint32_t> indices;
};

// A bent sheet of columns x rows squares.
PlainMesh bent_sheet(int columns, int rows);

// Draco's bytes: positions are attribute 0, UVs attribute 1.
std::vector<std::uint8_t> draco_bytes(const PlainMesh& mesh, const DracoSettings& settings);

// The mesh as accessors that have no bytes but those of Draco.
GltfBuilder draco_gltf(const PlainMesh& mesh, const std::vector<std::uint8_t>& bytes);

// The mesh uncompressed.
GltfBuilder plain_gltf(const PlainMesh& mesh);

// The mesh in views that meshoptimizer made (positions, UVs, indices), over a buffer 1 without
// bytes.
GltfBuilder meshopt_gltf(const PlainMesh& mesh);

// Adds a view of `stride` bytes an element, `count` of them, that is compressed to `bytes`.
int add_meshopt_view(GltfBuilder& builder, const std::vector<std::uint8_t>& bytes,
                     std::size_t count, std::size_t stride, const char* mode,
                     const char* filter = "NONE");

// What meshopt_encodeVertexBuffer makes of `count` vertices.
std::vector<std::uint8_t> meshopt_vertices(const void* vertices, std::size_t count,
                                           std::size_t stride);

}  // namespace restframe::test
