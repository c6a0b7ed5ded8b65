// Corners share a tangent if they have position, normal and texture coordinates in common, their
// triangles follow each other edge by edge around that point, and all of these wind the same way on
// the texture. It is the mean of their triangles' +U directions in the plane across the normal,
// each weighted by the angle of its corner there. As all that happens around one point, the points
// are independent of each other.
//
// Triangles whose texture coordinates have no area ("blank") say nothing, but lead from neighbour
// to neighbour. Those with two corners in one place take what others have at the same points.

#include "scene/tangents.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/parallel.h"
#include "scene/tangent_points.h"

namespace restframe {
namespace {

constexpr std::size_t points_at_once = 8192;
constexpr std::int32_t nobody = -1;

Vec3 unit_or_zero(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : Vec3(0);
}

Vec3 across(const Vec3& normal, const Vec3& v) {
  return unit_or_zero(v - normal * glm::dot(normal, v));
}

// A corner among those around its point. Edges are told by the points at their other ends.
struct Corner {
  std::uint32_t index = 0;  // three times the triangle's, plus 0 to 2
  std::uint32_t next_point = 0, previous_point = 0;
  bool flat = false;      // two corners of the triangle are in one place
  bool blank = false;     // no direction on the texture
  bool mirrored = false;  // on the texture the triangle runs clockwise, with +V upwards
  Vec3 along_u{0};        // of the triangle; unit
  double angle = 0;
  // Neighbours across the edges that begin and that end here; places among the point's corners.
  std::int32_t after = nobody, before = nobody;
  bool grouped = false;
};

using Places = std::vector<std::int32_t>;  // among the corners around a point

template <class Fan>
auto& at(Fan& fan, std::int32_t place) {
  return fan[static_cast<std::size_t>(place)];
}

// Corners by the first of their points: those of point p are from first[p] to first[p + 1].
struct Fans {
  std::vector<std::uint32_t> first, corners;
};

Fans fans_of(const TangentPoints& points, const std::vector<std::uint32_t>& weld) {
  Fans fans;
  fans.first.assign(points.count() + 1, 0);
  const std::size_t count = points.corner_count();
  for (std::size_t c = 0; c < count; ++c) ++fans.first[weld[points.point_of(c)] + 1];
  std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
  fans.corners.resize(count);
  std::vector<std::uint32_t> end(fans.first.begin(), fans.first.end() - 1);
  for (std::size_t c = 0; c < count; ++c) {
    fans.corners[end[weld[points.point_of(c)]]++] = static_cast<std::uint32_t>(c);
  }
  return fans;
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

// glTF's textures have their first row, where v = 0, at the top; normal maps count upwards from
// there: +V here is upwards.
Corner corner_at(const TangentPoints& points, const std::vector<std::uint32_t>& weld,
                 std::uint32_t index) {
  const std::uint32_t triangle = index / 3, place = index % 3;
  const std::uint32_t own = points.point_of(index);
  const std::uint32_t next = points.point_of(3 * triangle + (place + 1) % 3);
  const std::uint32_t previous = points.point_of(3 * triangle + (place + 2) % 3);
  const Vec3 p(points.position(own));
  const Vec3 to_next = Vec3(points.position(next)) - p;
  const Vec3 to_previous = Vec3(points.position(previous)) - p;
  const glm::dvec2 uv(points.uv(own));
  const glm::dvec2 uv_next = (glm::dvec2(points.uv(next)) - uv) * glm::dvec2(1, -1);
  const glm::dvec2 uv_previous = (glm::dvec2(points.uv(previous)) - uv) * glm::dvec2(1, -1);
  const double area = uv_next.x * uv_previous.y - uv_next.y * uv_previous.x;
  const Vec3 normal(points.normal(own));
  Corner corner;
  corner.index = index;
  corner.next_point = weld[next];
  corner.previous_point = weld[previous];
  corner.flat = to_next == Vec3(0) || to_previous == Vec3(0) || to_next == to_previous;
  corner.mirrored = area < 0;
  corner.along_u = unit_or_zero(uv_previous.y * to_next - uv_next.y * to_previous);
  if (corner.mirrored) corner.along_u = -corner.along_u;
  corner.blank = !(std::abs(area) > 0) || corner.along_u == Vec3(0);
  corner.angle = angle_between(across(normal, to_next), across(normal, to_previous));
  return corner;
}

// Joins each corner with one that has its next edge as the previous one. Of an edge that more than
// two triangles share, each gets at most one neighbour.
void find_neighbours(std::vector<Corner>& fan, Places& by_next, Places& by_previous) {
  by_next.clear();
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if (!fan[i].flat) by_next.push_back(static_cast<std::int32_t>(i));
  }
  by_previous = by_next;
  const auto next_of = [&](std::int32_t i) { return at(fan, i).next_point; };
  const auto previous_of = [&](std::int32_t i) { return at(fan, i).previous_point; };
  std::stable_sort(by_next.begin(), by_next.end(),
                   [&](auto a, auto b) { return next_of(a) < next_of(b); });
  std::stable_sort(by_previous.begin(), by_previous.end(),
                   [&](auto a, auto b) { return previous_of(a) < previous_of(b); });
  auto other = by_previous.begin();
  for (const std::int32_t i : by_next) {
    while (other != by_previous.end() && previous_of(*other) < next_of(i)) ++other;
    if (other == by_previous.end() || previous_of(*other) != next_of(i)) continue;
    at(fan, i).after = *other;
    at(fan, *other).before = i;
    ++other;
  }
}

// What one thread reuses from point to point.
struct Workspace {
  std::vector<Corner> fan;
  Places by_next, by_previous, waiting, group;
};

// Collects the seed's group: from corner to corner across edges, as far as triangles wind alike.
void collect_group(std::int32_t seed, Workspace& work) {
  const bool mirrored = at(work.fan, seed).mirrored;
  work.group.clear();
  work.waiting.assign(1, seed);
  while (!work.waiting.empty()) {
    const std::int32_t i = work.waiting.back();
    work.waiting.pop_back();
    if (i == nobody) continue;
    Corner& corner = at(work.fan, i);
    if (corner.grouped || (!corner.blank && corner.mirrored != mirrored)) continue;
    corner.grouped = true;
    work.group.push_back(i);
    work.waiting.push_back(corner.before);
    work.waiting.push_back(corner.after);
  }
}

CornerTangent tangent_of_group(const Workspace& work, const Vec3& normal) {
  Vec3 sum(0);
  for (const std::int32_t i : work.group) {
    const Corner& corner = at(work.fan, i);
    if (!corner.blank) sum += corner.angle * across(normal, corner.along_u);
  }
  const bool mirrored = at(work.fan, work.group.front()).mirrored;
  return packed_tangent(Vec4f(Vec3f(unit_or_zero(sum)), mirrored ? -1.0F : 1.0F));
}

// Those around one point.
void set_tangents(const Vec3& normal, Workspace& work, std::vector<CornerTangent>& tangents) {
  std::vector<Corner>& fan = work.fan;
  find_neighbours(fan, work.by_next, work.by_previous);
  CornerTangent first{};
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if (fan[i].flat || fan[i].blank || fan[i].grouped) continue;
    collect_group(static_cast<std::int32_t>(i), work);
    const CornerTangent tangent = tangent_of_group(work, normal);
    for (const std::int32_t j : work.group) tangents[at(fan, j).index] = tangent;
    if (first == CornerTangent{}) first = tangent;
  }
  for (const Corner& corner : fan) {
    if (corner.flat) tangents[corner.index] = first;
  }
}

}  // namespace

