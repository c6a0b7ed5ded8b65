// PLY files that are wrong: one line that says where and why, in bounded time and memory.

#include <gmock/gmock.h>

#include "support/mesh_reading.h"

namespace restframe {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string vertices =
    "element vertex 3\nproperty float x\nproperty float y\n"
    "property float z\n";
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";

std::string ply(const std::string& elements, const std::string& body,
                const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body;
}

std::string binary_body() {
  std::string body;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) body += test::bytes_of(x);
  body += '\3';
  for (const int i : {0, 1, 2}) body += test::bytes_of(i);
  return body;
}

class BadPly : public test::MeshReading {
 protected:
  std::string fault(const std::string& bytes, const ImportLimits& limits = {}) {
    return fault_of("bad.ply", bytes, limits);
  }
};

TEST_F(BadPly, Magic) {
  const std::string expected = ":1:1: no PLY file: the first line must be \"ply\"";
  EXPECT_EQ(fault(""), expected);
  EXPECT_EQ(fault("pl"), expected);
  EXPECT_EQ(fault("ply"), expected);
  EXPECT_EQ(fault("plyx\n"), expected);
  EXPECT_EQ(fault("OFF\n3 1 0\n"), expected);
  EXPECT_EQ(fault(std::string("\xFF\xFEp\0l\0y\0\n\0", 10)), expected);
}

TEST_F(BadPly, Header) {
  EXPECT_EQ(fault("ply\n"), ": the file ends early: \"end_header\" is missing");
  EXPECT_EQ(fault("ply\nformat binary 1.0\n"),
            ":2:8: format \"binary\", must be ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(fault("ply\n" + vertices + "end_header\n"),
            ":6:1: no format line before the end of the header");
  EXPECT_EQ(fault(ply("property float x\n", "")), ":3:1: a property before any element");
  EXPECT_EQ(fault(ply("element vertex 3\nproperty real x\n", "")),
            ":4:10: type \"real\", must be char, uchar, short, ushort, int, uint, float or double");
  EXPECT_EQ(fault(ply("element face 1\nproperty list uchar bool i\n", "")),
            ":4:21: type \"bool\", must be char, uchar, short, ushort, int, uint, float or double");
  EXPECT_EQ(fault(ply("element face 1\nproperty list uchar\n", "")),
            ":4:1: type \"\", must be char, uchar, short, ushort, int, uint, float or double");
  EXPECT_EQ(fault(ply("element face 1\nproperty int\n", "")), ":4:1: a property without a name");
  EXPECT_EQ(fault(ply("element vertex 3\nelement vertex 3\n", "")),
            ":4:9: a second element \"vertex\"");
  EXPECT_EQ(fault(ply(vertices + "property float x\n", "")), ":7:16: a second property \"x\"");
  EXPECT_EQ(fault(ply("element vertex 3\nproperti float x\n", "")),
            ":4:1: \"properti\", must be \"property\", \"element\", \"comment\" or \"end_header\"");
  EXPECT_EQ(fault("ply\ncomment " + std::string(9000, 'x') + "\n"),
            ": byte 4: a line of the header has more than 8192 bytes");
}

TEST_F(BadPly, Counts) {
  const std::string rest = "\nproperty float x\nproperty float y\nproperty float z\n";
  EXPECT_EQ(fault(ply("element vertex -3" + rest, "")), ":3:16: \"-3\" is no number of rows");
  EXPECT_EQ(fault(ply("element vertex 3.5" + rest, "")), ":3:16: \"3.5\" is no number of rows");
  EXPECT_EQ(fault(ply("element vertex" + rest, "")), ":3:1: \"\" is no number of rows");
  EXPECT_EQ(fault(ply("element vertex 4000000000" + rest, corners)),
            ": element \"vertex\" of 4000000000 rows needs at least 6 bytes a row, the file has 19 "
            "left (truncated?)");
  EXPECT_THAT(fault(ply("element vertex 99999999999999999999999" + rest, corners)),
              HasSubstr("of 18446744073709551615 rows needs at least 6 bytes a row"));
  EXPECT_THAT(fault(ply("element vertex 4000000000" + rest, corners, "binary_big_endian")),
              HasSubstr("needs at least 12 bytes a row, the file has 18 left"));
  EXPECT_THAT(fault(ply(vertices + "element face 4294967295\nproperty list uchar int "
                                   "vertex_indices\n",
                        corners + "3 0 1 2\n")),
              HasSubstr("element \"face\" of 4294967295 rows"));
}

