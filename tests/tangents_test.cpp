// Generated tangents against closed forms: T = dP/dU, made perpendicular to the normal, and the side
// on which textures have their upper edge.

#include "scene/tangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "support/long_vectors.h"

namespace restframe {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 5e-5;  // of 16 bits

struct SurfacePoint {
  Vec3 position, normal;
};

// A grid of columns x rows squares over (x, y) in 0..1, each cut in two.
struct Grid {
  int columns = 4, rows = 4;
  std::function<SurfacePoint(double x, double y)> surface;
  std::function<glm::dvec2(double x, double y)> uv;
};

Mesh mesh_of(const Grid& grid, bool with_normals = true) {
  Mesh mesh;
  for (int j = 0; j <= grid.rows; ++j) {
    for (int i = 0; i <= grid.columns; ++i) {
      const double x = static_cast<double>(i) / grid.columns;
      const double y = static_cast<double>(j) / grid.rows;
      const SurfacePoint point = grid.surface(x, y);
      mesh.positions.emplace_back(point.position);
      if (with_normals) mesh.normals.emplace_back(point.normal);
      mesh.uvs[0].emplace_back(grid.uv(x, y));
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>(j * (grid.columns + 1) + i);
  };
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  mesh.materials = {{0, 0}};
  return mesh;
}

// z = 0, x to the right, y upwards, seen from the front.
SurfacePoint plane(double x, double y) {
  return {{x, y, 0}, {0, 0, 1}};
}

// As an image shows on it: v runs down.
glm::dvec2 upright(double x, double y) {
  return {x, 1 - y};
}

std::vector<CornerTangent> tangents_of(const Mesh& mesh) {
  return corner_tangents(mesh, 0, {});
}

void expect_all(const std::vector<CornerTangent>& tangents, const Vec3& expected, double sign) {
  ASSERT_FALSE(tangents.empty());
  for (const CornerTangent& t : tangents) {
    ASSERT_LT(glm::distance(Vec3(Vec3f(unpacked(t))), expected), rounding);
    ASSERT_EQ(unpacked(t).w, sign);
  }
}

TEST(Tangents, OfAPlane) {
  expect_all(tangents_of(mesh_of({3, 2, plane, upright})), {1, 0, 0}, 1);
  // A picture that is seen from its back, and one that stands on its head.
  expect_all(tangents_of(mesh_of(
                 {3, 2, plane, [](double x, double y) { return glm::dvec2(1 - x, 1 - y); }})),
             {-1, 0, 0}, -1);
  expect_all(
      tangents_of(mesh_of({3, 2, plane, [](double x, double y) { return glm::dvec2(x, y); }})),
      {1, 0, 0}, -1);
}

// uv = A (x, y): the point that moves by (dx, dy) = A^-1 (1, 0) is where U alone grows.
TEST(Tangents, OfTurnedAndShearedCoordinates) {
  for (const auto& [a, b, c, d] : {std::array{0.6, 0.8, -0.8, 0.6},
                                   {2.0, 0.7, 0.1, -0.5},
                                   {-1.0, 3.0, 0.2, 0.4},
                                   {0.0, 5.0, 0.3, 0.0}}) {
    const auto uv = [a = a, b = b, c = c, d = d](double x, double y) {
      return glm::dvec2(a * x + b * y, c * x + d * y);
    };
    const double determinant = a * d - b * c;
    const Vec3 along_u = glm::normalize(Vec3(d, -c, 0) / determinant);
    // V points down on images: where (x, y) to (u, v) keeps the orientation, they are mirrored.
    expect_all(tangents_of(mesh_of({2, 3, plane, uv})), along_u, determinant > 0 ? -1 : 1);
  }
}

// The coordinates that a material's transform makes of the mesh's are those that count.
TEST(Tangents, FollowTheTransformOfATexture) {
  const Mesh mesh = mesh_of({2, 2, plane, upright});
  const UvTransform quarter{{0, -1}, {1, 0}, {0.3F, 0.7F}};  // u' = v, v' = -u
  expect_all(corner_tangents(mesh, 0, quarter), {0, -1, 0}, 1);
  const UvTransform mirrored{{-2, 0}, {0, 1}, {0, 0}};
  expect_all(corner_tangents(mesh, 0, mirrored), {-1, 0, 0}, -1);
}

TEST(Tangents, NeedTheUvSet) {
  const Mesh mesh = mesh_of({2, 2, plane, upright});
  EXPECT_TRUE(corner_tangents(mesh, 1, {}).empty());
  EXPECT_TRUE(corner_tangents(mesh, 7, {}).empty());
}

// u is the longitude: along +U lies the east, upwards the north.
SurfacePoint sphere(double x, double y) {
  const double longitude = 2 * pi * x, latitude = pi * (y - 0.5);
  const Vec3 p(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
               std::cos(latitude) * std::cos(longitude));
  return {p, p};
}

TEST(Tangents, OfASpherePointEast) {
  const Mesh mesh = mesh_of({96, 48, sphere, upright});
  const std::vector<CornerTangent> tangents = tangents_of(mesh);
  int checked = 0;
  for (std::size_t c = 0; c < tangents.size(); ++c) {
    const std::uint32_t vertex = mesh.triangles[c / 3][c % 3];
    const Vec3 n(mesh.normals[vertex]);
    const Vec4f t = unpacked(tangents[c]);
    if (std::abs(n.y) > 0.999) continue;  // the poles, where east is everywhere
    const Vec3 east = glm::normalize(glm::cross(Vec3(0, 1, 0), n));
    ++checked;
    ASSERT_NEAR(glm::dot(Vec3(Vec3f(t)), n), 0, 1e-4);
    // Facets see it to second order in their 1/15 radians; at the seam one side is missing.
    ASSERT_GT(glm::dot(Vec3(Vec3f(t)), east), std::cos(0.04));
    ASSERT_EQ(t.w, 1);
  }
  EXPECT_GT(checked, 20'000);
}

// Around a cylinder whose last column of vertices lies on the first, with u = 1 in place of 0: the
// seam's two sides do not mix. With u = 0 on both the last column's picture runs backwards.
SurfacePoint cylinder(double x, double y) {
  const Vec3 radius(std::sin(2 * pi * x), 0, std::cos(2 * pi * x));
  return {radius + Vec3(0, y, 0), radius};
}

TEST(Tangents, AtACylindersSeam) {
  constexpr int columns = 12;
  const Mesh mesh = mesh_of({columns, 2, cylinder, upright});
  const std::vector<CornerTangent> tangents = tangents_of(mesh);
  for (std::size_t c = 0; c < tangents.size(); ++c) {
    const std::uint32_t vertex = mesh.triangles[c / 3][c % 3];
    const auto column = static_cast<int>(vertex % (columns + 1));
    const Vec3 east = glm::cross(Vec3(0, 1, 0), Vec3(mesh.normals[vertex]));
    // Every facet's own direction lies half a facet beside the east of its corners; projected on the
    // plane across the normal both are the east, on a seam as elsewhere.
    ASSERT_LT(glm::distance(Vec3(Vec3f(unpacked(tangents[c]))), east), 2 * rounding) << column;
    ASSERT_EQ(unpacked(tangents[c]).w, 1);
  }
}

// Left half mirrored: u falls from 1 to 0, then rises. On the line between them, normals and
// coordinates are the same, but nothing is shared.
TEST(Tangents, MirroredHalvesDoNotMix) {
  const auto uv = [](double x, double y) { return glm::dvec2(std::abs(2 * x - 1), 1 - y); };
  const Mesh mesh = mesh_of({4, 3, plane, uv});
  const std::vector<CornerTangent> tangents = tangents_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    float middle = 0;
    for (const std::uint32_t vertex : mesh.triangles[t]) middle += mesh.positions[vertex].x / 3;
    const float side = middle < 0.5F ? -1.0F : 1.0F;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec4f tangent = unpacked(tangents[3 * t + i]);
      ASSERT_LT(glm::distance(tangent, Vec4f(side, 0, 0, side)), rounding);
    }
  }
}

// Without normals each facet has its own: the directions of a roof's sides do not mix.
TEST(Tangents, OfFlatFacets) {
  const auto roof = [](double x, double y) {
    return SurfacePoint{{x, y, x < 0.5 ? x : 1 - x}, {0, 0, 1}};
  };
  const Mesh mesh = mesh_of({2, 2, roof, upright}, false);
  const std::vector<CornerTangent> tangents = tangents_of(mesh);
  for (std::size_t c = 0; c < tangents.size(); ++c) {
    const bool left = (c / 6) % 2 == 0;
    const Vec3 expected = glm::normalize(Vec3(1, 0, left ? 1 : -1));
    ASSERT_LT(glm::distance(Vec3(Vec3f(unpacked(tangents[c]))), expected), rounding) << c;
  }
}

// A bent, unevenly cut surface, each corner worked out anew from the definition: all triangles at the
// vertex, in the plane across its normal, by the angle that their corners have there.
TEST(Tangents, AreWeightedByTheCornersAngles) {
  const auto hill = [](double x, double y) {
    const double a = x * x, b = y * (0.5 + 0.5 * x);
    const double dz_da = 0.9 * std::cos(3 * a), dz_db = -0.8 * std::sin(2 * b);
    return SurfacePoint{{a, b, 0.3 * std::sin(3 * a) + 0.4 * std::cos(2 * b)},
                        glm::normalize(Vec3(-dz_da, -dz_db, 1))};
  };
  const auto uv = [](double x, double y) {
    return glm::dvec2(x + 0.3 * y * y, 1 - y + 0.2 * x * x);
  };
  const Mesh mesh = mesh_of({7, 5, hill, uv});
  std::map<std::uint32_t, reference::Long3> sums;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t o = t[i], p = t[(i + 1) % 3], q = t[(i + 2) % 3];
      const auto wide = [&](std::uint32_t vertex) {
        return reference::widened(Vec3(mesh.positions[vertex]));
      };
      const reference::Long3 n = reference::widened(Vec3(mesh.normals[o]));
      const reference::Long3 e1 = wide(p) - wide(o), e2 = wide(q) - wide(o);
      const glm::dvec2 w1(mesh.uvs[0][p] - mesh.uvs[0][o]), w2(mesh.uvs[0][q] - mesh.uvs[0][o]);
      const long double area = static_cast<long double>(w1.x) * w2.y - w1.y * w2.x;
      const auto flat = [&](const reference::Long3& v) {
        const reference::Long3 in_plane = v - dot(n, v) * n;
        return in_plane / reference::length(in_plane);
      };
      // dP/dU of the triangle's affine map.
      const reference::Long3 along_u = (static_cast<long double>(w2.y) / area) * e1 -
                                       (static_cast<long double>(w1.y) / area) * e2;
      const long double angle = std::acos(dot(flat(e1), flat(e2)));
      sums[o] = sums[o] + angle * flat(along_u);
    }
  }
  const std::vector<CornerTangent> tangents = tangents_of(mesh);
  for (std::size_t c = 0; c < tangents.size(); ++c) {
    const reference::Long3& sum = sums[mesh.triangles[c / 3][c % 3]];
    const Vec3 expected = reference::narrowed(sum / reference::length(sum));
    ASSERT_LT(glm::distance(Vec3(Vec3f(unpacked(tangents[c]))), expected), rounding);
  }
}

