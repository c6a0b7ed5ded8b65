#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "frames/packet.h"
#include "scene/aligned_vector.h"
#include "scene/mesh.h"

namespace restframe {

// The shading normals at a triangle's corners, side by side in 20 bytes: nine 16-bit numbers, corner by
// corner x, y and z in units of 1/32767: 3e-5 radians off at most. The last half word is 0.
using CornerNormals = std::array<std::uint32_t, 5>;

// What paths ask for of a triangle that they have met: a hit touches one cache line, where going by the
// vertices' indices would touch six.
struct alignas(32) MetTriangle {
  Vec3f corner;  // the first one
  CornerNormals normals;
};

// One a triangle; none if the mesh has no normals. positions: of the mesh's vertices.
AlignedVector<MetTriangle> met_triangles(const Mesh& mesh, std::span<const Vec3f> positions);

// The normals of 16 triangles, word by word.
using CornerNormalLanes = std::array<Lanes<std::uint32_t>, 5>;

// The lower and the upper half of a word, in units of 1/32767.
inline float lower_half(std::uint32_t word) {
  return static_cast<float>(static_cast<std::int32_t>(word << 16U) >> 16);
}
inline float upper_half(std::uint32_t word) {
  return static_cast<float>(static_cast<std::int32_t>(word) >> 16);
}

// The normal in between, of any length. u, v: weights of the second and the third corner.
inline Vec3f interpolated(const CornerNormalLanes& corners, int lane, float u, float v) {
  const std::uint32_t word[] = {corners[0][lane], corners[1][lane], corners[2][lane],
                                corners[3][lane], corners[4][lane]};
  const Vec3f a(lower_half(word[0]), upper_half(word[0]), lower_half(word[1]));
  const Vec3f b(upper_half(word[1]), lower_half(word[2]), upper_half(word[2]));
  const Vec3f c(lower_half(word[3]), upper_half(word[3]), lower_half(word[4]));
  return (1.0F - u - v) * a + u * b + v * c;
}

}  // namespace restframe
