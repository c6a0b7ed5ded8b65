#include "importers/weld.h"

#include <bit>

namespace restframe {
namespace {

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x == 0 ? 0.0F : x);
}

}  // namespace

IndexTable::Key position_key(const Vec3f& position) {
  return {bits(position.x), bits(position.y), bits(position.z)};
}

Weld weld(const std::vector<Vec3f>& positions) {
  IndexTable table(positions.size());
  Weld result;
  result.place_of_vertex.reserve(positions.size());
  for (const Vec3f& p : positions) result.place_of_vertex.push_back(table.insert(position_key(p)));
  result.places = static_cast<std::uint32_t>(table.keys().size());
  return result;
}

std::vector<Triangle> welded_triangles(const Mesh& mesh, const Weld& weld) {
  std::vector<Triangle> result;
  result.reserve(mesh.triangles.size());
  const std::vector<std::uint32_t>& place = weld.place_of_vertex;
  for (const Triangle& t : mesh.triangles)
    result.push_back({place[t[0]], place[t[1]], place[t[2]]});
  return result;
}

}  // namespace restframe