TEST_F(BadPly, Indices) {
  const auto face = [&](const std::string& text) {
    return fault(ply(vertices + faces, corners + text));
  };
  EXPECT_EQ(face("3 0 1 3\n"), ":13:7: vertex index 3: there are only 3 vertices, the first is 0");
  EXPECT_EQ(face("3 0 -1 2\n"),
            ":13:5: vertex index -1: there are only 3 vertices, the first is 0");
  EXPECT_EQ(face("3 0 1 1.5\n"),
            ":13:7: \"1.5\", must be a whole number from -2147483648 to 2147483647");
  EXPECT_EQ(face("3 0 1 4294967296\n"),
            ":13:7: \"4294967296\", must be a whole number from -2147483648 to 2147483647");
  EXPECT_EQ(face("3 0 1 x\n"), ":13:7: \"x\" is not a finite number");
  EXPECT_EQ(face("-3 0 1 2\n"), ":13:1: \"-3\", must be a whole number from 0 to 255");
  EXPECT_EQ(face("255 0 1 2\n"), ": the file ends early: a number is missing");
  EXPECT_EQ(face("2 0 1\n"),
            ": nothing to render: 1 faces, none of three corners or more (points and lines are not "
            "renderable)");
  EXPECT_EQ(fault(ply(vertices + "element face 1\nproperty list char float vertex_indices\n",
                      corners + "3 0 1 1.5\n")),
            ":13:7: 1.5 is no vertex index");
  EXPECT_EQ(fault(ply(vertices + "element face 1\nproperty list float int vertex_indices\n",
                      corners + "-3 0 1 2\n")),
            ":13:1: a list of -3 items");
  EXPECT_EQ(fault(ply(vertices + "element tristrips 1\nproperty list int int vertex_indices\n",
                      corners + "3 0 1 -2\n")),
            ":13:7: vertex index -2: there are only 3 vertices, the first is 0");
}

TEST_F(BadPly, Coordinates) {
  const auto vertex = [&](const std::string& text) {
    return fault(ply(vertices + faces, "0 0 0\n" + text + "\n0 1 0\n3 0 1 2\n"));
  };
  EXPECT_EQ(vertex("nan 0 0"),
            ":13:5: vertex 1, which a face uses, lies at [nan, 0, 0]: coordinates must be finite "
            "and within 1e15");
  EXPECT_THAT(vertex("0 inf 0"), StartsWith(":13:5: vertex 1, which a face uses, lies at ["));
  EXPECT_THAT(vertex("0 1e20 0"), HasSubstr("lies at [0, 1e+20, 0]"));
  EXPECT_THAT(vertex("0 0 -1e400"), HasSubstr("coordinates must be finite"));
  EXPECT_EQ(vertex("0 0,5 0"),
            ":11:3: \"0,5\" is not a number: write decimals with a point, not a comma");
}

TEST_F(BadPly, NothingToRender) {
  EXPECT_EQ(fault(ply(vertices, corners)),
            ": nothing to render: 3 vertices, no faces (points and lines are not renderable)");
  EXPECT_EQ(fault(ply("element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 0\nproperty list uchar int vertex_indices\n",
                      "")),
            ": nothing to render: 0 vertices, no faces (points and lines are not renderable)");
  EXPECT_EQ(fault("ply\nformat ascii 1.0\nend_header\n"),
            ": nothing to render: 0 vertices, no faces (points and lines are not renderable)");
}

