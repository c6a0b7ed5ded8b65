#include "tracer/footprint.h"

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
  const double inverse = 1.0 / squared, inverse_length = std::sqrt(inverse);
  const Vec3 sight(met.hits.sight.at(met.lane));
  const double facing = glm::dot(normal, sight);
  const double cosine = std::max(std::abs(facing) * inverse_length, least_cosine);
  const Vec3 leaning = sight - normal * (facing * inverse);
  const double sine = glm::length(leaning);
  const Vec3 along = sine > 1e-6 ? leaning / sine : glm::normalize(edges.second);
  const Vec3 across = glm::cross(normal, along) * inverse_length;

  // A vector of the plane is (v . to_second) edges.second + (v . to_third) edges.third.
  const Vec3 to_second = glm::cross(edges.third, normal) * inverse;
  const Vec3 to_third = glm::cross(normal, edges.second) * inverse;
  const std::vector<Vec2f>& uvs = mesh.uvs[set];
  const Vec2f u2 = uvs[t[1]] - uvs[t[0]], u3 = uvs[t[2]] - uvs[t[0]];
  const Vec2f second = u2.x * use.transform.along_u + u2.y * use.transform.along_v;
  const Vec2f third = u3.x * use.transform.along_u + u3.y * use.transform.along_v;
  const auto on_texture = [&](const Vec3& v, double length) {
    return static_cast<float>(length * glm::dot(v, to_second)) * second +
           static_cast<float>(length * glm::dot(v, to_third)) * third;
  };
  const double width = static_cast<double>(met.width);
  return {on_texture(along, width / cosine), on_texture(across, width)};
}

}  // namespace restframe
