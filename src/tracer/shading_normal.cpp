#include "tracer/shading_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace restframe {
namespace {

// At the hit, in mesh coordinates, to the front. No tangent: 0.
struct TangentFrame {
  Vec3 normal{0}, tangent{0};
  double sign = 1;
};

using Weights = std::array<float, 3>;

Weights weights_of(const MetSurface& met) {
  const float u = met.hits.bary_u[met.lane], v = met.hits.bary_v[met.lane];
  return {1.0F - u - v, u, v};
}

Vec3 normal_at(const Mesh& mesh, const Triangle& t, const Weights& weights) {
  if (mesh.normals.empty()) {
    const Vec3 first(mesh.positions[t[0]]);
    const Vec3 normal =
        glm::cross(Vec3(mesh.positions[t[1]]) - first, Vec3(mesh.positions[t[2]]) - first);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : Vec3(0);
  }
  Vec3f normal(0);
  for (std::size_t i = 0; i < 3; ++i) normal += weights[i] * mesh.normals[t[i]];
  return normal;
}

// The mesh's own where it has one, else as it was generated.
Vec4f tangent_of_corner(const Mesh& mesh, std::uint32_t vertex,
                        std::span<const CornerTangent> generated, std::size_t corner) {
  if (!mesh.tangents.empty() && Vec3f(mesh.tangents[vertex]) != Vec3f(0)) {
    return mesh.tangents[vertex];
  }
  return generated.empty() ? Vec4f(0) : unpacked(generated[corner]);
}

TangentFrame frame_at(const MetSurface& met, const TextureUse& use) {
  const Mesh& mesh = met.mesh();
  const std::uint32_t triangle = met.hits.triangle[met.lane];
  const Triangle& t = mesh.triangles[triangle];
  const Weights weights = weights_of(met);
  TangentFrame frame;
  frame.normal = normal_at(mesh, t, weights);
  if (met.tables == nullptr) return frame;
  const auto generated = met.tables->tangents(met.part().mesh, use);
  Vec4f tangent(0);
  for (std::size_t i = 0; i < 3; ++i) {
    tangent += weights[i] * tangent_of_corner(mesh, t[i], generated, std::size_t{3} * triangle + i);
  }
  frame.tangent = Vec3(Vec3f(tangent));
  frame.sign = tangent.w < 0 ? -1 : 1;
  return frame;
}

// The map's vector, x and y scaled; of any length.
Vec3 mapped(const MetSurface& met, const TextureUse& use, float scale) {
  const Vec3 encoded(Vec3f(texel(met, use)));
  const Vec3 vector = 2.0 * encoded - Vec3(1);
  return {vector.x * static_cast<double>(scale), vector.y * static_cast<double>(scale), vector.z};
}

// Unit, rest frame, towards the side of the triangle that is met; 0 if there is no direction.
Vec3 on_met_side(const MetSurface& met, const Vec3& mesh_normal) {
  const Vec3 rest = glm::dmat3(met.part().rest_from_mesh_normal) * mesh_normal;
  const double length = glm::length(rest);
  if (!(length > 0) || !std::isfinite(length)) return Vec3(0);
  return rest * ((met.surfaces.back[met.lane] != 0 ? -1.0 : 1.0) / length);
}

Vec3 mirrored_to(const Vec3& view, const Vec3& normal) {
  const double cosine = glm::dot(view, normal);
  return cosine < 0 ? normal - 2.0 * cosine * view : normal;
}

// Of the lane, as `use` tilts it; 0 if it does not.
Vec3f tilted(const MetSurface& met, const TextureUse& use, float scale) {
  const TangentFrame frame = frame_at(met, use);
  if (frame.tangent == Vec3(0)) return Vec3f(0);
  const Vec3 map = mapped(met, use, scale);
  const Vec3 bitangent = frame.sign * glm::cross(frame.normal, frame.tangent);
  const Vec3 normal =
      on_met_side(met, map.x * frame.tangent + map.y * bitangent + map.z * frame.normal);
  return Vec3f(mirrored_to(-Vec3(met.hits.sight.at(met.lane)), normal));
}

// As surfaces_at has it, before it was tilted.
Vec3f untilted(const MetSurface& met) {
  if (!has_normal_map(met.material())) return met.surfaces.normal.at(met.lane);
  const Mesh& mesh = met.mesh();
  const Vec3 normal = on_met_side(
      met, normal_at(mesh, mesh.triangles[met.hits.triangle[met.lane]], weights_of(met)));
  const Vec3f sight = met.hits.sight.at(met.lane);
  if (normal == Vec3(0)) return -sight;
  return Vec3f(glm::dot(normal, Vec3(sight)) > 0 ? -normal : normal);
}

}  // namespace

void tilt_normal(const MetSurface& met, double clock, TemporalEvaluator& evaluator,
                 SurfaceLanes& surfaces) {
  const Material& material = met.material();
  const Vec3f normal =
      tilted(met, material.normal_texture, evaluator(material.normal_scale, clock));
  if (normal == Vec3f(0)) return;
  surfaces.normal.set(met.lane, normal);
  surfaces.cosine[met.lane] = std::max(0.0F, -glm::dot(normal, met.hits.sight.at(met.lane)));
}

Vec3f clearcoat_normal(const MetSurface& met) {
  const Material& material = met.material();
  if (material.clearcoat_normal_texture.texture < 0) return untilted(met);
  const Vec3f normal =
      tilted(met, material.clearcoat_normal_texture, material.clearcoat_normal_scale);
  return normal == Vec3f(0) ? untilted(met) : normal;
}

// The mirror image is raised until it is above the triangle; the normal is halfway between it and
// the view (Keller and others 2017, "The Iray Light Transport Simulation and Rendering System").
Vec3f reflecting_normal(const Vec3f& view, const Vec3f& facet, const Vec3f& normal) {
  constexpr float least_height = 0.01F;
  const Vec3f image = 2.0F * glm::dot(view, normal) * normal - view;
  const float height = glm::dot(image, facet);
  const float wanted = std::min(least_height, 0.9F * glm::dot(view, facet));
  if (!(height < wanted)) return normal;
  const Vec3f raised = glm::normalize(image + (wanted - height) * facet);
  const Vec3f half = view + raised;
  const float squared = glm::dot(half, half);
  return squared > 1e-12F ? half / std::sqrt(squared) : facet;
}

}  // namespace restframe