// Vertices that are stored apart, but are the same, share their tangents.
TEST(Tangents, DoNotDependOnHowVerticesAreStored) {
  const Mesh shared = mesh_of({6, 4, sphere, upright});
  std::vector<std::uint32_t> corners;
  for (const Triangle& t : shared.triangles) corners.insert(corners.end(), t.begin(), t.end());
  Mesh apart = shared;
  take_vertices(shared, corners, apart);
  for (std::uint32_t i = 0; i < corners.size(); ++i) apart.triangles[i / 3][i % 3] = i;
  EXPECT_EQ(tangents_of(shared), tangents_of(apart));
}

// Where two corners are in one place, a triangle's corners take what others have there; where the
// texture coordinates have no area, and nothing is near, there is no tangent.
TEST(Tangents, OfDegenerateTriangles) {
  Mesh mesh = mesh_of({2, 2, plane, upright});
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.push_back({4, 4, 4});
  expect_all(tangents_of(mesh), {1, 0, 0}, 1);

  Mesh point = mesh_of({1, 1, plane, [](double, double) { return glm::dvec2(0.5); }});
  for (const CornerTangent& t : tangents_of(point)) EXPECT_EQ(unpacked(t), Vec4f(0));

  Mesh both = mesh_of(
      {2, 1, plane, [](double x, double y) { return glm::dvec2(std::min(x, 0.5), 1 - y); }});
  const std::vector<CornerTangent> tangents = tangents_of(both);
  for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(unpacked(tangents[c]), Vec4f(1, 0, 0, 1));
}

// Many triangles around one point, and many on one edge: no time is lost.
TEST(Tangents, OfHostileMeshesTakeLinearTime) {
  Mesh mesh;
  constexpr std::uint32_t count = 200'000;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}};
  mesh.uvs[0] = {{0, 0}, {0, 1}};
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.uvs[0].emplace_back(static_cast<float>(i % 7), 0.5F);
    mesh.triangles.push_back({0, 1, i + 2});
    mesh.triangles.push_back({0, i + 2, (i + 1) % count + 2});
  }
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  EXPECT_EQ(tangents_of(mesh).size(), 6U * count);
}

}  // namespace
}  // namespace restframe
