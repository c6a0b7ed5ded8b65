#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// A PNG of 2 x 1 pixels, red and green.
const std::vector<unsigned char> png = {
    137, 80,  78, 71,  13,  10,  26,  10, 0,   0,   0,   13,  73,  72,  68,  82, 0,  0,
    0,   2,   0,  0,   0,   1,   8,   2,  0,   0,   0,   123, 64,  232, 221, 0,  0,  0,
    15,  73,  68, 65,  84,  120, 156, 99, 248, 207, 192, 192, 240, 159, 1,   0,  7,  255,
    1,   255, 1,  127, 137, 167, 0,   0,  0,   0,   73,  69,  78,  68,  174, 66, 96, 130};

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return sum;
}

class Obj : public testing::Test {
 protected:
  Asset load(const std::string& text) {
    return load_obj(files_.write("asset.obj", text), ImportLimits{}, warnings_);
  }
  void write(const std::string& name, const std::string& text) { files_.write(name, text); }

  TemporaryFolder files_;
  Warnings warnings_;
};

TEST_F(Obj, OneTriangle) {
  const Asset asset = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(asset.name, "asset.obj");
  ASSERT_EQ(asset.meshes.size(), 1U);
  ASSERT_EQ(asset.parts.size(), 1U);
  ASSERT_EQ(asset.materials.size(), 1U);
  const Mesh& mesh = asset.meshes[0];
  EXPECT_EQ(mesh.triangles, std::vector<Triangle>({{0, 1, 2}}));
  EXPECT_EQ(mesh.normals, std::vector<Vec3f>(3, Vec3f(0, 0, 1)));
  EXPECT_TRUE(asset.materials[0].double_sided);
  EXPECT_GT(mesh.positions.capacity(), mesh.positions.size());
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Obj, LayoutOfTheTextDoesNotMatter) {
  const Asset asset = load(
      "# a comment\r\n\r\n  v\t0  0 0 # origin\r\nv 1. +0 .0\r\nv \\\r\n 0 1e0 \\\r\n0\r\n"
      "   f   -3\t-2 \\\r\n -1   # all\r\ns off");
  ASSERT_EQ(asset.meshes.size(), 1U);
  EXPECT_EQ(asset.meshes[0].positions,
            std::vector<Vec3f>({Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}));
  EXPECT_EQ(asset.meshes[0].triangles.size(), 1U);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Obj, LinesMayEndWithCarriageReturnsAlone) {
  EXPECT_EQ(load("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3").meshes[0].triangles.size(), 1U);
}

TEST_F(Obj, ByteOrderMarkOfUtf8IsSkipped) {
  EXPECT_EQ(load("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").meshes.size(), 1U);
}

TEST_F(Obj, SlashesWithoutAnIndexMeanNone) {
  const Asset asset = load(square + "vt 0 0\nvn 0 1 0\nf 1/ 2// 3/1/\nf 1// 3/ 4/\n");
  EXPECT_EQ(asset.meshes[0].triangles.size(), 2U);
  EXPECT_EQ(asset.meshes[0].normals[0], Vec3f(0, 0, 1));
}

TEST_F(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(load("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").meshes[0].triangles.size(), 1U);
}

TEST_F(Obj, VerticesAreSharedByTheirCombinationOfIndices) {
  const Asset asset = load(square +
                           "vt 0 0\nvt 1 0.25\nvn 0 0 1\nvn 0 1 0\n"
                           "f 1/1/1 2/2/1 3/1/1\nf 1/1/1 3/1/1 4/1/2\nf 1/2/1 2/2/1 3/1/1\n");
  const Mesh& mesh = asset.meshes[0];
  EXPECT_EQ(mesh.triangles, std::vector<Triangle>({{0, 1, 2}, {0, 2, 3}, {4, 1, 2}}));
  EXPECT_EQ(mesh.uvs[0][1], Vec2f(1, 0.75F));  // v downwards
  EXPECT_EQ(mesh.uvs[0][0], Vec2f(0, 1));
  EXPECT_EQ(mesh.normals[3], Vec3f(0, 1, 0));
  EXPECT_TRUE(mesh.uvs[1].empty());
}

