#include "importers/obj_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "importers/obj_piece.h"
#include "importers/triangulate.h"
#include "importers/vertex_picker.h"

namespace restframe {
namespace {

// Polygons come as fans around their first corner.
void cut_polygons(ObjData& data, PolygonCutter& cutter) {
  std::vector<std::uint32_t> corners;
  std::vector<Vec3> points;
  std::vector<Triangle> pieces;
  for (const ObjPolygon& polygon : data.polygons) {
    Triangle* const fan = data.triangles.data() + polygon.first_triangle;
    corners.assign({fan[0][0], fan[0][1]});
    for (std::uint32_t i = 0; i < polygon.triangles; ++i) corners.push_back(fan[i][2]);
    points.clear();
    for (const std::uint32_t corner : corners) {
      points.emplace_back(data.positions[data.vertices.keys()[corner][0]]);
    }
    pieces.clear();
    cutter.cut(points, pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      fan[i] = {corners[pieces[i][0]], corners[pieces[i][1]], corners[pieces[i][2]]};
    }
  }
}

// OBJ's v points up.
Vec2f flipped(const Vec2f& uv) {
  return {uv.x, 1 - uv.y};
}

Vec3f unit(const Vec3f& v) {
  const double length = glm::length(Vec3(v));
  return length > 0 ? Vec3f(Vec3(v) / length) : Vec3f(0);
}

using Keys = std::vector<IndexTable::Key>;

void fill_vertices(const ObjData& data, const Keys& keys, ObjPiece& piece) {
  Mesh& mesh = piece.mesh;
  const auto any = [&](std::size_t i) {
    return std::any_of(keys.begin(), keys.end(), [i](const auto& key) { return key[i] > 0; });
  };
  const bool has_uvs = any(1), has_normals = any(2);
  mesh.positions.reserve(keys.size() + 1);
  mesh.colors.reserve(data.colors.empty() ? 0 : keys.size());
  mesh.uvs[0].reserve(has_uvs ? keys.size() : 0);
  mesh.normals.reserve(has_normals ? keys.size() : 0);
  for (const auto& [position, uv, normal] : keys) {
    mesh.positions.push_back(data.positions[position]);
    if (!data.colors.empty()) mesh.colors.push_back(data.colors[position]);
    if (has_uvs) mesh.uvs[0].push_back(uv == 0 ? Vec2f(0) : flipped(data.uvs[uv - 1]));
    if (!has_normals) continue;
    mesh.normals.push_back(normal == 0 ? Vec3f(0) : unit(data.normals[normal - 1]));
  }
  const auto is_in_group = [](const ObjRun& run) { return run.smoothing > smooth_never; };
  if (std::none_of(piece.runs.begin(), piece.runs.end(), is_in_group)) return;
  for (const IndexTable::Key& key : keys) piece.positions.push_back(key[0]);
}

std::uint32_t end_of_run(const std::vector<ObjRun>& runs, std::size_t run,
                         const std::vector<Triangle>& triangles) {
  return run + 1 < runs.size() ? runs[run + 1].first_triangle
                               : static_cast<std::uint32_t>(triangles.size());
}

// Appends the polygons among the triangles from `begin` to `end`, which are `shift` further on in
// the piece.
void copy_polygons(const ObjData& data, std::uint32_t begin, std::uint32_t end,
                   std::uint32_t new_begin, ObjPiece& piece) {
  const auto is_before = [](const ObjPolygon& p, std::uint32_t t) { return p.first_triangle < t; };
  auto polygon = std::lower_bound(data.polygons.begin(), data.polygons.end(), begin, is_before);
  for (; polygon != data.polygons.end() && polygon->first_triangle < end; ++polygon) {
    piece.polygons.push_back({polygon->first_triangle - begin + new_begin, polygon->triangles});
  }
}

// The runs of one object, by their numbers.
ObjPiece take_object(const ObjData& data, const std::vector<std::size_t>& runs,
                     VertexPicker& picker) {
  ObjPiece piece;
  std::vector<Triangle>& triangles = piece.mesh.triangles;
  for (const std::size_t index : runs) {
    ObjRun run = data.runs[index];
    const std::uint32_t begin = run.first_triangle;
    const std::uint32_t end = end_of_run(data.runs, index, data.triangles);
    run.first_triangle = static_cast<std::uint32_t>(triangles.size());
    piece.runs.push_back(run);
    copy_polygons(data, begin, end, run.first_triangle, piece);
    for (std::uint32_t t = begin; t < end; ++t) {
      triangles.push_back(picker.renumbered(data.triangles[t]));
    }
  }
  Keys keys;
  for (const std::uint32_t vertex : picker.take()) keys.push_back(data.vertices.keys()[vertex]);
  fill_vertices(data, keys, piece);
  return piece;
}

// All of a file that is one object: no triangle is copied, and what is used up is freed at once.
ObjPiece take_all(ObjData& data) {
  ObjPiece piece;
  piece.mesh.triangles = std::move(data.triangles);
  piece.polygons = std::move(data.polygons);
  piece.runs = std::move(data.runs);
  fill_vertices(data, data.vertices.take_keys(), piece);
  for (std::vector<Vec3f>* vectors : {&data.positions, &data.normals})
    std::vector<Vec3f>().swap(*vectors);
  std::vector<Vec2f>().swap(data.uvs);
  std::vector<Vec4f>().swap(data.colors);
  return piece;
}

// Numbers of the runs of each object, in the order of the file.
std::vector<std::vector<std::size_t>> runs_by_object(const ObjData& data) {
  std::vector<std::vector<std::size_t>> result(static_cast<std::size_t>(data.objects));
  for (std::size_t run = 0; run < data.runs.size(); ++run) {
    const ObjGroup& group = data.groups[static_cast<std::size_t>(data.runs[run].group)];
    result[static_cast<std::size_t>(group.object_index)].push_back(run);
  }
  return result;
}

// From its next triangle on, the mesh uses the material of a run.
void start_range(Mesh& mesh, std::size_t triangle, int material, const std::vector<int>& slots) {
  const int slot = material < 0 ? slots.back() : slots[static_cast<std::size_t>(material)];
  if (!mesh.materials.empty() && mesh.materials.back().slot == slot) return;
  mesh.materials.push_back({static_cast<std::uint32_t>(triangle), slot});
}

using Meshes = std::vector<std::pair<int, Mesh>>;

void add_groups(ObjPiece& piece, const std::vector<int>& slots, Meshes& result) {
  const std::vector<ObjRun>& runs = piece.runs;
  const auto is_of_first = [&](const ObjRun& run) { return run.group == runs[0].group; };
  if (std::all_of(runs.begin(), runs.end(), is_of_first)) {
    for (const ObjRun& run : runs) start_range(piece.mesh, run.first_triangle, run.material, slots);
    result.emplace_back(runs[0].group, std::move(piece.mesh));
    return;
  }
  std::vector<std::size_t> order(runs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto group = [&](std::size_t i) { return runs[i].group; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return group(a) < group(b); });
  VertexPicker picker(piece.mesh.positions.size());
  for (auto run = order.begin(); run != order.end();) {
    const int number = group(*run);
    Mesh mesh;
    for (; run != order.end() && group(*run) == number; ++run) {
      start_range(mesh, mesh.triangles.size(), runs[*run].material, slots);
      const std::uint32_t end = end_of_run(runs, *run, piece.mesh.triangles);
      for (std::uint32_t t = runs[*run].first_triangle; t < end; ++t) {
        mesh.triangles.push_back(picker.renumbered(piece.mesh.triangles[t]));
      }
    }
    take_vertices(piece.mesh, picker.take(), mesh);
    result.emplace_back(number, std::move(mesh));
  }
}

void warn_of_shapes(std::uint64_t degenerate, bool is_exhausted, std::ptrdiff_t zero_normals,
                    const std::string& file, Warnings& warnings) {
  if (degenerate > 0)
    warnings.push_back(fmt::format("{}: {} triangles have no area", file, degenerate));
  if (is_exhausted) {
    warnings.push_back(file + ": polygons with too many concave corners were cut into fans");
  }
  if (zero_normals > 0) {
    warnings.push_back(
        fmt::format("{}: {} vn lines have no length, computed instead", file, zero_normals));
  }
}

}  // namespace

std::string name_of(const ObjGroup& group) {
  if (group.object.empty() || group.group.empty()) return group.object + group.group;
  return group.object + "/" + group.group;
}

std::vector<std::pair<int, Mesh>> build_obj_meshes(ObjData& data, const std::vector<int>& slots,
                                                   const std::string& file, Warnings& warnings) {
  PolygonCutter cutter;
  cut_polygons(data, cutter);
  const auto zero_normals = std::count(data.normals.begin(), data.normals.end(), Vec3f(0));
  std::uint64_t degenerate = 0;
  Meshes result;
  const auto add = [&](ObjPiece piece) {
    degenerate += count_degenerate(piece.mesh);
    complete_normals(piece);
    add_groups(piece, slots, result);
  };
  if (data.objects == 1) {
    add(take_all(data));
  } else {
    VertexPicker picker(data.vertices.keys().size());
    for (const std::vector<std::size_t>& runs : runs_by_object(data)) {
      add(take_object(data, runs, picker));
    }
  }
  for (auto& [group, mesh] : result) {
    mesh.name = name_of(data.groups[static_cast<std::size_t>(group)]);
    pad_for_embree(mesh);
  }
  warn_of_shapes(degenerate, cutter.exhausted(), zero_normals, file, warnings);
  return result;
}

}  // namespace restframe
