// PLY files that are right, in every spelling.

#include <gmock/gmock.h>

#include <cmath>

#include "support/gltf_builder.h"
#include "support/mesh_reading.h"

namespace restframe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A PLY file of these elements, and what follows the header.
std::string ply(const std::string& elements, const std::string& body,
                const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body;
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string face_1 = "element face 1\nproperty list uchar int vertex_indices\n";

// Three corners of a triangle with more properties each.
std::string triangle(const std::string& properties, const std::string& a, const std::string& b,
                     const std::string& c) {
  return ply("element vertex 3\n" + xyz + properties + face_1,
             "0 0 0 " + a + "\n1 0 0 " + b + "\n0 1 0 " + c + "\n3 0 1 2\n");
}

// sRGB's encoding, IEC 61966-2-1.
double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

class Ply : public test::MeshReading {
 protected:
  Mesh mesh(const std::string& bytes) { return mesh_of("mesh.ply", bytes); }

  void expect_colors(const std::string& bytes, const std::vector<glm::dvec4>& srgb) {
    const Mesh read = mesh(bytes);
    ASSERT_EQ(read.colors.size(), srgb.size());
    for (std::size_t i = 0; i < srgb.size(); ++i) {
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(read.colors[i][c], linear(srgb[i][c]), 1e-6);
      EXPECT_NEAR(read.colors[i].a, srgb[i].a, 1e-6);
    }
  }
};

TEST_F(Ply, ReadsText) {
  const Mesh read = mesh(triangle("", "", "", ""));
  EXPECT_THAT(read.positions, ElementsAre(Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)));
  EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(read.normals, ElementsAre(Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0, 0, 1)));
  EXPECT_THAT(read.materials.size(), 1U);
  EXPECT_EQ(read.name, "mesh");
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Ply, MakesAnAssetOfOneMaterial) {
  const Asset asset = load("mesh.PLY", triangle("", "", "", ""));
  ASSERT_EQ(asset.materials.size(), 1U);
  EXPECT_EQ(asset.materials[0].name, "default");
  EXPECT_EQ(asset.materials[0].base_color.value, Vec3f(0.8F));
  EXPECT_TRUE(asset.materials[0].double_sided);
  ASSERT_EQ(asset.parts.size(), 1U);
  EXPECT_EQ(name_of(asset, asset.parts[0]), "mesh");
}

TEST_F(Ply, LinesMayEndInAnyWay) {
  const std::string unix_lines = triangle("", "", "", "");
  std::string windows, old_mac = unix_lines;
  for (const char c : unix_lines) windows += c == '\n' ? "\r\n" : std::string(1, c);
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  EXPECT_EQ(mesh(windows).triangles.size(), 1U);
  EXPECT_EQ(mesh(old_mac).triangles.size(), 1U);
}

TEST_F(Ply, HeaderWordsMayBeSpaced) {
  const std::string text =
      "ply  \nformat  ascii 1.0  \ncomment made\\\nobj_info x\n\nelement vertex 3 \n" + xyz +
      face_1 + "end_header \n0 0 0 1 0 0\n0 1\n0 3 0 1 2";
  EXPECT_EQ(mesh(text).positions[2], Vec3f(0, 1, 0));
}

// Every type of number, both orders of bytes.
TEST_F(Ply, ReadsBytes) {
  for (const bool big : {false, true}) {
    const auto number = [big](auto value) { return test::bytes_of(value, big); };
    std::string body;
    for (const auto& [x, y] : {std::pair(0.0, 0), {2.5, 0}, {0.0, -3}}) {
      body +=
          number(x) + number(static_cast<std::int16_t>(y)) + number(static_cast<std::int8_t>(1));
      body += number(static_cast<std::uint32_t>(7));
    }
    body += number(std::uint16_t{3}) + number(std::int32_t{0}) + number(std::int32_t{2}) +
            number(std::int32_t{1});
    const Mesh read =
        mesh(ply("element vertex 3\nproperty double x\nproperty short y\nproperty char z\n"
                 "property uint id\nelement face 1\nproperty list ushort int vertex_index\n",
                 body, big ? "binary_big_endian" : "binary_little_endian"));
    EXPECT_THAT(read.positions, ElementsAre(Vec3f(0, 0, 1), Vec3f(0, -3, 1), Vec3f(2.5F, 0, 1)));
    EXPECT_EQ(read.normals[0], Vec3f(0, 0, 1));
    EXPECT_THAT(told(), ElementsAre(": not used: \"vertex.id\""));
  }
}

