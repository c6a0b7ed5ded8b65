// Closed surfaces turned outwards: cubes, whose volume is known, wound in every way.

#include "importers/orientation.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "scene/mesh_closed.h"
#include "support/mesh_reading.h"

namespace restframe {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The corners of a cube's face where coordinate `axis` is `side`, outwards counter-clockwise.
std::array<Vec3f, 4> cube_face(int axis, int side) {
  std::array<Vec3f, 4> corners;
  for (int i = 0; i < 4; ++i) {
    const int turn = side > 0 ? i : 3 - i;
    Vec3f corner;
    corner[axis] = static_cast<float>(side);
    corner[(axis + 1) % 3] = turn == 0 || turn == 3 ? -1.0F : 1.0F;
    corner[(axis + 2) % 3] = turn < 2 ? -1.0F : 1.0F;
    corners[static_cast<std::size_t>(i)] = corner;
  }
  return corners;
}

// A cube of half edge `half` around `center`, each triangle with three vertices of its own. Bit t of
// `turned` turns triangle t over.
void add_cube(Mesh& mesh, const Vec3f& center, float half, unsigned turned = 0) {
  unsigned number = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const auto corners = cube_face(axis, side);
      for (const auto& pick : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const int i : pick)
          mesh.positions.push_back(center + half * corners[static_cast<std::size_t>(i)]);
        const bool turn = (turned >> number++ & 1U) != 0;
        mesh.triangles.push_back({first, first + (turn ? 2 : 1), first + (turn ? 1 : 2)});
      }
    }
  }
}

// By the divergence theorem.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

constexpr unsigned all_turned = 0xFFF;

TEST(Orientation, OutwardsStays) {
  Mesh mesh;
  add_cube(mesh, Vec3f(0), 1);
  EXPECT_EQ(orient_outwards(mesh), 0U);
  EXPECT_DOUBLE_EQ(volume(mesh), 8);
}

TEST(Orientation, EachWayToWindACube) {
  for (unsigned turned = 0; turned <= all_turned; turned += 7) {
    Mesh mesh;
    add_cube(mesh, Vec3f(5, -3, 2), 0.5F, turned);
    EXPECT_EQ(orient_outwards(mesh), static_cast<std::size_t>(__builtin_popcount(turned)));
    EXPECT_NEAR(volume(mesh), 1, 1e-5) << turned;
    EXPECT_TRUE(is_closed(mesh));
  }
}

TEST(Orientation, FarFromTheOrigin) {
  Mesh mesh;
  add_cube(mesh, Vec3f(1e6F, 1e6F, -1e6F), 1, all_turned);
  EXPECT_EQ(orient_outwards(mesh), 12U);
}

TEST(Orientation, EachPartByItself) {
  Mesh mesh;
  add_cube(mesh, Vec3f(0), 1);
  add_cube(mesh, Vec3f(3, 0, 0), 1, all_turned);
  add_cube(mesh, Vec3f(0, 3, 0), 1, 0x0F0);
  EXPECT_EQ(orient_outwards(mesh), 16U);
  EXPECT_NEAR(volume(mesh), 24, 1e-5);
}

// 8 cubic units less the 1 of the cavity.
TEST(Orientation, CavitiesStay) {
  Mesh mesh;
  add_cube(mesh, Vec3f(0), 1, all_turned);
  add_cube(mesh, Vec3f(0.2F, 0, 0), 0.5F, all_turned);
  EXPECT_EQ(orient_outwards(mesh), 12U);
  EXPECT_NEAR(volume(mesh), 7, 1e-5);
}

// Within the bounds of a thin tent, but under it.
TEST(Orientation, BesideIsNotWithin) {
  Mesh mesh;
  const Vec3f a(-3, -3, 0), b(3, -3, 0), c(0, 3, 0), apex(0, 0, 3), pit(0, 0, 2.5F);
  mesh.positions = {a, b, c, apex, pit};
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  const double shell = volume(mesh);
  EXPECT_NEAR(shell, 18 * 0.5 / 3, 1e-5);  // base 18, heights 3 and 2.5
  add_cube(mesh, Vec3f(0, 0, 0.5F), 0.25F, all_turned);
  EXPECT_EQ(orient_outwards(mesh), 12U);
  EXPECT_NEAR(volume(mesh), shell + 0.125, 1e-5);
}