TEST_F(Obj, GivenNormalsBecomeUnitAndMissingOnesAreComputed) {
  const Asset asset = load(square + "vn 0 3 4\nvn 0 0 0\nf 1//1 2//1 3//2\nf 1 3 4\n");
  const Mesh& mesh = asset.meshes[0];
  EXPECT_LT(glm::distance(mesh.normals[mesh.triangles[0][0]], Vec3f(0, 0.6F, 0.8F)), 1e-6F);
  EXPECT_EQ(mesh.normals[mesh.triangles[0][2]], Vec3f(0, 0, 1));
  EXPECT_EQ(mesh.normals[mesh.triangles[1][0]], Vec3f(0, 0, 1));
  EXPECT_THAT(warnings_, Contains(HasSubstr("1 vn lines have no length")));
}

// Programs write what they show: sRGB. By IEC 61966-2-1, 0.5 is ((0.5 + 0.055) / 1.055)^2.4.
TEST_F(Obj, VertexColoursBecomeLinear) {
  const Asset asset = load("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1 0.5\nv 0 1 0\nf 1 2 3\n");
  const std::vector<Vec4f>& colors = asset.meshes[0].colors;
  EXPECT_LT(glm::distance(colors[0], Vec4f(1, 0.214041F, 0, 1)), 1e-5F);
  EXPECT_EQ(colors[1], Vec4f(0, 0, 1, 0.5F));
  EXPECT_EQ(colors[2], Vec4f(1));
}

TEST_F(Obj, VertexColoursOfBytesAreScaled) {
  const Asset asset = load("v 0 0 0 255 51 0\nv 1 0 0 0 0 255\nv 0 1 0\nf 1 2 3\n");
  const std::vector<Vec4f>& colors = asset.meshes[0].colors;
  EXPECT_FLOAT_EQ(colors[0].r, 1);
  EXPECT_NEAR(colors[0].g, std::pow(0.255 / 1.055, 2.4), 1e-6);  // of 0.2
  EXPECT_FLOAT_EQ(colors[0].a, 1);
  EXPECT_EQ(colors[2], Vec4f(1));
  EXPECT_THAT(warnings_, Contains(HasSubstr("0 to 255")));
}

TEST_F(Obj, GroupsBecomePartsOfTheirNames) {
  const Asset asset = load(square +
                           "f 1 2 3\no ship\nf 1 2 3\ng hull left\nf 1 2 4\n"
                           "g deck\nf 1 3 4\ng hull left\nf 2 3 4\no sea\nf 1 2 3\n");
  std::vector<std::string> names;
  for (const Part& part : asset.parts) names.push_back(name_of(asset, part));
  EXPECT_THAT(names, testing::ElementsAre("", "ship", "hull left", "deck", "sea"));
  const auto& nodes = asset.tree.nodes;
  EXPECT_EQ(nodes[1].parent, -1);
  EXPECT_EQ(nodes[2].parent, 1);
  EXPECT_EQ(nodes[3].parent, 1);
  EXPECT_EQ(nodes[4].parent, -1);
  EXPECT_EQ(place_of(asset.tree, 2), "8");  // its line
  EXPECT_EQ(asset.meshes[2].name, "ship/hull left");
  EXPECT_EQ(asset.meshes[2].triangles.size(), 2U);
  EXPECT_EQ(asset.meshes[2].positions.size(), 4U);
  EXPECT_EQ(asset.meshes[3].positions.size(), 3U);
}

TEST_F(Obj, NormalsAreSmoothAcrossGroupsOfAnObject) {
  const Asset asset = load(
      "v 0 0 0\nv 0 1 0\nv 1 0 0.1\nv -1 0 0.1\n"
      "g right\nf 2 1 3\ng left\nf 1 2 4\n");
  ASSERT_EQ(asset.meshes.size(), 2U);
  // By symmetry the fold's own normal.
  for (const Mesh& mesh : asset.meshes) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (mesh.positions[i].x != 0) continue;
      EXPECT_LT(glm::distance(mesh.normals[i], Vec3f(0, 0, 1)), 1e-6F);
    }
  }
}

TEST_F(Obj, ABareGroupEndsTheGroup) {
  const Asset asset = load(square + "g a\nf 1 2 3\ng\nf 1 2 4\n");
  ASSERT_EQ(asset.parts.size(), 2U);
  EXPECT_EQ(name_of(asset, asset.parts[0]), "");
  EXPECT_EQ(name_of(asset, asset.parts[1]), "a");
}

TEST_F(Obj, ConcaveQuadIsCutInside) {
  // An arrowhead; cut along its other diagonal, it would cover 2 x 1 / 2 more.
  const Asset asset = load("v 0 0 0\nv 1 2 0\nv 0 1 0\nv -1 2 0\nf 1 2 3 4\n");
  ASSERT_EQ(asset.meshes[0].triangles.size(), 2U);
  EXPECT_NEAR(area_of(asset.meshes[0]), 1, 1e-6);
}

