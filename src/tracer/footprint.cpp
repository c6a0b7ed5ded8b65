#include "tracer/footprint.h"

#include <array>
#include <cmath>

namespace restframe {
namespace {

// Seen flatter than this, a footprint is cut off: it is far longer than what its samples reach.
constexpr double least_cosine = 1e-4;

struct Edges {
  Vec3 second, third;  // from the first corner to the others, rest-frame axes
};

Edges edges_of(const FramePart& part, const Mesh& mesh, const Triangle& t) {
  const Mat3 rest_from_mesh(part.rest_from_mesh);
  const Vec3 first(mesh.positions[t[0]]);
  return {rest_from_mesh * (Vec3(mesh.positions[t[1]]) - first),
          rest_from_mesh * (Vec3(mesh.positions[t[2]]) - first)};
}

}  // namespace

TextureFootprint footprint(const MetSurface& met, const TextureUse& use) {
  const FramePart& part = met.part();
  const Mesh& mesh = met.mesh();
  const auto set = static_cast<std::size_t>(use.uv_set);
  if (!(met.width > 0) || set >= mesh.uvs.size() || mesh.uvs[set].empty()) return {};
  const Triangle& t = part.triangles[met.hits.triangle[met.lane]];
  const Edges edges = edges_of(part, mesh, t);
  const Vec3 normal = glm::cross(edges.second, edges.third);
  const double squared = glm::dot(normal, normal);
  if (!(squared > 0)) return {};

  // Two vectors of the width's length in the plane: across the ray, and along what it leans to.
  const Vec3 sight(met.hits.sight.at(met.lane));
  const Vec3 unit_normal = normal / std::sqrt(squared);
  const double cosine = std::max(std::abs(glm::dot(unit_normal, sight)), least_cosine);
  const Vec3 leaning = sight - unit_normal * glm::dot(unit_normal, sight);
  const double sine = glm::length(leaning);
  const Vec3 along = sine > 1e-6 ? leaning / sine : glm::normalize(edges.second);
  const double width = static_cast<double>(met.width);

  // A vector v of the plane is a edges.second + b edges.third.
  const std::vector<Vec2f>& uvs = mesh.uvs[set];
  const Vec2f u2 = uvs[t[1]] - uvs[t[0]], u3 = uvs[t[2]] - uvs[t[0]];
  const Vec2f second = u2.x * use.transform.along_u + u2.y * use.transform.along_v;
  const Vec2f third = u3.x * use.transform.along_u + u3.y * use.transform.along_v;
  const auto on_texture = [&](const Vec3& v) {
    const double a = glm::dot(glm::cross(v, edges.third), normal) / squared;
    const double b = glm::dot(glm::cross(edges.second, v), normal) / squared;
    return static_cast<float>(a) * second + static_cast<float>(b) * third;
  };
  return {on_texture(along * (width / cosine)), on_texture(glm::cross(unit_normal, along) * width)};
}

}  // namespace restframe
