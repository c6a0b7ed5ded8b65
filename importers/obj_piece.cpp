#include "importers/obj_piece.h"

#include <algorithm>
#include <iterator>

#include "importers/vertex_picker.h"

namespace restframe {
namespace {

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

// Appends the polygons among the triangles from `begin` to `end`, which are those from `new_begin`
// on in the piece.
void copy_polygons(const ObjData& data, std::uint32_t begin, std::uint32_t end,
                   std::uint32_t new_begin, ObjPiece& piece) {
  const auto is_before = [](const ObjPolygon& p, std::uint32_t t) { return p.first_triangle < t; };
  auto polygon = std::lower_bound(data.polygons.begin(), data.polygons.end(), begin, is_before);
  for (; polygon != data.polygons.end() && polygon->first_triangle < end; ++polygon) {
    piece.polygons.push_back({polygon->first_triangle - begin + new_begin, polygon->triangles});
  }
}

}  // namespace

ObjPiece take_object(const ObjData& data, const std::vector<std::size_t>& runs,
                     VertexPicker& picker) {
  ObjPiece piece;
  std::vector<Triangle>& triangles = piece.mesh.triangles;
  for (const std::size_t index : runs) {
    ObjRun run = data.runs[index];
    const std::uint32_t begin = run.first_triangle;
    const std::uint32_t end = end_of_run(data.runs, index, data.triangles.size());
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

ObjPiece take_all(ObjData& data) {
  ObjPiece piece;
  piece.mesh.triangles = std::move(data.triangles);
  piece.polygons = std::move(data.polygons);
  piece.runs = std::move(data.runs);
  fill_vertices(data, data.vertices.take_keys(), piece);
  std::vector<Vec3f>().swap(data.positions);
  std::vector<Vec3f>().swap(data.normals);
  std::vector<Vec2f>().swap(data.uvs);
  std::vector<Vec4f>().swap(data.colors);
  return piece;
}

}  // namespace restframe
