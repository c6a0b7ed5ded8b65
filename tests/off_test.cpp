// OFF files: right ones and wrong ones.

#include <gmock/gmock.h>

#include "support/mesh_reading.h"

namespace restframe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

class Off : public test::MeshReading {
 protected:
  Mesh mesh(const std::string& bytes) { return mesh_of("mesh.off", bytes); }
  std::string fault(const std::string& bytes, const ImportLimits& limits = {}) {
    return fault_of("bad.off", bytes, limits);
  }
};

TEST_F(Off, HeadersOfEverySpelling) {
  for (const std::string header :
       {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF3 1 0\n", "OFF\n3 1\n", "3 1 0\n",
        "# made\n\nOFF # here\n3 # three\n1 3 # edges\n", "OFF\r\n3 1 3\r\n"}) {
    const Mesh read = mesh(header + triangle);
    EXPECT_THAT(read.positions, ElementsAre(Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0))) << header;
    EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}));
    EXPECT_THAT(warnings_, IsEmpty());
  }
}

TEST_F(Off, CommentsAndBlankLines) {
  const Mesh read =
      mesh("OFF\n3 1 0\n# corners\n0 0 0 # first\n\n1 0 0\n0 1 0\n#\n3 0 1 2 # all\n#\n");
  EXPECT_EQ(read.triangles.size(), 1U);
  EXPECT_THAT(warnings_, IsEmpty());
}

// 0.2 in sRGB is 0.0331 (IEC 61966-2-1).
TEST_F(Off, ColorsOfVertices) {
  const auto colors = [&](const std::string& a, const std::string& b, const std::string& c) {
    return mesh("COFF\n3 1 0\n0 0 0 " + a + "\n1 0 0 " + b + "\n0 1 0 " + c + "\n3 0 1 2\n").colors;
  };
  for (const auto& read : {colors("1 0 0 1", "0 0.2 0 1", "0 0 1 0.2"),
                           colors("255 0 0 255", "0 51 0 255", "0 0 255 51")}) {
    EXPECT_EQ(read[0], Vec4f(1, 0, 0, 1));
    EXPECT_NEAR(read[1].g, 0.0331, 1e-4);
    EXPECT_NEAR(read[2].a, 0.2, 1e-6);
  }
  EXPECT_EQ(colors("255 0 0", "0 255 0", "0 0 255")[2], Vec4f(0, 0, 1, 1));
}

TEST_F(Off, NormalsAndTextureCoordinates) {
  const Mesh read = mesh(
      "STCNOFF\n3 1 0\n0 0 0 0 2 0 1 1 1 0 0\n1 0 0 0 1 0 1 1 1 1 0.25\n"
      "0 1 0 0 1 0 1 1 1 0 1\n3 0 1 2\n");
  EXPECT_THAT(read.normals, ElementsAre(Vec3f(0, 1, 0), Vec3f(0, 1, 0), Vec3f(0, 1, 0)));
  EXPECT_THAT(read.uvs[0], ElementsAre(Vec2f(0, 1), Vec2f(1, 0.75F), Vec2f(0, 0)));
  EXPECT_EQ(read.colors[0], Vec4f(1));
}

TEST_F(Off, FourthCoordinateDivides) {
  const Mesh read = mesh("4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 3 0 3\n3 0 1 2\n");
  EXPECT_THAT(read.positions, ElementsAre(Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)));
}

// Faces without a colour are white.
TEST_F(Off, ColorsOfFaces) {
  const Mesh read = mesh(
      "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n"
      "3 0 2 3 0 0 255 51\n3 0 1 3\n");
  EXPECT_EQ(read.colors[read.triangles[0][0]], Vec4f(1, 0, 0, 1));
  EXPECT_NEAR(read.colors[read.triangles[1][0]].a, 0.2, 1e-6);
  EXPECT_EQ(read.colors[read.triangles[2][0]], Vec4f(1));
}

TEST_F(Off, WhatIsNotUsedIsTold) {
  const Mesh read = mesh("OFF\n3 4 0\n0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2 7\n2 0 1\n1 2\n0\nmore\n");
  EXPECT_EQ(read.triangles.size(), 1U);
  EXPECT_THAT(
      told(),
      ElementsAre(
          ": 1 vertices have numbers that the header does not announce, not used",
          ": 1 faces have colours that are no RGB or RGBA, or go after those of vertices, not used",
          ": lines after the last face are not used",
          ": 3 faces of fewer than three corners are not renderable, skipped"));
}

TEST_F(Off, NoFaceIsLost) {
  const Mesh read = mesh(
      "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n"
      "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 2 1 0\n");
  EXPECT_EQ(read.triangles.size(), 4U);
}

