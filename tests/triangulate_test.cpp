#include "importers/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace restframe {
namespace {

using Points = std::vector<Vec3>;

constexpr double pi = std::numbers::pi;

Points flat(std::initializer_list<glm::dvec2> corners) {
  Points result;
  for (const glm::dvec2& p : corners) result.emplace_back(p, 0.0);
  return result;
}

double signed_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::cross(b - a, c - a).z / 2;
}

// By the shoelace formula.
double area_of(const Points& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += (a.x * b.y - b.x * a.y) / 2;
  }
  return sum;
}

// In the plane z = 0, counter-clockwise: no triangle is turned over, so that each point is covered
// as often as the polygon winds around it, which their areas confirm.
void expect_covered(const Points& polygon, double tolerance = 1e-9) {
  std::vector<Triangle> triangles;
  PolygonCutter cutter;
  cutter.cut(polygon, triangles);
  EXPECT_FALSE(cutter.exhausted());
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  const double whole = area_of(polygon);
  double sum = 0;
  for (const Triangle& t : triangles) {
    const double area = signed_area(polygon.at(t[0]), polygon.at(t[1]), polygon.at(t[2]));
    EXPECT_GE(area, -tolerance * whole);
    sum += std::abs(area);
  }
  EXPECT_NEAR(sum, whole, tolerance * whole);
}

// Also with every other corner as the first one, and mirrored.
void expect_covered_from_any_corner(Points polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    expect_covered(polygon);
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
  std::reverse(polygon.begin(), polygon.end());
  for (Vec3& p : polygon) p.x = -p.x;
  expect_covered(polygon);
}

const Points l_shape = flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});

Points comb(int teeth) {
  Points result = flat({{2.0 * teeth, 0}, {2.0 * teeth, 1}});
  for (int i = teeth; i-- > 0;) {
    result.emplace_back(2 * i + 1.5, 9, 0);
    result.emplace_back(2 * i + 0.1, 1, 0);
  }
  result.emplace_back(0, 0, 0);
  return result;
}

Points spiral(int corners) {
  Points result;
  for (const double inner : {0.0, 1.0}) {
    for (int i = 0; i < corners / 2; ++i) {
      const int step = inner > 0 ? corners / 2 - 1 - i : i;
      const double phi = 20 * pi * step / corners, r = 3 + phi - inner;
      result.emplace_back(r * std::cos(phi), r * std::sin(phi), 0);
    }
  }
  return result;
}

TEST(PolygonCutter, ConcavePolygons) {
  expect_covered_from_any_corner(l_shape);
  expect_covered_from_any_corner(comb(5));
  expect_covered_from_any_corner(spiral(100));
}

TEST(PolygonCutter, CornersOnStraightEdges) {
  expect_covered_from_any_corner(
      flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3}, {2, 3}, {0, 3}, {0, 2}, {0, 1}}));
  expect_covered_from_any_corner(
      flat({{0, 0}, {1, 0}, {2, 0}, {2, 0.5}, {2, 1}, {1.5, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}}));
  expect_covered_from_any_corner(flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}}));
}

TEST(PolygonCutter, RepeatedCorners) {
  Points twice;
  for (const Vec3& p : l_shape) twice.insert(twice.end(), 2, p);
  expect_covered_from_any_corner(twice);
  Points often = l_shape;
  often.insert(often.begin() + 3, 7, l_shape[3]);
  expect_covered_from_any_corner(often);
}

// Spikes without width, into the polygon and out of it.
TEST(PolygonCutter, Spikes) {
  expect_covered_from_any_corner(flat({{0, 0}, {2, 0}, {1, 1}, {2, 0}, {2, 2}, {0, 2}}));
  expect_covered_from_any_corner(flat({{0, 0}, {2, 0}, {4, -1}, {2, 0}, {2, 2}, {0, 2}}));
  expect_covered_from_any_corner(
      flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1.5, 1.5}, {1, 1}, {1, 2}, {0, 2}}));
}

