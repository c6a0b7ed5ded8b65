// Closedness: which meshes light finds its way out of.

#include "scene/mesh_closed.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scene/generators.h"
#include "support/scene_reading.h"
#include "support/triangle_mesh.h"

namespace restframe {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Mesh tetrahedron() {
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

// Every triangle with three vertices of its own, as flat shading splits them.
Mesh split(const Mesh& mesh) {
  Mesh result = mesh_of({}, {});
  for (const Triangle& t : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(result.positions.size());
    for (const std::uint32_t corner : t) result.positions.push_back(mesh.positions[corner]);
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

// A band of triangles whose end meets its beginning turned by `half_turns`.
Mesh band(int half_turns) {
  constexpr std::uint32_t steps = 12;
  Mesh mesh = mesh_of({}, {});
  for (std::uint32_t i = 0; i <= steps; ++i) {
    const double around = 2 * 3.14159265358979 * i / steps, turn = around * half_turns / 2;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(turn);
      mesh.positions.emplace_back(r * std::cos(around), r * std::sin(around),
                                  side * std::sin(turn));
    }
  }
  // The last two vertices are the first two, exchanged after an odd number of half turns.
  for (std::uint32_t i = 0; i < 2; ++i) {
    mesh.positions[2 * steps + i] = mesh.positions[half_turns % 2 == 0 ? i : 1 - i];
  }
  for (std::uint32_t i = 0; i < 2 * steps; i += 2) {
    mesh.triangles.push_back({i, i + 1, i + 2});
    mesh.triangles.push_back({i + 1, i + 3, i + 2});
  }
  return mesh;
}

TEST(MeshClosed, Bodies) {
  EXPECT_TRUE(is_closed(tetrahedron()));
  EXPECT_TRUE(is_closed(make_ball({1, 0})));
  EXPECT_TRUE(is_closed(make_ball({0.15, 4})));
}

TEST(MeshClosed, VerticesOfOnePositionAreOne) {
  EXPECT_TRUE(is_closed(split(tetrahedron())));
  EXPECT_TRUE(is_closed(split(make_ball({1, 2}))));
  Mesh mesh = split(tetrahedron());
  for (Vec3f& p : mesh.positions) {
    if (p.x == 0 && &p != &mesh.positions[0]) p.x = -0.0F;
  }
  EXPECT_TRUE(is_closed(mesh)) << "-0 is 0";
  mesh.positions[0].x = 1e-6F;
  EXPECT_FALSE(is_closed(mesh)) << "a crack is a crack";
}

TEST(MeshClosed, OpenOnes) {
  EXPECT_FALSE(is_closed(mesh_of({}, {})));
  EXPECT_FALSE(is_closed(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})));
  EXPECT_FALSE(is_closed(make_rod(0.1, 1, 16)));
  EXPECT_FALSE(is_closed(make_lattice({}, true).meshes.at(0)));
  Mesh ball = make_ball({1, 3});
  ball.triangles.pop_back();
  EXPECT_FALSE(is_closed(ball));
}

TEST(MeshClosed, AFlippedFace) {
  for (std::size_t face = 0; face < 4; ++face) {
    Mesh mesh = tetrahedron();
    std::swap(mesh.triangles[face][0], mesh.triangles[face][1]);
    EXPECT_FALSE(is_closed(mesh)) << face;
  }
  Mesh inside_out = tetrahedron();
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  EXPECT_TRUE(is_closed(inside_out)) << "a hollow";
}

// A band with both its sides as faces has an inside that is no body, but for the Moebius band even
// that can not be wound alike.
TEST(MeshClosed, BandsAreOpen) {
  EXPECT_FALSE(is_closed(band(0)));
  EXPECT_FALSE(is_closed(band(1)));
}

TEST(MeshClosed, FourFacesAtAnEdge) {
  // Two tetrahedra that share an edge: which side light comes out of is undetermined there.
  Mesh mesh = tetrahedron();
  for (const Vec3f& p : {Vec3f(0, 0, 0), Vec3f(-1, 0, 0), Vec3f(0, -1, 0), Vec3f(0, 0, 1)}) {
    mesh.positions.push_back(p);
  }
  for (const Triangle& t : tetrahedron().triangles) {
    mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  }
  EXPECT_FALSE(is_closed(mesh));
  for (std::size_t i = 4; i < 8; ++i) mesh.positions[i].x -= 5;
  EXPECT_TRUE(is_closed(mesh)) << "apart they are two bodies";
}

TEST(MeshClosed, TheSameFaceTwiceOrBothWays) {
  Mesh doubled = tetrahedron();
  doubled.triangles.push_back(doubled.triangles[0]);
  EXPECT_FALSE(is_closed(doubled));
  Mesh sheet = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_TRUE(is_closed(sheet)) << "of no thickness, but what goes in comes out";
}

TEST(MeshClosed, TrianglesThatAreLinesDoNotCount) {
  Mesh mesh = tetrahedron();
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({2, 2, 2});
  EXPECT_TRUE(is_closed(mesh));
}

TEST(MeshClosed, OneMaterialAlone) {
  Mesh mesh = tetrahedron();
  mesh.triangles.push_back({1, 2, 3});
  mesh.materials = {{0, 3}, {4, 0}};
  EXPECT_FALSE(is_closed(mesh));
  EXPECT_TRUE(is_closed(mesh, 3));
  EXPECT_FALSE(is_closed(mesh, 0));
  EXPECT_FALSE(is_closed(mesh, 7));
}

class OpenGlass : public SceneReading {
 protected:
  static std::string paint(const std::string& key) {
    return "[[object]]\nname = \"pane\"\nasset = \"paint.obj\"\n[[object]]\nname = \"ball\"\n"
           "sphere = {}\nmaterial = \"paint\"\n[[material]]\nname = \"paint\"\n" +
           key;
  }
};

TEST_F(OpenGlass, IsWarnedOf) {
  read(paint("transmission = 0.5\n"));
  ASSERT_THAT(warnings, SizeIs(1));
  for (const char* words : {"scene.toml: object \"pane\": material \"paint\"",
                            "its mesh is not closed", "refraction needs closed meshes"}) {
    EXPECT_THAT(warnings[0], HasSubstr(words));
  }
}

TEST_F(OpenGlass, ThatMayTransmitIsWarnedOf) {
  read(paint("transmission = {keys = [[0, 0], [1, 1]]}\n"));
  EXPECT_THAT(warnings, SizeIs(1));
}

TEST_F(OpenGlass, ThatDoesNotTransmitIsFine) {
  read(paint("ior = 1.7\ntransmission = 0\n"));
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(OpenGlass, ManyObjectsAreOneWarning) {
  std::string text = paint("transmission = 1\n");
  for (const char* name : {"a", "b"}) {
    text += std::string("[[object]]\nasset = \"paint.obj\"\nname = \"") + name + "\"\n";
  }
  read(text);
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_THAT(warnings[0], HasSubstr("object \"pane\" and 2 more"));
}

}  // namespace
}  // namespace restframe
