#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wall"
#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#pragma GCC diagnostic pop

#include <stdexcept>

#include "importers/crease_sectors.h"

namespace restframe {
namespace {

using HalfEdgeMesh = OpenMesh::TriConnectivity;
using OpenMesh::HalfedgeHandle;

// Face numbers are triangle numbers, vertex numbers are positions. No coordinates: only the
// connections.
void connect(HalfEdgeMesh& mesh, const Surface& surface) {
  const std::size_t faces = surface.triangles.size();
  mesh.reserve(surface.positions, faces + surface.positions, faces);
  for (std::uint32_t i = 0; i < surface.positions; ++i) mesh.add_vertex();
  const auto vertex = [&](std::uint32_t i) { return mesh.vertex_handle(i); };
  for (const Triangle& t : surface.triangles) {
    const auto face = mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
    if (!face.is_valid()) throw std::logic_error("half_edge_sectors: the surface does not fit");
  }
}

// Creases are edges with the feature bit.
void mark_creases(HalfEdgeMesh& mesh, const Surface& surface, double cos_crease) {
  mesh.request_edge_status();
  for (const auto edge : mesh.edges()) {
    const auto a = mesh.face_handle(mesh.halfedge_handle(edge, 0));
    const auto b = mesh.face_handle(mesh.halfedge_handle(edge, 1));
    const auto normal = [&](const auto& face) {
      return surface.face_normals[static_cast<std::size_t>(face.idx())];
    };
    const bool smooth = a.is_valid() && b.is_valid() && is_smooth(normal(a), normal(b), cos_crease);
    mesh.status(edge).set_feature(!smooth);
  }
}

// The corner at the tip of a half-edge, within its face.
std::size_t corner_of(const HalfEdgeMesh& mesh, const Surface& surface, HalfedgeHandle halfedge) {
  const auto face = static_cast<std::size_t>(mesh.face_handle(halfedge).idx());
  const auto tip = static_cast<std::uint32_t>(mesh.to_vertex_handle(halfedge).idx());
  const Triangle& triangle = surface.triangles[face];
  return 3 * face + (triangle[0] == tip ? 0 : triangle[1] == tip ? 1 : 2);
}

bool is_crease(const HalfEdgeMesh& mesh, HalfedgeHandle halfedge) {
  return mesh.status(mesh.edge_handle(halfedge)).feature();
}

// Half-edges of the same tip: across the edge that enters it, and across the one that leaves it.
HalfedgeHandle turn_back(const HalfEdgeMesh& mesh, HalfedgeHandle halfedge) {
  return mesh.prev_halfedge_handle(mesh.opposite_halfedge_handle(halfedge));
}
HalfedgeHandle turn_on(const HalfEdgeMesh& mesh, HalfedgeHandle halfedge) {
  return mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(halfedge));
}

}  // namespace

Sectors half_edge_sectors(const Surface& surface, double cos_crease) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  HalfEdgeMesh mesh;
  connect(mesh, surface);
  mark_creases(mesh, surface, cos_crease);
  Sectors result;
  result.sector.assign(3 * surface.triangles.size(), none);
  const auto sector = [&](HalfedgeHandle h) -> std::uint32_t& {
    return result.sector[corner_of(mesh, surface, h)];
  };
  for (const HalfedgeHandle start : mesh.halfedges()) {
    if (mesh.is_boundary(start) || sector(start) != none) continue;
    HalfedgeHandle h = start;
    while (!is_crease(mesh, h) && turn_back(mesh, h) != start) h = turn_back(mesh, h);
    for (; sector(h) == none; h = turn_on(mesh, h)) {
      sector(h) = result.count;
      if (is_crease(mesh, mesh.next_halfedge_handle(h))) break;
    }
    ++result.count;
  }
  return result;
}

}  // namespace restframe