// As programs write faces with holes: along a bridge to the hole, around it, and back.
TEST(PolygonCutter, BridgesToHoles) {
  expect_covered_from_any_corner(
      flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}));
  expect_covered_from_any_corner(flat({{0, 0},
                                       {9, 0},
                                       {9, 3},
                                       {0, 3},
                                       {0, 0},
                                       {1, 1},
                                       {1, 2},
                                       {2, 2},
                                       {2, 1},
                                       {6, 1},
                                       {6, 2},
                                       {7, 2},
                                       {7, 1},
                                       {2, 1},
                                       {1, 1}}));
}

// Two squares with one corner in common; a square whose notch touches the other side.
TEST(PolygonCutter, PolygonsThatTouchThemselves) {
  expect_covered_from_any_corner(
      flat({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}));
  expect_covered_from_any_corner(
      flat({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1.5, 2}, {1, 0}, {0.5, 2}, {0, 2}}));
}

TEST(PolygonCutter, TenThousandCorners) {
  expect_covered(comb(5000));
  expect_covered(spiral(10'000));
  Points strip;  // ears at its ends only, but for triangles as long as itself
  for (int i = 0; i < 7000; ++i) strip.emplace_back(i, 0, 0);
  for (int i = 3000; i-- > 0;) strip.emplace_back(i * 7.0 / 3.0, 1, 0);
  expect_covered(strip);
  Points star;
  for (int i = 0; i < 10'000; ++i) {
    const double phi = 2 * pi * i / 10'000, r = i % 2 == 0 ? 1 : 0.3 + 0.2 * std::sin(17.0 * i);
    star.emplace_back(r * std::cos(phi), r * std::sin(phi), 0);
  }
  expect_covered(star);
  Points circle;
  for (int i = 0; i < 10'000; ++i) {
    circle.emplace_back(std::cos(2 * pi * i / 10'000), std::sin(2 * pi * i / 10'000), 0);
  }
  expect_covered(circle);
}

TEST(PolygonCutter, SizeAndPlaceDoNotMatter) {
  for (const double scale : {1e-30, 1e-6, 1e6, 1e14}) {
    Points polygon = l_shape;
    for (Vec3& p : polygon) p *= scale;
    expect_covered(polygon);
  }
  Points far = l_shape;
  for (Vec3& p : far) p += Vec3(1e7, -1e7, 0);
  expect_covered(far, 1e-6);
}

// Bent out of its plane, an L is still cut as seen along its Newell normal: no triangle's normal
// points the other way.
TEST(PolygonCutter, PolygonsOutOfPlane) {
  Points bent = l_shape;
  for (std::size_t i = 0; i < bent.size(); ++i) bent[i].z = i % 2 == 0 ? 0.2 : -0.2;
  std::vector<Triangle> triangles;
  PolygonCutter().cut(bent, triangles);
  ASSERT_EQ(triangles.size(), 4U);
  for (const Triangle& t : triangles) EXPECT_GT(signed_area(bent[t[0]], bent[t[1]], bent[t[2]]), 0);
}

// Nothing to be right about, but all triangles are there and name corners.
TEST(PolygonCutter, PolygonsThatHaveNoProperCut) {
  const Points polygons[] = {flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
                             flat({{0, 0}, {3, 0}, {3, 3}, {1, -1}, {2, -1}, {0, 3}}),
                             flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 0}}),
                             Points(9, Vec3(1, 2, 3)),
                             flat({{0, 0}, {4, 4}, {4, 0}, {0, 4}, {-1, 2}, {5, 2}, {2, -1}})};
  for (const Points& polygon : polygons) {
    std::vector<Triangle> triangles;
    PolygonCutter().cut(polygon, triangles);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    for (const Triangle& t : triangles) {
      EXPECT_LT(*std::max_element(t.begin(), t.end()), polygon.size());
    }
  }
}

}  // namespace
}  // namespace restframe