TEST(Orientation, MixedWithinFollowsTheMost) {
  Mesh mesh;
  add_cube(mesh, Vec3f(0), 1);
  add_cube(mesh, Vec3f(0), 0.5F, all_turned & ~0x3U);
  EXPECT_EQ(orient_outwards(mesh), 2U);
  EXPECT_NEAR(volume(mesh), 7, 1e-5);
  EXPECT_TRUE(is_closed(mesh));
}

TEST(Orientation, OpenSurfacesStay) {
  Mesh mesh;
  add_cube(mesh, Vec3f(0), 1, 0x555);
  mesh.triangles.pop_back();
  const std::vector<Triangle> before = mesh.triangles;
  EXPECT_EQ(orient_outwards(mesh), 0U);
  EXPECT_EQ(mesh.triangles, before);
}

// A fin on an edge of a cube: three triangles share it.
TEST(Orientation, EdgesOfThreeStay) {
  Mesh mesh;
  add_cube(mesh, Vec3f(0), 1, all_turned);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {Vec3f(1, 1, -1), Vec3f(1, 1, 1), Vec3f(3, 3, 0)});
  mesh.triangles.push_back({first, first + 1, first + 2});
  EXPECT_EQ(orient_outwards(mesh), 0U);
}

// The projective plane of six vertices: closed, but of one side.
TEST(Orientation, OneSidedSurfacesStay) {
  Mesh mesh;
  for (int i = 0; i < 6; ++i) {
    const float angle = 1.1F * static_cast<float>(i);
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.3F * static_cast<float>(i));
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                    {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  const std::vector<Triangle> before = mesh.triangles;
  EXPECT_EQ(orient_outwards(mesh), 0U);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(Orientation, TrianglesWithoutAreaDoNotCount) {
  Mesh mesh;
  add_cube(mesh, Vec3f(0), 1, all_turned);
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(orient_outwards(mesh), 12U);
  EXPECT_EQ(orient_outwards(mesh), 0U);
}

TEST(Orientation, NothingAtAll) {
  Mesh mesh;
  EXPECT_EQ(orient_outwards(mesh), 0U);
}

// Many surfaces inside out, all within each other's bounds: bounded work.
TEST(Orientation, ManySurfaces) {
  Mesh mesh;
  for (int i = 0; i < 3000; ++i)
    add_cube(mesh, Vec3f(0), 1 + 0.01F * static_cast<float>(i), all_turned);
  EXPECT_EQ(orient_outwards(mesh), 12U);
}

class OrientedFiles : public test::MeshReading {};

// Two triangles of a cube are the wrong way round in the file.
TEST_F(OrientedFiles, AreTurnedAndTold) {
  const std::string cube =
      "OFF\n8 6 0\n-1 -1 1\n1 -1 1\n-1 1 1\n1 1 1\n-1 1 -1\n1 1 -1\n-1 -1 -1\n"
      "1 -1 -1\n4 0 1 3 2\n4 2 3 5 4\n4 4 5 7 6\n4 6 7 1 0\n4 1 7 5 3\n";
  const Mesh read = mesh_of("mesh.off", cube + "4 2 0 6 4\n");
  EXPECT_NEAR(volume(read), 8, 1e-6);
  EXPECT_TRUE(is_closed(read));
  EXPECT_THAT(told(),
              ElementsAre(": 2 triangles of closed surfaces were turned over, to face outwards"));
  for (std::size_t i = 0; i < read.positions.size(); ++i) {
    EXPECT_GT(glm::dot(read.positions[i], read.normals[i]), 0.5F);
  }
}

// A tetrahedron inside out, beside a good one; its volume is a sixth.
TEST_F(OrientedFiles, OfObj) {
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 3 2 4\n"
      "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -2 -1 -3\n";
  EXPECT_NEAR(volume(mesh_of("mesh.obj", obj)), 2 / 6.0, 1e-6);
  EXPECT_THAT(told(),
              ElementsAre(": 4 triangles of closed surfaces were turned over, to face outwards"));
}

// Normals say which side is out.
TEST_F(OrientedFiles, WithNormalsAreLeftAlone) {
  const std::string tetrahedron =
      "NOFF\n4 4 0\n0 0 0 1 1 1\n1 0 0 -1 0 0\n0 1 0 0 -1 0\n0 0 1 0 0 -1\n"
      "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 2 1 3\n";
  EXPECT_LT(volume(mesh_of("mesh.off", tetrahedron)), 0);
  EXPECT_THAT(told(), IsEmpty());
}

}  // namespace
}  // namespace restframe