TEST_F(Off, BadHeaders) {
  EXPECT_EQ(fault(""), ": the file ends early: no OFF header");
  EXPECT_EQ(fault("# nothing\n"), ": the file ends early: no OFF header");
  EXPECT_EQ(fault("ply\n"), ":1:1: \"ply\", must be \"OFF\" (or COFF, NOFF, STOFF, 4OFF, ...)");
  EXPECT_EQ(fault("nOFF\n4\n3 1 0\n"),
            ":1:1: nOFF, in any number of dimensions, can not be read: save it in three");
  EXPECT_EQ(fault("OFF BINARY\n"),
            ":1:5: binary OFF can not be read: save it as text, or as binary PLY");
  EXPECT_THAT(fault(std::string("OFF BINARY\n\0\0", 13)), HasSubstr("a NUL byte"));
  EXPECT_EQ(fault("OFF\n"), ": the file ends early: the number of vertices is missing");
  EXPECT_EQ(fault("OFF\n3 # vertices, but no more\n"),
            ": the file ends early: the number of faces is missing");
  EXPECT_EQ(fault("OFF\n-3 1 0\n"), ":2:1: \"-3\" is no number of vertices");
  EXPECT_EQ(fault("OFF\n3 1.5 0 # no whole number\n"), ":2:3: \"1.5\" is no number of faces");
  EXPECT_EQ(fault("OFF\n4000000000 1 0\n" + triangle),
            ":2:1: 4000000000 vertices can not be in a file of 45 bytes");
  EXPECT_THAT(fault("OFF\n3 99999999999999999999999 0\n" + triangle),
              HasSubstr(":2:3: 99999999999999999999999 faces can not be in a file of"));
  EXPECT_THAT(fault(std::string("\xFE\xFF\0O", 4)), HasSubstr(":1:1: the text is UTF-16"));
}

TEST_F(Off, BadVertices) {
  const auto vertex = [&](const std::string& text) {
    return fault("OFF\n3 1 0\n" + text + "\n1 0 0\n0 1 0\n3 0 1 2\n");
  };
  EXPECT_EQ(vertex("0 0"), ":3:3: vertex 0 ends here, after 2 numbers, must have 3");
  EXPECT_EQ(vertex("0 zero 0"), ":3:3: \"zero\" is not a finite number");
  EXPECT_THAT(vertex("0,1 0 0"), HasSubstr(":3:1: \"0,1\" is not a number: write decimals"));
  EXPECT_EQ(
      vertex("nan 0 0"),
      ":6:3: vertex 0, which a face uses, lies at [nan, 0, 0]: coordinates must be finite and "
      "within 1e15");
  EXPECT_THAT(vertex("0 1e20 0"), HasSubstr("lies at [0, 1e+20, 0]"));
  EXPECT_THAT(vertex("0 0 inf"), HasSubstr("coordinates must be finite"));
  EXPECT_EQ(fault("COFF\n1 0 0\n0 0 0 255 255\n"),
            ":3:11: vertex 0 ends here, after 5 numbers, must have 6");
  EXPECT_EQ(fault("OFF\n2 0 0\n0 0 0\n#......\n"),
            ": the file ends early: vertex 1 of 2 is missing");
}

TEST_F(Off, BadFaces) {
  const auto face = [&](const std::string& text) {
    return fault("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + text + "\n");
  };
  EXPECT_EQ(face("3 0 1 3"), ":6:7: vertex index 3: there are only 3 vertices, the first is 0");
  EXPECT_EQ(face("3 0 1 -1"), ":6:7: vertex index -1: there are only 3 vertices, the first is 0");
  EXPECT_EQ(face("3 0 1 1.5"), ":6:7: \"1.5\" is no vertex index");
  EXPECT_EQ(face("3 0 1 nan"), ":6:7: vertex index nan: there are only 3 vertices, the first is 0");
  EXPECT_EQ(face("-3 0 1 2"), ":6:1: \"-3\" is no number of corners");
  EXPECT_EQ(face("1e99 0 1 2"), ":6:1: \"1e99\" is no number of corners");
  EXPECT_EQ(face("4000000000 0 1 2"), ":6:1: a face of 4000000000 corners ends after 3");
  EXPECT_EQ(face("4 0 1 2"), ":6:1: a face of 4 corners ends after 3");
  EXPECT_EQ(face(""), ": the file ends early: face 0 of 1 is missing");
  EXPECT_EQ(fault("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"),
            ": nothing to render: 3 vertices, no faces (points and lines are not renderable)");
  EXPECT_EQ(face("2 0 1"),
            ": nothing to render: 1 faces, none of three corners or more (points and lines are not "
            "renderable)");
}

TEST_F(Off, Truncated) {
  const std::string whole = "OFF\n3 1 0\n" + triangle.substr(0, triangle.size() - 1);
  ASSERT_EQ(fault(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(fault(whole.substr(0, size)), "") << size;
  }
}

TEST_F(Off, ChangedBytes) {
  const std::string whole =
      "STCNOFF\n3 1 0\n0 0 0 0 2 0 1 1 1 0 0\n1 0 0 0 1 0 1 1 1 1 0.25\n"
      "0 1 0 0 1 0 1 1 1 0 1\n3 0 1 2\n";
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = test::odd_byte(i);
    fault(changed);
  }
}

TEST_F(Off, Limits) {
  ImportLimits limits;
  limits.triangles = 1;
  EXPECT_EQ(fault("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", limits),
            ": more than 1 triangles, the limit");
  limits = {};
  limits.total_bytes = 30;
  EXPECT_EQ(fault("OFF\n3 1 0\n" + triangle, limits), ": file of 36 bytes, the limit is 30 bytes");
  limits.total_bytes = 60;
  EXPECT_EQ(fault("OFF\n3 1 0\n" + triangle, limits),
            ": 3 vertices need more than 60 bytes, the limit");
}

}  // namespace
}  // namespace restframe
