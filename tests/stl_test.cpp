// STL files, text and binary: right ones and wrong ones.

#include <gmock/gmock.h>

#include <array>

#include "scene/mesh_closed.h"
#include "support/mesh_reading.h"

namespace restframe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Facet = std::array<Vec3f, 3>;

std::string text_facet(const Facet& corners, const std::string& normal = "0 0 0") {
  std::string result = " facet normal " + normal + "\n  outer loop\n";
  for (const Vec3f& c : corners) {
    result += "   vertex " + std::to_string(c.x) + " " + std::to_string(c.y) + " " +
              std::to_string(c.z) + "\n";
  }
  return result + "  endloop\n endfacet\n";
}

std::string binary(const std::vector<Facet>& facets, const std::string& header = "made by a test",
                   std::uint16_t attribute = 0) {
  std::string bytes = header + std::string(80 - header.size(), '\0') +
                      test::bytes_of(static_cast<std::uint32_t>(facets.size()));
  for (const Facet& facet : facets) {
    bytes += std::string(12, '\0');
    for (const Vec3f& c : facet) {
      bytes += test::bytes_of(c.x) + test::bytes_of(c.y) + test::bytes_of(c.z);
    }
    bytes += test::bytes_of(attribute);
  }
  return bytes;
}

const Facet facet = {Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};

std::vector<Facet> tetrahedron() {
  const Vec3f o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

class Stl : public test::MeshReading {
 protected:
  Mesh mesh(const std::string& bytes) { return mesh_of("mesh.stl", bytes); }
  std::string fault(const std::string& bytes, const ImportLimits& limits = {}) {
    return fault_of("bad.stl", bytes, limits);
  }
};

TEST_F(Stl, ReadsBytes) {
  const Mesh read = mesh(binary({facet}));
  EXPECT_THAT(read.positions, ElementsAre(facet[0], facet[1], facet[2]));
  EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(read.normals, ElementsAre(Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0, 0, 1)));
  EXPECT_EQ(read.name, "mesh");
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Stl, BytesMayBeginWithSolid) {
  EXPECT_EQ(mesh(binary(tetrahedron(), "solid of bytes")).triangles.size(), 4U);
  EXPECT_EQ(mesh(binary({facet}, "solid" + std::string(75, ' '))).triangles.size(), 1U);
}

TEST_F(Stl, ReadsText) {
  const Mesh read = mesh("solid a part \n" + text_facet(facet) + "endsolid a part\n");
  EXPECT_THAT(read.positions, ElementsAre(facet[0], facet[1], facet[2]));
  EXPECT_EQ(read.name, "a part");
  EXPECT_EQ(mesh("\r\n SOLID\r\nFacet Normal nan NaN -nan\r\nOUTER LOOP vertex 0 0 0 vertex 1 0 0"
                 "\tvertex 0 1E0 0 EndLoop endfacet EndSolid")
                .name,
            "mesh");
}

TEST_F(Stl, SolidsAreMeshes) {
  const Asset asset =
      load("mesh.stl", "solid a\n" + text_facet(facet) +
                           "endsolid a\nsolid\n"
                           "endsolid\nsolid b\n" +
                           text_facet(facet) + text_facet({facet[0], facet[2], facet[1]}) +
                           "endsolid b\n");
  ASSERT_EQ(asset.meshes.size(), 2U);
  EXPECT_EQ(asset.meshes[0].triangles.size(), 1U);
  EXPECT_EQ(asset.meshes[1].triangles.size(), 2U);
  ASSERT_EQ(asset.parts.size(), 2U);
  EXPECT_EQ(name_of(asset, asset.parts[1]), "b");
  EXPECT_EQ(asset.parts[1].mesh, 1);
  EXPECT_EQ(asset.materials.size(), 1U);
  EXPECT_THAT(told(), ElementsAre(": 1 solids without facets, skipped"));
}

// Equal corners are one vertex: the solid is closed, and its four corners are sharp.
TEST_F(Stl, CornersAreWelded) {
  const Mesh read = mesh(binary(tetrahedron()));
  EXPECT_TRUE(is_closed(read));
  EXPECT_EQ(read.positions.size(), 12U);  // split again by the crease angle
}

// Two facets that fold by 10 degrees share their normals along the edge.
TEST_F(Stl, SmallFoldsAreSmooth) {
  const float s = std::sin(0.1745F), c = std::cos(0.1745F);
  const Mesh read = mesh(binary({{Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)},
                                 {Vec3f(0, 0, -0.0F), Vec3f(0, 1, 0), Vec3f(-c, 0, -s)}}));
  EXPECT_EQ(read.positions.size(), 4U);
  EXPECT_NEAR(read.normals[0].x, -std::sin(0.1745F / 2), 1e-3);
}

TEST_F(Stl, FacetsOfTextMayBePolygons) {
  const Mesh read = mesh(
      "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 "
      "vertex 1 1 0 vertex 0 1 0 endloop endfacet endsolid");
  EXPECT_EQ(read.triangles.size(), 2U);
  EXPECT_EQ(read.positions.size(), 4U);
}

