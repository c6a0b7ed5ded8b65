#include "importers/obj_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "importers/index_table.h"
#include "importers/mesh_split.h"
#include "importers/triangulate.h"

namespace restframe {
namespace {

// Makes the mesh of one object: triangles in the order of the file, a vertex for each combination
// of indices. Corners without a normal get a zero one.
class ObjectBuilder {
 public:
  ObjectBuilder(const ObjData& data, PolygonCutter& cutter) : data_(data), cutter_(cutter) {}

  void add_face(std::uint32_t face, TriangleTag tag) {
    const std::uint32_t begin = face == 0 ? 0 : data_.face_ends[face - 1];
    const std::uint32_t count = data_.face_ends[face] - begin;
    if (count == 3) {
      add_triangle(begin, {0, 1, 2}, tag);
      return;
    }
    polygon_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      polygon_.emplace_back(data_.positions[static_cast<std::size_t>(corner(begin + i).position)]);
    }
    pieces_.clear();
    cutter_.cut(polygon_, pieces_);
    for (const Triangle& piece : pieces_) add_triangle(begin, piece, tag);
  }

  TaggedMesh take() {
    fill_vertices();
    return std::move(result_);
  }

 private:
  const ObjCorner& corner(std::uint32_t index) const { return data_.corners[index]; }

  void add_triangle(std::uint32_t begin, const Triangle& corners, TriangleTag tag) {
    Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const ObjCorner& c = corner(begin + corners[i]);
      triangle[i] = vertices_.insert({static_cast<std::uint32_t>(c.position),
                                      static_cast<std::uint32_t>(c.uv + 1),
                                      static_cast<std::uint32_t>(c.normal + 1)});
    }
    result_.mesh.triangles.push_back(triangle);
    result_.tags.push_back(tag);
  }

  void fill_vertices() {
    Mesh& mesh = result_.mesh;
    const auto& keys = vertices_.keys();
    const bool has_uvs =
        std::any_of(keys.begin(), keys.end(), [](const auto& k) { return k[1] > 0; });
    const bool has_normals =
        std::any_of(keys.begin(), keys.end(), [](const auto& k) { return k[2] > 0; });
    mesh.positions.reserve(keys.size() + 1);
    for (const auto& [position, uv, normal] : keys) {
      mesh.positions.push_back(data_.positions[position]);
      if (!data_.colors.empty()) mesh.colors.push_back(data_.colors[position]);
      if (has_uvs) mesh.uvs[0].push_back(uv == 0 ? Vec2f(0) : flipped(data_.uvs[uv - 1]));
      if (has_normals)
        mesh.normals.push_back(normal == 0 ? Vec3f(0) : unit(data_.normals[normal - 1]));
    }
  }

  // OBJ's v points up.
  static Vec2f flipped(const Vec2f& uv) { return {uv.x, 1 - uv.y}; }

  static Vec3f unit(const Vec3f& v) {
    const double length = glm::length(Vec3(v));
    return length > 0 ? Vec3f(Vec3(v) / length) : Vec3f(0);
  }

  const ObjData& data_;
  PolygonCutter& cutter_;
  IndexTable vertices_;
  TaggedMesh result_;
  std::vector<Vec3> polygon_;
  std::vector<Triangle> pieces_;
};

// Gives normals to the vertices whose normal is zero, by crease angle as if the mesh had none at
// all.
void complete_normals(Mesh& mesh) {
  const auto missing = [](const Vec3f& n) { return n == Vec3f(0); };
  const std::vector<Vec3f> given = std::move(mesh.normals);
  mesh.normals.clear();
  if (!given.empty() && std::none_of(given.begin(), given.end(), missing)) {
    mesh.normals = given;
    return;
  }
  const std::vector<Triangle> before = mesh.triangles;
  add_normals(mesh);
  if (given.empty()) return;
  for (std::size_t t = 0; t < before.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!missing(given[before[t][i]])) mesh.normals[mesh.triangles[t][i]] = given[before[t][i]];
    }
  }
}

// Runs of each object, in the order of the file.
std::vector<std::vector<std::size_t>> runs_by_object(const ObjData& data) {
  std::vector<std::vector<std::size_t>> result(static_cast<std::size_t>(data.objects));
  for (std::size_t run = 0; run < data.runs.size(); ++run) {
    const ObjGroup& group = data.groups[static_cast<std::size_t>(data.runs[run].group)];
    result[static_cast<std::size_t>(group.object_index)].push_back(run);
  }
  return result;
}

TaggedMesh build_object(const ObjData& data, const std::vector<std::size_t>& runs,
                        const std::vector<int>& slots, PolygonCutter& cutter) {
  ObjectBuilder builder(data, cutter);
  for (const std::size_t index : runs) {
    const ObjRun& run = data.runs[index];
    const std::size_t last =
        index + 1 < data.runs.size() ? data.runs[index + 1].first_face : data.face_ends.size();
    const int slot =
        run.material < 0 ? slots.back() : slots[static_cast<std::size_t>(run.material)];
    for (std::uint32_t face = run.first_face; face < last; ++face) {
      builder.add_face(face, {run.group, slot});
    }
  }
  return builder.take();
}

std::string name_of(const ObjGroup& group) {
  if (group.object.empty() || group.group.empty()) return group.object + group.group;
  return group.object + "/" + group.group;
}

void warn_of_shapes(const ObjData& data, const PolygonCutter& cutter, std::uint64_t degenerate,
                    const std::string& file, Warnings& warnings) {
  if (degenerate > 0)
    warnings.push_back(fmt::format("{}: {} triangles have no area", file, degenerate));
  if (cutter.exhausted()) {
    warnings.push_back(file + ": polygons with too many concave corners were cut into fans");
  }
  const auto zero = std::count(data.normals.begin(), data.normals.end(), Vec3f(0));
  if (zero > 0) {
    warnings.push_back(fmt::format("{}: {} vn lines have no length, computed instead", file, zero));
  }
}

}  // namespace

std::vector<Mesh> build_obj_meshes(const ObjData& data, const std::vector<int>& slots,
                                   const std::string& file, Warnings& warnings) {
  PolygonCutter cutter;
  std::uint64_t degenerate = 0;
  std::vector<Mesh> result;
  for (const std::vector<std::size_t>& runs : runs_by_object(data)) {
    TaggedMesh object = build_object(data, runs, slots, cutter);
    degenerate += count_degenerate(object.mesh);
    complete_normals(object.mesh);
    for (auto& [group, mesh] : split_by_group(std::move(object))) {
      mesh.name = name_of(data.groups[static_cast<std::size_t>(group)]);
      pad_for_embree(mesh);
      result.push_back(std::move(mesh));
    }
  }
  warn_of_shapes(data, cutter, degenerate, file, warnings);
  return result;
}

}  // namespace restframe