CornerTangent packed_tangent(const Vec4f& tangent) {
  const auto part = [](float component) {
    return static_cast<std::int16_t>(std::lround(32767.0F * std::clamp(component, -1.0F, 1.0F)));
  };
  if (Vec3f(tangent) == Vec3f(0)) return {};
  const std::int16_t sign = tangent.w < 0 ? -1 : 1;
  return {part(tangent.x), part(tangent.y), part(tangent.z), sign};
}

std::vector<CornerTangent> corner_tangents(const Mesh& mesh, int uv_set,
                                           const UvTransform& transform) {
  const auto set = static_cast<std::size_t>(uv_set);
  if (set >= mesh.uvs.size() || mesh.uvs[set].empty()) return {};
  const TangentPoints points(mesh, uv_set, transform);
  const std::vector<std::uint32_t> weld = welded(points);
  const Fans fans = fans_of(points, weld);
  std::vector<CornerTangent> tangents(points.corner_count(), CornerTangent{});
  const std::size_t count = points.count();
  parallel_for((count + points_at_once - 1) / points_at_once, [&](std::size_t part) {
    Workspace work;
    const std::size_t end = std::min(count, (part + 1) * points_at_once);
    for (std::size_t point = part * points_at_once; point < end; ++point) {
      work.fan.clear();
      for (std::uint32_t i = fans.first[point]; i < fans.first[point + 1]; ++i) {
        work.fan.push_back(corner_at(points, weld, fans.corners[i]));
      }
      if (work.fan.empty()) continue;
      set_tangents(Vec3(points.normal(static_cast<std::uint32_t>(point))), work, tangents);
    }
  });
  return tangents;
}

}  // namespace restframe