TEST_F(Stl, WhatIsNotUsedIsTold) {
  mesh(binary({facet, {facet[0], facet[0], facet[1]}}, "", 0x8421) + "more");
  EXPECT_THAT(
      told(),
      ElementsAre(": byte 184: 4 bytes after the last triangle are not used",
                  ": 2 triangles have attribute bytes (colours, in some programs), not used",
                  ": 1 triangles have no area"));
}

TEST_F(Stl, BadBytes) {
  EXPECT_EQ(fault(""),
            ": byte 0: the file has 0 bytes: neither a binary STL, of at least 84 bytes, "
            "nor a text that begins with \"solid\"");
  EXPECT_EQ(fault(binary({})), ": nothing to render: no triangles");
  std::string claim = binary({facet});
  claim.replace(80, 4, test::bytes_of(0xFFFFFFFFU));
  EXPECT_EQ(fault(claim),
            ": byte 80: 4294967295 triangles need 214748364834 bytes, the file has "
            "134 (truncated, or no STL)");
  EXPECT_EQ(
      fault(binary({facet, {Vec3f(0), Vec3f(0, 1e20F, 0), Vec3f(1)}})),
      ": byte 170: triangle 1: a corner lies at [0, 1e+20, 0]: coordinates must be finite and "
      "within 1e15");
  EXPECT_THAT(fault(binary({{Vec3f(0), Vec3f(1), Vec3f(NAN, 0, 0)}})), HasSubstr("at [nan, 0, 0]"));
  EXPECT_THAT(fault(binary({{Vec3f(0), Vec3f(1), Vec3f(0, 0, INFINITY)}})), HasSubstr("inf]"));
}

TEST_F(Stl, BadText) {
  const std::string good = text_facet(facet);
  EXPECT_EQ(fault("solid x\nendsolid x\n"), ": nothing to render: no facets");
  EXPECT_EQ(fault("solid x\n" + good), ": the file ends early: \"endsolid\" is missing");
  EXPECT_EQ(fault("solid x\nfacet norm 0 0 1\n"), ":2:7: \"norm\", must be \"normal\"");
  EXPECT_EQ(fault("solid x\nvertex 0 0 1\n"),
            ":2:1: \"vertex\", must be \"facet\" or \"endsolid\"");
  EXPECT_EQ(fault("solid x\n" + good + "endsolid\nfacet normal 0 0 0\n"),
            ":10:1: \"facet\", must be \"solid\"");
  EXPECT_EQ(fault("solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"
                  "endfacet\nendsolid\n"),
            ":2:1: a facet of 2 corners, must be at least 3");
  const auto corner = [&](const std::string& numbers) {
    return fault("solid x\nfacet normal 0 0 0\nouter loop\n vertex " + numbers + "\n");
  };
  EXPECT_EQ(corner("0 x 0"), ":4:11: \"x\" is not a finite number");
  EXPECT_EQ(corner("0 0,5 0"),
            ":4:11: \"0,5\" is not a number: write decimals with a point, not a comma");
  EXPECT_EQ(corner("0 0 2e15"),
            ":4:2: a corner lies at [0, 0, 2e+15]: coordinates must be finite and within 1e15");
  EXPECT_THAT(corner("0 nan 0"), HasSubstr("a corner lies at [0, nan, 0]"));
  EXPECT_THAT(corner("0 -1e400 0"), HasSubstr("coordinates must be finite"));
  EXPECT_EQ(corner("0 0"), ": the file ends early: a number is missing");
  EXPECT_THAT(fault(std::string("\xFF\xFEs\0o\0", 6)), HasSubstr(":1:1: the text is UTF-16"));
}

TEST_F(Stl, Truncated) {
  const std::string text = "solid x\n" + text_facet(facet) + "endsolid";
  const std::string bytes = binary({facet});
  for (const std::string& whole : {text, bytes}) {
    ASSERT_EQ(fault(whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_NE(fault(whole.substr(0, size)), "") << size;
    }
  }
}

TEST_F(Stl, ChangedBytes) {
  for (const std::string& whole :
       {"solid x\n" + text_facet(facet) + "endsolid", binary({facet}, "solid")}) {
    for (std::size_t i = 0; i < whole.size(); ++i) {
      std::string changed = whole;
      changed[i] = test::odd_byte(i);
      fault(changed);
    }
  }
}

TEST_F(Stl, Limits) {
  const std::string text = "solid x\n" + text_facet(facet) + text_facet(facet) + "endsolid\n";
  ImportLimits limits;
  limits.triangles = 1;
  EXPECT_EQ(fault(text, limits), ":9:2: more than 1 triangles, the limit");
  EXPECT_EQ(fault(binary({facet, facet}), limits), ": 2 triangles, the limit is 1");
  limits = {};
  limits.nodes = 1;
  EXPECT_EQ(fault(text + text, limits), ":17:1: more than 1 solids, the limit");
  limits = {};
  limits.total_bytes = 100;
  EXPECT_THAT(fault(text, limits), HasSubstr("the limit is 100 bytes"));
}

}  // namespace
}  // namespace restframe
