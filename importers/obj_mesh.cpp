#include "importers/obj_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "importers/obj_piece.h"
#include "importers/orientation.h"
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

// Numbers of an object's runs by their groups, first those of no group, else as in the file.
std::vector<std::size_t> runs_by_group(const std::vector<ObjRun>& runs,
                                       const std::vector<ObjGroup>& groups) {
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    const int group = runs[i].group;
    return std::pair(!groups[static_cast<std::size_t>(group)].group.empty(), group);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

void add_groups(ObjPiece& piece, const std::vector<ObjGroup>& groups, const std::vector<int>& slots,
                Meshes& result) {
  const std::vector<ObjRun>& runs = piece.runs;
  const auto is_of_first = [&](const ObjRun& run) { return run.group == runs[0].group; };
  if (std::all_of(runs.begin(), runs.end(), is_of_first)) {
    for (const ObjRun& run : runs) start_range(piece.mesh, run.first_triangle, run.material, slots);
    result.emplace_back(runs[0].group, std::move(piece.mesh));
    return;
  }
  const std::vector<Triangle>& triangles = piece.mesh.triangles;
  VertexPicker picker(piece.mesh.positions.size());
  const std::vector<std::size_t> order = runs_by_group(runs, groups);
  for (auto run = order.begin(); run != order.end();) {
    const int group = runs[*run].group;
    Mesh mesh;
    for (; run != order.end() && runs[*run].group == group; ++run) {
      start_range(mesh, mesh.triangles.size(), runs[*run].material, slots);
      const std::uint32_t end = end_of_run(runs, *run, triangles.size());
      for (std::uint32_t t = runs[*run].first_triangle; t < end; ++t) {
        mesh.triangles.push_back(picker.renumbered(triangles[t]));
      }
    }
    take_vertices(piece.mesh, picker.take(), mesh);
    result.emplace_back(group, std::move(mesh));
  }
}

void warn_of_shapes(std::uint64_t degenerate, std::uint64_t turned, bool is_exhausted,
                    std::ptrdiff_t zero_normals, const std::string& file, Warnings& warnings) {
  if (degenerate > 0)
    warnings.push_back(fmt::format("{}: {} triangles have no area", file, degenerate));
  if (turned > 0) warnings.push_back(turned_over(file, turned));
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
  std::uint64_t degenerate = 0, turned = 0;
  Meshes result;
  const auto add = [&](ObjPiece piece) {
    degenerate += count_degenerate(piece.mesh);
    if (piece.mesh.normals.empty()) turned += orient_outwards(piece.mesh);
    complete_normals(piece);
    add_groups(piece, data.groups, slots, result);
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
  warn_of_shapes(degenerate, turned, cutter.exhausted(), zero_normals, file, warnings);
  return result;
}

}  // namespace restframe
