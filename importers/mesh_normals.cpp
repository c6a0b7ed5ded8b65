#include <glm/gtc/constants.hpp>

#include <cmath>

#include "importers/crease_sectors.h"
#include "importers/importers.h"
#include "importers/index_table.h"
#include "importers/weld.h"

namespace restframe {
namespace {

// Zero if `v` has no length.
Vec3 unit(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : Vec3(0);
}

Surface surface_of(const Mesh& mesh) {
  const Weld joined = weld(mesh.positions);
  Surface surface;
  surface.positions = joined.places;
  surface.triangles = welded_triangles(mesh, joined);
  surface.face_normals.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    surface.face_normals.push_back(unit(glm::cross(b - a, c - a)));
  }
  return surface;
}

// The angle of a triangle at a corner: the weight of its normal there, which does not depend on how
// the surface is cut into triangles.
double angle_at(const Mesh& mesh, const Triangle& t, std::size_t corner) {
  const Vec3 origin = mesh.positions[t[corner]];
  const Vec3 a = Vec3(mesh.positions[t[(corner + 1) % 3]]) - origin;
  const Vec3 b = Vec3(mesh.positions[t[(corner + 2) % 3]]) - origin;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Unit length, whatever the triangles.
std::vector<Vec3f> sector_normals(const Mesh& mesh, const Surface& surface,
                                  const Sectors& sectors) {
  std::vector<Vec3> sums(sectors.count, Vec3(0));
  std::vector<std::uint32_t> a_face(sectors.count);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t sector = sectors.sector[3 * t + i];
      sums[sector] += angle_at(mesh, mesh.triangles[t], i) * surface.face_normals[t];
      a_face[sector] = t;
    }
  }
  std::vector<Vec3f> result;
  result.reserve(sums.size());
  for (std::size_t s = 0; s < sums.size(); ++s) {
    Vec3 normal = unit(sums[s]);
    if (normal == Vec3(0)) normal = surface.face_normals[a_face[s]];
    if (normal == Vec3(0)) normal = Vec3(0, 0, 1);
    result.emplace_back(normal);
  }
  return result;
}

template <class T>
void copy_vertex(std::vector<T>& attribute, std::uint32_t vertex) {
  if (!attribute.empty()) attribute.push_back(T(attribute[vertex]));
}

// Appends a copy of `vertex`.
void duplicate(Mesh& mesh, std::uint32_t vertex) {
  copy_vertex(mesh.positions, vertex);
  for (std::vector<Vec2f>& uvs : mesh.uvs) copy_vertex(uvs, vertex);
  copy_vertex(mesh.colors, vertex);
}

// Gives each vertex the normal of the first sector that uses it; a copy of it to each further one.
void assign(Mesh& mesh, const Sectors& sectors, const std::vector<Vec3f>& sector_normal) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  std::vector<std::uint32_t> first_sector(mesh.positions.size(), none);
  mesh.normals.assign(mesh.positions.size(), Vec3f(0, 0, 1));
  const auto originals = static_cast<std::uint32_t>(mesh.positions.size());
  IndexTable copies;
  for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t sector = sectors.sector[corner];
    if (first_sector[vertex] == none) {
      first_sector[vertex] = sector;
      mesh.normals[vertex] = sector_normal[sector];
    } else if (first_sector[vertex] != sector) {
      const std::uint32_t copy = originals + copies.insert({vertex, sector, 0});
      if (copy == mesh.positions.size()) {
        duplicate(mesh, vertex);
        mesh.normals.push_back(sector_normal[sector]);
      }
      vertex = copy;
    }
  }
}

}  // namespace

void add_normals(Mesh& mesh, double crease_degrees) {
  if (!mesh.normals.empty()) return;
  const double cos_crease = std::cos(crease_degrees * glm::pi<double>() / 180);
  const Surface surface = surface_of(mesh);
  const Sectors sectors = fits_half_edges(surface) ? half_edge_sectors(surface, cos_crease)
                                                   : edge_map_sectors(surface, cos_crease);
  assign(mesh, sectors, sector_normals(mesh, surface, sectors));
  pad_for_embree(mesh);
}

}  // namespace restframe
