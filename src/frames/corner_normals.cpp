#include "frames/corner_normals.h"

#include <algorithm>
#include <cmath>

#include "scene/parallel.h"

namespace restframe {
namespace {

std::uint32_t sixteen_bits(float component) {
  const float scaled = std::round(std::clamp(component, -1.0F, 1.0F) * 32767.0F);
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled)) & 0xffffU;
}

std::uint32_t packed(float lower, float upper) {
  return sixteen_bits(lower) | sixteen_bits(upper) << 16U;
}

CornerNormals packed(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  return {packed(a.x, a.y), packed(a.z, b.x), packed(b.y, b.z), packed(c.x, c.y),
          packed(c.z, 0.0F)};
}

}  // namespace

AlignedVector<MetTriangle> met_triangles(const Mesh& mesh, std::span<const Vec3f> positions) {
  AlignedVector<MetTriangle> result;
  if (mesh.normals.empty()) return result;
  result.resize(mesh.triangles.size());
  constexpr std::size_t at_once = 65536;
  parallel_for((result.size() + at_once - 1) / at_once, [&](std::size_t part) {
    const std::size_t end = std::min(result.size(), (part + 1) * at_once);
    for (std::size_t i = part * at_once; i < end; ++i) {
      const Triangle& t = mesh.triangles[i];
      result[i] = {positions[t[0]],
                   packed(mesh.normals[t[0]], mesh.normals[t[1]], mesh.normals[t[2]])};
    }
  });
  return result;
}

}  // namespace restframe
