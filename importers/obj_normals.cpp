#include <algorithm>
#include <cmath>

#include "importers/importers.h"
#include "importers/index_table.h"
#include "importers/obj_piece.h"

namespace restframe {
namespace {

bool is_missing(const Vec3f& normal) {
  return normal == Vec3f(0);
}

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

// Twice its area long.
Vec3 area_vector(const Mesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  return glm::cross(b - a, c - a);
}

double angle_at(const Mesh& mesh, const Triangle& t, std::size_t corner) {
  const Vec3 origin = mesh.positions[t[corner]];
  const Vec3 a = Vec3(mesh.positions[t[(corner + 1) % 3]]) - origin;
  const Vec3 b = Vec3(mesh.positions[t[(corner + 2) % 3]]) - origin;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

template <class T>
void copy_last(std::vector<T>& attribute, std::uint32_t vertex) {
  if (!attribute.empty()) attribute.push_back(T(attribute[vertex]));
}

// Collects normals, each with a key of its own, and hands them to the corners that need them.
class NormalTable {
 public:
  explicit NormalTable(ObjPiece& piece) : piece_(piece), mesh_(piece.mesh), given_(mesh_.normals) {
    given_.resize(mesh_.positions.size(), Vec3f(0));
    add_faces();
    assign();
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  // A polygon is one face with one normal, however it is cut.
  void add_faces() {
    numbers_.reserve(3 * mesh_.triangles.size());
    auto polygon = piece_.polygons.begin();
    auto run = piece_.runs.begin();
    std::uint32_t count = 0;
    for (std::uint32_t first = 0; first < mesh_.triangles.size(); first += count) {
      while (run + 1 != piece_.runs.end() && (run + 1)->first_triangle <= first) ++run;
      const bool is_polygon = polygon != piece_.polygons.end() && polygon->first_triangle == first;
      count = is_polygon ? (polygon++)->triangles : 1;
      add_face(first, first + count, run->smoothing);
    }
  }

  void add_face(std::uint32_t first, std::uint32_t end, int group) {
    Vec3 sum(0);
    for (std::uint32_t t = first; t < end; ++t) sum += area_vector(mesh_, mesh_.triangles[t]);
    const Vec3 normal = unit_or(sum, Vec3(0));
    for (std::uint32_t t = first; t < end; ++t) {
      const Triangle& triangle = mesh_.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const bool is_flat = group == smooth_never;
        const std::uint32_t number = is_flat ? keys_.insert({first, 0, 1})
                                             : keys_.insert({piece_.positions[triangle[i]],
                                                             static_cast<std::uint32_t>(group), 0});
        if (number == sums_.size()) sums_.push_back({Vec3(0), normal});
        sums_[number].weighted += (is_flat ? 1 : angle_at(mesh_, triangle, i)) * normal;
        numbers_.push_back(number);
      }
    }
  }

  // Gives each vertex the first normal that a corner asks of it; a copy of it to each further one.
  void assign() {
    const auto originals = static_cast<std::uint32_t>(mesh_.positions.size());
    std::vector<std::uint32_t> first_number(originals, none);
    mesh_.normals = given_;
    IndexTable copies;
    for (std::size_t corner = 0; corner < numbers_.size(); ++corner) {
      std::uint32_t& vertex = mesh_.triangles[corner / 3][corner % 3];
      if (!is_missing(given_[vertex])) continue;
      const std::uint32_t number = numbers_[corner];
      if (first_number[vertex] == none) {
        first_number[vertex] = number;
        mesh_.normals[vertex] = normal(number);
      } else if (first_number[vertex] != number) {
        const std::uint32_t copy = originals + copies.insert({vertex, number, 0});
        if (copy == mesh_.positions.size()) duplicate(vertex, number);
        vertex = copy;
      }
    }
  }

  void duplicate(std::uint32_t vertex, std::uint32_t number) {
    copy_last(mesh_.positions, vertex);
    for (std::vector<Vec2f>& uvs : mesh_.uvs) copy_last(uvs, vertex);
    copy_last(mesh_.colors, vertex);
    mesh_.normals.push_back(normal(number));
  }

  // Where faces cancel, that of one of them.
  Vec3f normal(std::uint32_t number) const {
    const Sum& sum = sums_[number];
    return Vec3f(unit_or(sum.weighted, unit_or(sum.first_face, Vec3(0, 0, 1))));
  }

  struct Sum {
    Vec3 weighted, first_face;
  };

  ObjPiece& piece_;
  Mesh& mesh_;
  std::vector<Vec3f> given_;
  IndexTable keys_;  // of sums_: position and group, or a flat face's first triangle
  std::vector<Sum> sums_;
  std::vector<std::uint32_t> numbers_;  // into sums_, one a corner
};

// As if the mesh had no normals at all, but given ones stay.
void complete_by_crease(Mesh& mesh) {
  const std::vector<Vec3f> given = std::move(mesh.normals);
  mesh.normals.clear();
  const std::vector<Triangle> before = given.empty() ? std::vector<Triangle>() : mesh.triangles;
  add_normals(mesh);
  for (std::size_t t = 0; t < before.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f& normal = given[before[t][i]];
      if (!is_missing(normal)) mesh.normals[mesh.triangles[t][i]] = normal;
    }
  }
}

}  // namespace

void complete_normals(ObjPiece& piece) {
  std::vector<Vec3f>& normals = piece.mesh.normals;
  if (!normals.empty() && std::none_of(normals.begin(), normals.end(), is_missing)) return;
  if (piece.runs[0].smoothing == smooth_by_crease) return complete_by_crease(piece.mesh);
  const auto is_flat = [](const ObjRun& run) { return run.smoothing == smooth_never; };
  const bool all_flat = std::all_of(piece.runs.begin(), piece.runs.end(), is_flat);
  if (normals.empty() && piece.polygons.empty() && all_flat) return;
  NormalTable table(piece);
}

}  // namespace restframe
