#pragma GCC diagnostic push
#ifndef __clang__
// OpenMesh stores vectors before it gives them values.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#pragma GCC diagnostic pop

#include <cmath>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/generators.h"

namespace restframe {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

bool are_joined(const HalfEdgeMesh& mesh, int a, int b) {
  const double edge = 2;
  const auto difference = mesh.point(mesh.vertex_handle(a)) - mesh.point(mesh.vertex_handle(b));
  return std::abs(difference.norm() - edge) < 0.1;
}

void add_outward_face(HalfEdgeMesh& mesh, int a, int b, int c) {
  const auto u = mesh.vertex_handle(a), v = mesh.vertex_handle(b), w = mesh.vertex_handle(c);
  const auto p = mesh.point(u), normal = cross(mesh.point(v) - p, mesh.point(w) - p);
  if (dot(normal, p) > 0) {
    mesh.add_face(u, v, w);
  } else {
    mesh.add_face(u, w, v);
  }
}

// Its corners are those of three golden rectangles, so that each axis of coordinates passes through
// the middle of an edge, and all six ends look alike. Any three corners an edge apart are a face.
HalfEdgeMesh make_icosahedron() {
  const double phi = 0.5 * (1 + std::sqrt(5.0));
  HalfEdgeMesh mesh;
  for (const double one : {-1.0, 1.0}) {
    for (const double golden : {-phi, phi}) {
      mesh.add_vertex({0, one, golden});
      mesh.add_vertex({one, golden, 0});
      mesh.add_vertex({golden, 0, one});
    }
  }
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12 && are_joined(mesh, a, b); ++c) {
        if (are_joined(mesh, b, c) && are_joined(mesh, c, a)) add_outward_face(mesh, a, b, c);
      }
    }
  }
  return mesh;
}

HalfEdgeMesh subdivided(HalfEdgeMesh mesh, int fineness) {
  OpenMesh::Subdivider::Uniform::LoopT<HalfEdgeMesh> loop;
  loop.attach(mesh);
  loop(static_cast<std::size_t>(fineness));
  loop.detach();
  return mesh;
}

}  // namespace

std::vector<std::string> ball_faults(const BallSettings& settings) {
  std::vector<std::string> faults;
  if (!(settings.radius >= 1e-15 && settings.radius <= 1e15)) {
    faults.push_back(fmt::format("radius {} must be from 1e-15 to 1e15", settings.radius));
  }
  if (settings.fineness < 0 || settings.fineness > 7) {
    faults.push_back(fmt::format("fineness {} must be from 0 to 7", settings.fineness));
  }
  return faults;
}

Mesh make_ball(const BallSettings& settings) {
  if (const auto faults = ball_faults(settings); !faults.empty()) throw InputError(faults);
  const HalfEdgeMesh fine = subdivided(make_icosahedron(), settings.fineness);
  Mesh ball;
  ball.name = "ball";
  ball.materials = {{0, 0}};
  ball.positions.reserve(fine.n_vertices() + 1);
  ball.normals.reserve(fine.n_vertices());
  for (const auto vertex : fine.vertices()) {
    const OpenMesh::Vec3d& point = fine.point(vertex);
    const Vec3 normal = glm::normalize(Vec3(point[0], point[1], point[2]));
    ball.normals.emplace_back(normal);
    ball.positions.emplace_back(settings.radius * normal);
  }
  ball.triangles.reserve(fine.n_faces());
  for (const auto face : fine.faces()) {
    Triangle triangle{};
    std::size_t corner = 0;
    for (const auto vertex : fine.fv_range(face)) {
      triangle[corner++] = static_cast<std::uint32_t>(vertex.idx());
    }
    ball.triangles.push_back(triangle);
  }
  pad_for_embree(ball);
  return ball;
}

Asset make_sphere_asset(const BallSettings& settings) {
  Asset asset;
  asset.name = "sphere";
  asset.meshes.push_back(make_ball(settings));
  add_part(asset, 0, "ball");
  Material material;
  material.name = "ball";
  material.base_color.value = Vec3f(0.8F);
  material.metallic.value = 0;
  material.roughness.value = 0.5F;
  asset.materials.push_back(material);
  return asset;
}

}  // namespace restframe
