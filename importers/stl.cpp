#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>

#include "importers/byte_reader.h"
#include "importers/mesh_asset.h"
#include "importers/stl_solid.h"
#include "importers/weld.h"

namespace restframe {
namespace {

bool starts_with_solid(std::string_view head) {
  constexpr std::string_view solid = "solid";
  if (head.substr(0, 3) == "\xEF\xBB\xBF") head.remove_prefix(3);
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  return head.size() >= solid.size() &&
         std::equal(solid.begin(), solid.end(), head.begin(), [](char wanted, char c) {
           return wanted == std::tolower(static_cast<unsigned char>(c));
         });
}

// Binary files may begin with "solid" too, but no text has a NUL where they have the number of
// their triangles. UTF-16 is text, to be told so.
bool is_text(const Path& path, const ImportLimits& limits) {
  constexpr std::size_t head_size = 84;
  ByteReader file(path, limits.total_bytes);
  const std::string_view head = file.peek(head_size);
  if (head.substr(0, 2) == "\xFF\xFE" || head.substr(0, 2) == "\xFE\xFF") return true;
  return starts_with_solid(head) && head.find('\0') == head.npos;
}

}  // namespace

void SolidBuilder::add(const std::array<Vec3f, 3>& corners) {
  Triangle triangle{};
  for (std::size_t i = 0; i < 3; ++i) triangle[i] = vertices_.insert(position_key(corners[i]));
  triangles_.push_back(triangle);
}

Mesh SolidBuilder::take(const std::string& name) {
  Mesh mesh;
  mesh.name = name;
  mesh.triangles = std::move(triangles_);
  mesh.positions.reserve(vertices_.keys().size() + 1);
  for (const auto& [x, y, z] : vertices_.keys()) {
    mesh.positions.emplace_back(std::bit_cast<float>(x), std::bit_cast<float>(y),
                                std::bit_cast<float>(z));
  }
  return mesh;
}

std::string corner_fault(const Vec3f& corner) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(corner[i]) <= static_cast<float>(largest_coordinate)) continue;
    return fmt::format(
        "a corner lies at [{:g}, {:g}, {:g}]: coordinates must be finite and within 1e15", corner.x,
        corner.y, corner.z);
  }
  return {};
}

Asset load_stl(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  if (is_text(path, limits)) {
    return make_mesh_asset(path, read_stl_text(path, limits, warnings), warnings);
  }
  std::vector<Mesh> one(1);
  one[0] = read_stl_binary(path, limits, warnings);
  return make_mesh_asset(path, std::move(one), warnings);
}

}  // namespace restframe
