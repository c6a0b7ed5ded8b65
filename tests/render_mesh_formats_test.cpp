// PLY, STL and OFF on pixels: a square of half-width 1 across z = 0, seen straight on from (0, 0, 2)
// by a camera that sees y from -2 to 2 there. Unlit, so that colours come out as they are.

#include <gtest/gtest.h>

#include <stdexcept>

#include "physics/vectors.h"
#include "support/exr_reader.h"
#include "support/gltf_builder.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

class MeshFormats : public testing::Test {
 protected:
  // A picture of 40 by 40 pixels, 10 to the unit.
  ExrPicture picture(const std::string& name, const std::string& asset,
                     const std::string& more = "") {
    files_.write(name, asset);
    const auto scene = files_.write(
        "scene.toml",
        "[camera]\nposition = [0, 0, 2]\nfov = 90\n[output]\nlayers = [\"beauty\", \"N\"]\n"
        "[[object]]\nasset = \"" +
            name + "\"\n[[material]]\nname = \"default\"\nunlit = true\n" + more);
    const auto file = files_.path() / "picture.exr";
    const RunResult result = run_program(
        RESTFRAME_PROGRAM, {"render", scene.string(), "--output", file.string(), "--size", "40x40",
                            "--samples", "1", "--quiet", "--overwrite"});
    if (result.exit_code != 0) throw std::runtime_error(result.error);
    return read_exr(file);
  }

  // The pixel that shows (x, y, 0).
  static void expect_color(const ExrPicture& shown, double x, double y, const Vec3& expected) {
    const int column = static_cast<int>(20 + 10 * x), row = static_cast<int>(20 - 10 * y);
    EXPECT_NEAR(shown.at("R", column, row), expected.r, 2e-3) << x << ' ' << y;
    EXPECT_NEAR(shown.at("G", column, row), expected.g, 2e-3) << x << ' ' << y;
    EXPECT_NEAR(shown.at("B", column, row), expected.b, 2e-3) << x << ' ' << y;
  }

  TemporaryFolder files_;
};

const std::string ply_begin = "ply\nformat ascii 1.0\n";
const std::string ply_xyz =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

// Byte 188 of sRGB is 0.5029 linear (IEC 61966-2-1); colours vary linearly between vertices.
TEST_F(MeshFormats, VertexColors) {
  const std::string ply = ply_begin + ply_xyz +
                          "property uchar red\nproperty uchar green\nproperty uchar blue\n" +
                          ply_face +
                          "-1 -1 0 0 188 255\n1 -1 0 255 188 255\n1 1 0 255 188 0\n-1 1 0 0 188 0\n"
                          "4 0 1 2 3\n";
  const ExrPicture shown = picture("square.ply", ply);
  for (const double x : {-0.85, 0.05, 0.75}) {
    for (const double y : {-0.75, 0.05, 0.85}) {
      expect_color(shown, x, y, {(1 + x) / 2, 0.5029, (1 - y) / 2});
    }
  }
  EXPECT_EQ(shown.at("A", 5, 20), 0);
}

// A colour of the scene file multiplies those of the file.
TEST_F(MeshFormats, VertexColorsTimesFactor) {
  const std::string off =
      "COFF\n4 1 0\n-1 -1 0 1 0 1\n1 -1 0 1 0 1\n1 1 0 1 0 1\n-1 1 0 1 0 1\n"
      "4 0 1 2 3\n";
  expect_color(picture("square.off", off, "base_color = [0.5, 1, 0.25]\n"), 0.05, 0.05,
               {0.5, 0, 0.25});
}

TEST_F(MeshFormats, FaceColors) {
  const std::string off =
      "OFF\n4 2 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n"
      "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n";
  const ExrPicture shown = picture("square.off", off);
  expect_color(shown, 0.55, -0.55, {1, 0, 0});
  expect_color(shown, -0.55, 0.55, {0, 0, 1});
}

// t points up: the image's first row is at t = 1. Its quarters are of 2 by 2 pixels.
TEST_F(MeshFormats, TextureOfPly) {
  const std::string red("\xFF\0\0\xFF", 4), green("\0\xFF\0\xFF", 4), blue("\0\0\xFF\xFF", 4),
      white("\xFF\xFF\xFF\xFF", 4);
  const std::string top = red + red + green + green, bottom = blue + blue + white + white;
  files_.write("red green blue white.png", test::png(4, 4, top + top + bottom + bottom));
  const std::string ply = ply_begin + "comment TextureFile red green blue white.png\n" + ply_xyz +
                          "property float s\nproperty float t\n" + ply_face +
                          "-1 -1 0 0 0\n1 -1 0 1 0\n1 1 0 1 1\n-1 1 0 0 1\n4 0 1 2 3\n";
  const ExrPicture shown = picture("square.ply", ply);
  expect_color(shown, -0.45, 0.55, {1, 0, 0});
  expect_color(shown, 0.55, 0.55, {0, 1, 0});
  expect_color(shown, -0.45, -0.45, {0, 0, 1});
  expect_color(shown, 0.55, -0.45, {1, 1, 1});
}

// Wound away from the camera, or towards it: seen alike, with normals towards it.
TEST_F(MeshFormats, BothSidesOfStl) {
  const std::string begin = "solid\nfacet normal 0 0 0\nouter loop\nvertex -1 -1 0\n";
  const std::string end = "endloop\nendfacet\nendsolid\n";
  for (const std::string middle :
       {"vertex 1 -1 0\nvertex 1 1 0\n", "vertex 1 1 0\nvertex 1 -1 0\n"}) {
    const ExrPicture shown = picture("triangle.stl", begin + middle + end);
    expect_color(shown, 0.55, -0.45, {0.8, 0.8, 0.8});
    EXPECT_EQ(shown.at("A", 15, 10), 0);
  }
}

}  // namespace
}  // namespace restframe