// The first byte of the data is that of a line end.
TEST_F(Ply, BytesBeginRightAfterTheHeader) {
  for (const std::string line_end : {"\n", "\r", "\r\n"}) {
    std::string header;
    for (const char c : ply("element vertex 3\nproperty uchar x\nproperty uchar y\n"
                            "property uchar z\n" +
                                face_1,
                            "", "binary_little_endian")) {
      header += c == '\n' ? line_end : std::string(1, c);
    }
    const std::string body = std::string("\n\0\0\0\n\0\0\0\n\3", 10) + test::bytes_of(0) +
                             test::bytes_of(1) + test::bytes_of(2);
    EXPECT_EQ(mesh(header + body).positions[1], Vec3f(0, 10, 0)) << line_end.size();
  }
}

TEST_F(Ply, ColorsOfEverySpelling) {
  const auto three = [](const std::string& prefix, const std::string& type) {
    std::string result;
    for (const char* name : {"red", "green", "blue"}) {
      result += "property " + type + " " + prefix + name + "\n";
    }
    return result;
  };
  const std::vector<glm::dvec4> expected = {{1, 0, 0.2, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  const auto bytes = [&](const std::string& properties) {
    return triangle(properties, "255 0 51", "0 255 0", "0 0 255");
  };
  expect_colors(bytes(three("", "uchar")), expected);
  expect_colors(bytes(three("diffuse_", "uint8")), expected);
  expect_colors(bytes(three("", "int")), expected);
  expect_colors(bytes("property uchar r\nproperty uchar g\nproperty uchar b\n"), expected);
  EXPECT_THAT(told(), IsEmpty());
  expect_colors(triangle(three("", "ushort"), "65535 0 13107", "0 65535 0", "0 0 65535"), expected);
  expect_colors(triangle(three("", "float"), "1 0 0.2", "0 1 0", "0 0 1"), expected);
  EXPECT_THAT(told(), IsEmpty());
  expect_colors(bytes(three("", "double")), expected);
  EXPECT_THAT(told(), ElementsAre(": colours beyond 1 are taken as 0 to 255"));
}

TEST_F(Ply, AlphaBlends) {
  const std::string rgba =
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  const std::string text = triangle(rgba, "255 255 255 255", "0 0 0 51", "0 0 0 0");
  expect_colors(text, {{1, 1, 1, 1}, {0, 0, 0, 0.2}, {0, 0, 0, 0}});
  const Asset asset = load("mesh.ply", text);
  EXPECT_EQ(asset.materials[0].alpha_mode, AlphaMode::blend);
  EXPECT_EQ(asset.materials[0].base_color.value, Vec3f(1));
  EXPECT_EQ(load("mesh.ply", triangle(rgba, "1 1 1 255", "0 0 0 255", "0 0 0 255"))
                .materials[0]
                .alpha_mode,
            AlphaMode::opaque);
}

TEST_F(Ply, AlphaThatHidesAllIsMended) {
  expect_colors(triangle("property uchar red\nproperty uchar green\nproperty uchar blue\n"
                         "property uchar alpha\n",
                         "255 255 255 0", "0 0 0 0", "0 0 0 0"),
                {{1, 1, 1, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}});
  EXPECT_THAT(told(), ElementsAre(": every colour has alpha 0, taken as 1"));
}

TEST_F(Ply, NormalsAreOfUnitLength) {
  const Mesh read = mesh(triangle("property float nx\nproperty float ny\nproperty float nz\n",
                                  "0 2 0", "0 0 0", "nan 0 0"));
  EXPECT_THAT(read.normals, ElementsAre(Vec3f(0, 1, 0), Vec3f(0, 0, 1), Vec3f(0, 0, 1)));
  EXPECT_THAT(told(), ElementsAre(": 2 normals have no direction, computed instead"));
}

// PLY's v points up, ours down.
TEST_F(Ply, TextureCoordinatesOfEverySpelling) {
  for (const auto& [u, v] : {std::pair("u", "v"), {"s", "t"}, {"texture_u", "texture_v"}}) {
    const Mesh read =
        mesh(triangle(std::string("property float ") + u + "\nproperty float " + v + "\n", "0 0",
                      "0.25 1", "1 0.75"));
    EXPECT_THAT(read.uvs[0], ElementsAre(Vec2f(0, 1), Vec2f(0.25F, 0), Vec2f(1, 0.25F)));
  }
}

TEST_F(Ply, TextureCoordinatesOfCorners) {
  const Mesh read = mesh(ply("element vertex 4\n" + xyz +
                                 "element face 2\nproperty list uchar int vertex_indices\n"
                                 "property list uchar float texcoord\n",
                             "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 6 0 0 1 0 1 1\n"
                             "3 0 2 3 6 0 0 0.5 0.5 0 1\n"));
  ASSERT_EQ(read.triangles.size(), 2U);
  const auto uv = [&](std::size_t t, std::size_t i) { return read.uvs[0][read.triangles[t][i]]; };
  EXPECT_EQ(read.triangles[0][0], read.triangles[1][0]);  // alike at both faces
  EXPECT_EQ(uv(0, 2), Vec2f(1, 0));
  EXPECT_EQ(uv(1, 1), Vec2f(0.5F, 0.5F));
  EXPECT_EQ(read.positions[read.triangles[1][1]], Vec3f(1, 1, 0));
  EXPECT_THAT(told(), IsEmpty());
}

TEST_F(Ply, TextureFiles) {
  const auto text = [](const std::string& name, bool with_uvs) {
    const std::string uvs = with_uvs ? "property float s\nproperty float t\n" : "";
    return ply(
        "comment TextureFile " + name + "\nelement vertex 3\n" + xyz + uvs + face_1,
        with_uvs ? "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n" : "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  };
  files_.write("a.png", test::png(1, 1, "rgba"));
  const Asset asset = load("mesh.ply", text("a.png", true));
  EXPECT_EQ(asset.images.size(), 1U);
  EXPECT_EQ(asset.materials[0].base_color_texture.texture, 0);
  EXPECT_EQ(asset.materials[0].base_color.value, Vec3f(1));
  EXPECT_EQ(asset.files.size(), 1U);
  EXPECT_THAT(load("mesh.ply", text("b.png", true)).images, IsEmpty());
  EXPECT_THAT(told(), ElementsAre(": TextureFile \"b.png\" does not exist, not used"));
  EXPECT_THAT(load("mesh.ply", text("a.png", false)).images, IsEmpty());
  EXPECT_THAT(told(), ElementsAre(": TextureFile \"a.png\" is not used: there are no texture "
                                  "coordinates"));
  EXPECT_THAT(fault_of("in/mesh.ply", text("../a.png", true)),
              HasSubstr(": TextureFile \"../a.png\""));
}

TEST_F(Ply, ColorsOfFaces) {
  const Mesh read =
      mesh(ply("element vertex 4\n" + xyz +
                   "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                   "property uchar green\nproperty uchar blue\n",
               "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n"));
  for (const std::uint32_t v : read.triangles[0]) EXPECT_EQ(read.colors[v], Vec4f(1, 0, 0, 1));
  for (const std::uint32_t v : read.triangles[1]) EXPECT_EQ(read.colors[v], Vec4f(0, 0, 1, 1));
}

// A concave polygon of 5 corners, its reflex corner at (1, 1): area 4 - 1 = 3.
TEST_F(Ply, PolygonsAreCutProperly) {
  const Mesh read = mesh(
      ply("element vertex 5\n" + xyz + face_1, "0 0 0\n2 0 0\n2 2 0\n1 1 0\n0 2 0\n5 0 1 2 3 4\n"));
  ASSERT_EQ(read.triangles.size(), 3U);
  double area = 0;
  for (const Triangle& t : read.triangles) {
    const Vec3 a = read.positions[t[0]], b = read.positions[t[1]], c = read.positions[t[2]];
    const double z = glm::cross(b - a, c - a).z;
    EXPECT_GE(z, 0);
    area += z / 2;
  }
  EXPECT_DOUBLE_EQ(area, 3);
}

TEST_F(Ply, StripsOfTriangles) {
  const Mesh read = mesh(ply(
      "element vertex 5\n" + xyz + "element tristrips 1\nproperty list int int vertex_indices\n",
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n"));
  EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}, Triangle{2, 3, 4}));
}

TEST_F(Ply, OtherElementsAreSkipped) {
  const std::string elements =
      "element camera 2\nproperty list char float view\nproperty int id\n"
      "element vertex 3\n" +
      xyz + "property list uchar int neighbours\n" +
      "element face 1\nproperty uchar flags\n"
      "property list double uchar vertex_indices\nelement none 4000000000\n";
  const Mesh read =
      mesh(ply(elements, "0 1\n2 0.5 0.5 2\n0 0 0 0\n1 0 0 2 5 6\n0 1 0 1 1\n1 3 0 1 2\n"));
  EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(told(), ElementsAre(": not used: \"camera\", \"vertex.neighbours\", \"face.flags\", "
                                  "\"none\""));
}

// Three faces at one edge, and two wound differently.
TEST_F(Ply, NoFaceIsLost) {
  const Mesh read = mesh(
      ply("element vertex 5\n" + xyz + "element face 4\nproperty list uchar int vertex_indices\n",
          "0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n"
          "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 2 1 0\n"));
  ASSERT_EQ(read.triangles.size(), 4U);
  for (const Triangle& t : read.triangles) {
    for (const std::uint32_t v : t) EXPECT_LT(v, read.positions.size());
  }
  EXPECT_EQ(read.positions[read.triangles[2][2]], Vec3f(0, 0, 1));
}

TEST_F(Ply, UnusedVerticesAreLeftOut) {
  const Mesh read = mesh(ply("element vertex 5\n" + xyz + face_1,
                             "nan nan nan\n0 0 0\n1 0 0\n1e30 0 0\n0 1 0\n3 1 2 4\n"));
  EXPECT_THAT(read.positions, ElementsAre(Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)));
  EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST_F(Ply, SmallAndFlatFacesAreCounted) {
  const Mesh read = mesh(
      ply("element vertex 4\n" + xyz + "element face 5\nproperty list uchar int vertex_indices\n",
          "0 0 0\n1 0 0\n0 1 0\n2 0 0\n0\n1 0\n2 0 1\n3 0 1 2\n3 0 1 3\n"));
  EXPECT_EQ(read.triangles.size(), 2U);
  EXPECT_THAT(told(),
              ElementsAre(": 3 faces of fewer than three corners are not renderable, skipped",
                          ": 1 triangles have no area"));
}

TEST_F(Ply, LinesOfNoMeaningAreTold) {
  const std::string text = "ply\nformat ascii 1.0\nCreated by hand\nelement vertex 3\n" + xyz +
                           face_1 + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n9\n";
  EXPECT_EQ(mesh(text).triangles.size(), 1U);
  EXPECT_THAT(told(), ElementsAre(":3:1: \"Created\" is no statement of a PLY header, not used",
                                  ": not used: \"what follows the last element\""));
}

}  // namespace
}  // namespace restframe