TEST_F(BadPly, MissingProperties) {
  EXPECT_EQ(fault(ply("element vertex 3\nproperty float x\nproperty float y\n" + faces, corners)),
            ": the vertices have no properties x, y and z");
  EXPECT_EQ(fault(ply(vertices + "element face 1\nproperty int a\n", corners + "3\n")),
            ": element \"face\" has no list vertex_indices");
  EXPECT_EQ(fault(ply(faces + vertices, "3 0 1 2\n" + corners)),
            ": element \"face\" before any vertices");
}

TEST_F(BadPly, TextForBytesAndBytesForText) {
  const std::string text = "0.000 0.000 0.000\n1.000 0.000 0.000\n0.000 1.000 0.000\n3 0 1 2\n";
  EXPECT_EQ(fault(ply(vertices + faces, text, "binary_little_endian")),
            ": byte 169: text follows, where the header says binary");
  EXPECT_THAT(fault(ply(vertices + faces, binary_body())), HasSubstr("a NUL byte"));
}

// All of a file's beginnings but the whole.
TEST_F(BadPly, TruncatedText) {
  const std::string whole = ply(vertices + faces, corners + "3 0 1 2");
  ASSERT_EQ(fault(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(fault(whole.substr(0, size)), "") << size;
  }
}

TEST_F(BadPly, TruncatedBytes) {
  const std::string whole = ply(vertices + faces, binary_body(), "binary_little_endian");
  ASSERT_EQ(fault(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THAT(
        fault(whole.substr(0, size)),
        AnyOf(HasSubstr("the file ends early"), HasSubstr("no PLY file"), HasSubstr("truncated?")))
        << size;
  }
}

// Each byte of a small file replaced by others: read or refused, but nothing else.
TEST_F(BadPly, ChangedBytes) {
  const std::string text = ply(vertices + faces, corners + "3 0 1 2");
  const std::string binary = ply(vertices + faces, binary_body(), "binary_little_endian");
  for (const std::string& whole : {text, binary}) {
    for (std::size_t i = 0; i < whole.size(); ++i) {
      std::string changed = whole;
      changed[i] = test::odd_byte(i);
      fault(changed);
    }
  }
}

TEST_F(BadPly, Limits) {
  const std::string file =
      ply(vertices + "element face 2\nproperty list uchar int vertex_indices\n",
          corners + "3 0 1 2\n4 0 1 2 0\n");
  ImportLimits limits;
  limits.triangles = 3;
  EXPECT_EQ(fault(file, limits), "");
  limits.triangles = 2;
  EXPECT_EQ(fault(file, limits), ": more than 2 triangles, the limit");
  limits = {};
  limits.total_bytes = file.size() - 1;
  EXPECT_THAT(fault(file, limits), HasSubstr("bytes, the limit is"));
  const std::string small =
      ply("element vertex 30\nproperty uchar x\nproperty uchar y\n"
          "property uchar z\n" +
              faces,
          std::string(90, '\0') + "\3" + std::string(12, '\0'), "binary_little_endian");
  limits.total_bytes = small.size();
  EXPECT_EQ(fault(small, limits),
            ": 30 vertices need more than " + std::to_string(small.size()) + " bytes, the limit");
}

// A polygon as large as the file: linear, and refused beyond the limit.
TEST_F(BadPly, OneLargePolygon) {
  const std::uint32_t count = 100000;
  std::string body = std::string(36, '\0') + test::bytes_of(count);
  for (std::uint32_t i = 0; i < count; ++i) body += static_cast<char>(i % 3);
  const std::string file = ply(vertices + "element face 1\nproperty list uint uchar vertex_index\n",
                               body, "binary_little_endian");
  EXPECT_EQ(fault(file), "");
  ImportLimits limits;
  limits.triangles = 50000;
  EXPECT_EQ(fault(file, limits), ": more than 50000 triangles, the limit");
}

}  // namespace
}  // namespace restframe
