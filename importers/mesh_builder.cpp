#include "importers/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "importers/vertex_colors.h"
#include "scene/error.h"

namespace restframe {
namespace {

bool is_usable(const Vec3f& position) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(position[i]) <= static_cast<float>(largest_coordinate))) return false;
  }
  return true;
}

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

std::size_t mend_uvs(std::vector<Vec2f>& uvs) {
  std::size_t mended = 0;
  for (Vec2f& uv : uvs) {
    if (is_usable(Vec3f(uv, 0))) continue;
    uv = Vec2f(0);
    ++mended;
  }
  return mended;
}

// Index 0 for `corner` if no face before had the attribute.
void set_corner(std::vector<std::uint32_t>& indices, std::size_t corner, std::uint32_t index) {
  if (indices.empty() && index == 0) return;
  indices.resize(corner + 1, 0);
  indices[corner] = index;
}

std::uint32_t at_corner(const std::vector<std::uint32_t>& indices, std::size_t corner) {
  return corner < indices.size() ? indices[corner] : 0;
}

}  // namespace

void MeshBuilder::fail(const std::string& reason) const {
  throw InputError(file_ + ": " + reason);
}

void MeshBuilder::expect_vertices(std::uint64_t count, std::size_t bytes_each) {
  constexpr std::uint64_t most = 0xFFFFFFFE;
  if (count > most) {
    fail(fmt::format("{} vertices, at most {} are possible", count, most));
  }
  if (count > limits_.total_bytes / bytes_each) {
    fail(fmt::format("{} vertices need more than {} bytes, the limit", count, limits_.total_bytes));
  }
  mesh.positions.reserve(count + 1);
}

std::string MeshBuilder::index_fault(double index) const {
  const auto count = static_cast<double>(mesh.positions.size());
  if (!(index >= 0 && index < count)) {
    return fmt::format("vertex index {}: there are only {} vertices, the first is 0", index, count);
  }
  const Vec3f& p = mesh.positions[static_cast<std::size_t>(index)];
  if (is_usable(p)) return {};
  return fmt::format(
      "vertex {}, which a face uses, lies at [{:g}, {:g}, {:g}]: coordinates must be finite and "
      "within "
      "1e15",
      index, p.x, p.y, p.z);
}

void MeshBuilder::add_face(const std::vector<std::uint32_t>& corners,
                           const FaceAttributes& attributes) {
  ++faces_;
  if (corners.size() < 3) {
    ++small_faces_;
    return;
  }
  if (mesh.triangles.size() + corners.size() - 2 > limits_.triangles) {
    fail(fmt::format("more than {} triangles, the limit", limits_.triangles));
  }
  if (corners.size() == 3) return add_triangle(corners, {0, 1, 2}, attributes);
  polygon_.clear();
  for (const std::uint32_t corner : corners) polygon_.emplace_back(mesh.positions[corner]);
  pieces_.clear();
  cutter_.cut(polygon_, pieces_);
  for (const Triangle& piece : pieces_) add_triangle(corners, piece, attributes);
}

void MeshBuilder::add_triangle(const std::vector<std::uint32_t>& corners, const Triangle& piece,
                               const FaceAttributes& attributes) {
  const std::size_t first = 3 * mesh.triangles.size();
  mesh.triangles.push_back({corners[piece[0]], corners[piece[1]], corners[piece[2]]});
  const std::uint32_t color = attributes.color ? color_index(*attributes.color) : 0;
  for (std::size_t i = 0; i < 3; ++i) {
    set_corner(corner_colors_, first + i, color);
    const bool has_uv = !attributes.uvs.empty();
    const Vec2f uv = has_uv ? attributes.uvs[piece[i]] : Vec2f(0);
    set_corner(corner_uvs_, first + i,
               has_uv ? 1 + uv_table_.insert({bits(uv.x), bits(uv.y), 0}) : 0);
  }
}

std::uint32_t MeshBuilder::color_index(const Vec4f& color) {
  const std::uint32_t rgb = rgb_table_.insert({bits(color.r), bits(color.g), bits(color.b)});
  const std::uint32_t index = color_table_.insert({rgb, bits(color.a), 0});
  if (index == face_colors_.size()) face_colors_.push_back(color);
  return 1 + index;
}

// A vertex for each that a face uses, with each colour and UV that faces give it.
void MeshBuilder::split_vertices() {
  IndexTable table(mesh.positions.size());
  for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
    vertex =
        table.insert({vertex, at_corner(corner_colors_, corner), at_corner(corner_uvs_, corner)});
  }
  std::vector<std::uint32_t> which;
  which.reserve(table.keys().size());
  for (const auto& key : table.keys()) which.push_back(key[0]);
  take_vertices(mesh, which, mesh);
  constexpr float full = std::numeric_limits<float>::infinity();  // of 1 or of 255
  if (!corner_colors_.empty()) mesh.colors.resize(which.size(), Vec4f(full));
  if (!corner_uvs_.empty()) mesh.uvs[0].resize(which.size(), Vec2f(0));
  for (std::size_t i = 0; i < which.size(); ++i) {
    const auto& [vertex, color, uv] = table.keys()[i];
    if (color > 0) mesh.colors[i] = face_colors_[color - 1];
    if (uv == 0) continue;
    const IndexTable::Key& key = uv_table_.keys()[uv - 1];
    mesh.uvs[0][i] = {std::bit_cast<float>(key[0]), std::bit_cast<float>(key[1])};
  }
}

Mesh MeshBuilder::take(Warnings& warnings) {
  if (mesh.triangles.empty()) {
    const std::string faces = faces_ == 0
                                  ? fmt::format("{} vertices, no faces", mesh.positions.size())
                                  : fmt::format("{} faces, none of three corners or more", faces_);
    fail(fmt::format("nothing to render: {} (points and lines are not renderable)", faces));
  }
  split_vertices();
  const std::size_t mended = mend_uvs(mesh.uvs[0]);
  if (mended > 0) {
    warnings.push_back(
        fmt::format("{}: {} texture coordinates are not finite, taken as 0", file_, mended));
  }
  if (!mesh.colors.empty()) {
    const bool scaled = make_linear(mesh.colors, rgb_may_be_bytes, alpha_may_be_bytes);
    if (scaled) warnings.push_back(file_ + ": colours beyond 1 are taken as 0 to 255");
  }
  warn(warnings);
  return std::move(mesh);
}

void MeshBuilder::warn(Warnings& warnings) const {
  if (small_faces_ > 0) {
    warnings.push_back(
        fmt::format("{}: {} faces of fewer than three corners are not renderable, skipped", file_,
                    small_faces_));
  }
  if (cutter_.exhausted()) {
    warnings.push_back(file_ + ": polygons with too many concave corners were cut into fans");
  }
}

}  // namespace restframe