TEST_F(Obj, ConcavePolygonsKeepTheirArea) {
  for (const int points : {5, 17, 400}) {  // stars, tilted, with sharp bays
    std::string text, face = "f";
    for (int i = 0; i < 2 * points; ++i) {
      const double phi = std::acos(-1.0) * i / points, r = i % 2 ? 0.2 : 1.0;
      const double x = r * std::cos(phi), y = r * std::sin(phi);
      text += fmt::format("v {} {} {}\n", x + 7, y, x);
      face += fmt::format(" {}", i + 1);
    }
    const Asset asset = load(text + face + "\n");
    EXPECT_EQ(asset.meshes[0].triangles.size(), 2U * static_cast<std::size_t>(points) - 2);
    const double flat = points * std::sin(std::acos(-1.0) / points) * 0.2;
    EXPECT_NEAR(area_of(asset.meshes[0]), flat * std::sqrt(2.0), 2e-5 * points) << points;
  }
}

TEST_F(Obj, PolygonWithoutAreaKeepsAllItsTriangles) {
  const Asset asset = load("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3 2 1 3\n");
  EXPECT_EQ(asset.meshes[0].triangles.size(), 4U);
  EXPECT_THAT(warnings_, Contains(HasSubstr("4 triangles have no area")));
}

TEST_F(Obj, HugePolygonsTakeNoTime) {
  std::string text, face = "f";
  for (int i = 0; i < 40'000; ++i) {  // a comb: every second corner is concave
    const int x = i < 20'000 ? i : 40'000 - i;
    const double y = i < 20'000 ? 0 : (i % 2 ? 1 : 2);
    text += fmt::format("v {} {} 0\n", x, y);
    face += fmt::format(" {}", i + 1);
  }
  EXPECT_EQ(load(text + face).meshes[0].triangles.size(), 39'998U);
}

TEST_F(Obj, MaterialsOfAnMtlFile) {
  write("two words.mtl",
        "newmtl  shiny red \nKd 0.5 0.25 0\nKs 1 1 1\nNs 98\nKe 0 0 2\nd 0.5\n"
        "newmtl grey\nKd 0.5\nTr 0\nnewmtl pbr\nPr 0.3\nPm 0.7\nNs 5\nd -halo 0.75\n");
  write("other.mtl", "newmtl other\nKd 0 1 0\n");
  write("more.mtl", "newmtl more\nKd 0 0 1\n");
  const Asset asset =
      load("mtllib two words.mtl\nmtllib other.mtl more.mtl\n" + square +
           "usemtl shiny red\nf 1 2 3\nusemtl grey\nf 1 2 3\nusemtl pbr\nf 1 2 3\n"
           "usemtl  more\t\nf 1 2 3\nusemtl other\nf 1 2 4\nusemtl shiny red\nf 2 3 4\n");
  ASSERT_EQ(asset.materials.size(), 5U);
  const Material& red = asset.materials[0];
  EXPECT_EQ(red.name, "shiny red");
  EXPECT_EQ(red.base_color.value, Vec3f(0.5F, 0.25F, 0));
  EXPECT_EQ(red.emission.value, Vec3f(0, 0, 2));
  EXPECT_EQ(red.opacity.value, 0.5F);
  EXPECT_EQ(red.alpha_mode, AlphaMode::blend);
  EXPECT_FLOAT_EQ(red.roughness.value, std::pow(0.02F, 0.25F));
  EXPECT_EQ(red.metallic.value, 0);
  EXPECT_EQ(asset.materials[1].base_color.value, Vec3f(0.5F));
  EXPECT_EQ(asset.materials[1].alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(asset.materials[2].roughness.value, 0.3F);
  EXPECT_EQ(asset.materials[2].metallic.value, 0.7F);
  EXPECT_EQ(asset.materials[2].opacity.value, 0.75F);
  EXPECT_EQ(asset.materials[3].name, "more");
  EXPECT_EQ(asset.materials[3].base_color.value, Vec3f(0, 0, 1));
  const std::vector<MaterialRange>& ranges = asset.meshes[0].materials;
  ASSERT_EQ(ranges.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(ranges[i].first_triangle, i);
    EXPECT_EQ(ranges[i].slot, i % 5);
  }
  EXPECT_THAT(warnings_, testing::ElementsAre(HasSubstr("two words.mtl: not used: d -halo")));
}

TEST_F(Obj, IndicesOfRefraction) {
  write("glass.mtl", "newmtl glass\nNi 1.75\nnewmtl odd\nNi 0.5\n");
  const Asset asset =
      load("mtllib glass.mtl\n" + square + "usemtl glass\nf 1 2 3\nusemtl odd\nf 1 2 4\n");
  EXPECT_EQ(asset.materials.at(0).ior.value, 1.75F);
  EXPECT_EQ(asset.materials.at(1).ior.value, 1);
  EXPECT_THAT(warnings_, testing::ElementsAre(HasSubstr("Ni is 0.5, brought into 1 to")));
}

TEST_F(Obj, UnknownMaterialsAreGreyAndNamed) {
  const Asset asset = load("mtllib none.mtl\n" + square + "f 1 2 3\nusemtl balls\nf 1 2 4\n");
  ASSERT_EQ(asset.materials.size(), 2U);
  EXPECT_EQ(asset.materials[0].name, "balls");
  EXPECT_EQ(asset.materials[1].name, "default");
  EXPECT_EQ(asset.meshes[0].materials[0].slot, 1);
  EXPECT_THAT(warnings_, Contains(HasSubstr("asset.obj:1:8: material file \"none.mtl\"")));
  EXPECT_THAT(warnings_, Contains(HasSubstr("\"balls\"")));
}

TEST_F(Obj, TexturesAreReadOnce) {
  write("maps/pictures/red green.png", std::string(png.begin(), png.end()));
  write("maps/m.mtl",
        "newmtl a\nmap_Kd pictures\\red green.png\nmap_d x.png\nnewmtl b\nKd 0.1 0.2 0.3\n"
        "map_Kd -clamp on ../maps/pictures/red green.png\nmap_Ke pictures/red green.png\n"
        "newmtl c\nmap_Kd gone.png\n");
  const Asset asset = load("mtllib maps/m.mtl\n" + square +
                           "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n");
  ASSERT_EQ(asset.images.size(), 1U);
  EXPECT_EQ(asset.images[0].width, 2);
  ASSERT_EQ(asset.textures.size(), 2U);
  EXPECT_EQ(asset.materials[0].base_color.value, Vec3f(1));
  EXPECT_EQ(asset.materials[0].base_color_texture.texture, 0);
  EXPECT_EQ(asset.materials[1].base_color.value, Vec3f(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(asset.materials[1].base_color_texture.texture, 1);
  EXPECT_EQ(asset.textures[1].wrap_u, Wrap::clamp);
  EXPECT_EQ(asset.materials[1].emission_texture.texture, 0);
  EXPECT_EQ(asset.materials[1].emission.value, Vec3f(1));
  EXPECT_EQ(asset.materials[2].base_color_texture.texture, -1);
  EXPECT_THAT(warnings_, Contains(HasSubstr("gone.png")));
  EXPECT_THAT(warnings_, Contains(HasSubstr("map_d: image \"x.png\" does not exist, not used")));
}

TEST_F(Obj, PointsAndLinesAreNamed) {
  const Asset asset = load(square + "p 1 2\nl 1 2\nl 2 3\nf 1 2 3\nvw 1 0 1\n");
  EXPECT_EQ(asset.meshes[0].triangles.size(), 1U);
  EXPECT_THAT(warnings_, Contains(HasSubstr("asset.obj:5:1: 1 \"p\" lines: points are not")));
  EXPECT_THAT(warnings_, Contains(HasSubstr("asset.obj:6:1: 2 \"l\" lines: lines are not")));
  EXPECT_THAT(warnings_, Contains(HasSubstr("\"vw\"")));
}

// Every OBJ file of the test models, good or bad, gives an asset or an InputError.
TEST(ObjModels, LoadOrAreRefused) {
  const Path models = "/usr/share/assimp/models";
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "no test models are installed";
  int assets = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models)) {
    if (entry.path().extension() != ".obj") continue;
    Warnings warnings;
    try {
      const Asset asset = load_obj(entry.path(), ImportLimits{}, warnings);
      for (const Mesh& mesh : asset.meshes) {
        EXPECT_EQ(mesh.normals.size(), mesh.positions.size()) << entry.path();
        EXPECT_FALSE(mesh.triangles.empty()) << entry.path();
        EXPECT_EQ(mesh.materials.at(0).first_triangle, 0U) << entry.path();
      }
      ++assets;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(entry.path().string() + ":"));
      ++refused;
    }
  }
  EXPECT_GE(assets, 16);
  EXPECT_GE(refused, 6);
}

}  // namespace
}  // namespace restframe
