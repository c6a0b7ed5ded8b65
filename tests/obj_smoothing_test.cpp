// Normals of OBJ files that give none: smoothing groups.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "importers/importers.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

// The cube [-1, 1]^3, outwards, its faces in the order -z +z -y +y -x +x.
const std::string vertices =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string faces[] = {"f 4 3 2 1\n", "f 5 6 7 8\n", "f 1 2 6 5\n",
                             "f 3 4 8 7\n", "f 1 5 8 4\n", "f 2 3 7 6\n"};

std::string all_faces() {
  std::string result;
  for (const std::string& face : faces) result += face;
  return result;
}

class ObjSmoothing : public testing::Test {
 protected:
  Asset load(const std::string& text) {
    return load_obj(files_.write("asset.obj", text), ImportLimits{}, warnings_);
  }

  // The normal of each corner of each triangle of the first mesh, with its position.
  struct Corner {
    Vec3 position, normal, face;
  };
  std::vector<Corner> corners_of(const std::string& text) {
    const Asset asset = load(text);
    const Mesh& mesh = asset.meshes.at(0);
    std::vector<Corner> result;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
      const Vec3 face = glm::normalize(glm::cross(b - a, c - a));
      for (const std::uint32_t v : t) {
        const Vec3 normal = mesh.normals.empty() ? face : Vec3(mesh.normals.at(v));
        result.push_back({Vec3(mesh.positions[v]), normal, face});
      }
    }
    return result;
  }

  TemporaryFolder files_;
  Warnings warnings_;
};

// By symmetry, the three faces of a corner add up to its direction from the centre.
TEST_F(ObjSmoothing, NormalsAreSharedInAGroup) {
  const auto corners = corners_of(vertices + "s 1\n" + all_faces());
  ASSERT_EQ(corners.size(), 36U);
  for (const Corner& c : corners) {
    EXPECT_LT(glm::distance(c.normal, glm::normalize(c.position)), 1e-6);
  }
}

TEST_F(ObjSmoothing, OffIsFlat) {
  for (const std::string off : {"s off\n", "s 0\n"}) {
    const Asset asset = load(vertices + off + all_faces());
    EXPECT_EQ(asset.meshes[0].positions.size(), 24U);  // four a face
    for (const Corner& c : corners_of(vertices + off + all_faces())) {
      EXPECT_LT(glm::distance(c.normal, c.face), 1e-6);
    }
  }
}

// Even where crease angles would make it smooth.
TEST_F(ObjSmoothing, FlatTrianglesNeedNoNormals) {
  const Asset asset = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.1\ns off\nf 1 2 3\nf 2 4 3\n");
  EXPECT_TRUE(asset.meshes[0].normals.empty());
  EXPECT_EQ(asset.meshes[0].positions.size(), 4U);
}

// Between groups the edge is hard: each group has the average of its own faces only.
TEST_F(ObjSmoothing, EdgesBetweenGroupsAreHard) {
  const auto corners = corners_of(vertices + "s 1\n" + faces[0] + faces[2] + "s 2\n" + faces[1] +
                                  "s 7\n" + faces[3] + faces[4] + faces[5]);
  for (const Corner& c : corners) {
    if (c.face.z > 0.5) {
      EXPECT_LT(glm::distance(c.normal, Vec3(0, 0, 1)), 1e-6);
    }
    if (c.face.z < -0.5 && c.position.y < 0) {  // the edge of the first two
      EXPECT_LT(glm::distance(c.normal, glm::normalize(Vec3(0, -1, -1))), 1e-6);
    }
    if (c.face.z < -0.5 && c.position.y > 0) {
      EXPECT_LT(glm::distance(c.normal, c.face), 1e-6);
    }
  }
}

TEST_F(ObjSmoothing, GroupsGoOnAfterOthers) {
  const auto corners =
      corners_of(vertices + "s 1\n" + faces[0] + "s off\n" + faces[1] + "s 1\n" + faces[2]);
  EXPECT_LT(glm::distance(corners[6].normal, Vec3(0, 0, 1)), 1e-6);
  for (const Corner& c : corners) {
    if (c.position.y < 0 && c.position.z < 0) {
      EXPECT_LT(glm::distance(c.normal, glm::normalize(Vec3(0, -1, -1))), 1e-6);
    }
  }
}

// What comes before the first statement is in no group.
TEST_F(ObjSmoothing, FacesBeforeTheFirstStatementAreFlat) {
  for (const Corner& c : corners_of(vertices + faces[0] + faces[2] + "s 3\n" + faces[1])) {
    EXPECT_LT(glm::distance(c.normal, c.face), 1e-6);
  }
}

// Seams of texture coordinates do not show; vertices apart at one place do.
TEST_F(ObjSmoothing, SharingGoesByVertexNumber) {
  const std::string fold = "v 0 0 0\nv 0 1 0\nv 1 0 1\nv -1 0 1\n";
  const std::string uvs = "vt 0 0\nvt 1 1\n";
  for (const Corner& c : corners_of(fold + uvs + "s 1\nf 2/1 1/1 3/1\nf 1/2 2/2 4/2\n")) {
    if (c.position.x == 0) {
      EXPECT_LT(glm::distance(c.normal, Vec3(0, 0, 1)), 1e-6);
    }
  }
  for (const Corner& c : corners_of(fold + "v 0 0 0\nv 0 1 0\ns 1\nf 2 1 3\nf 5 6 4\n")) {
    EXPECT_LT(glm::distance(c.normal, c.face), 1e-6);
  }
}

TEST_F(ObjSmoothing, GivenNormalsStay) {
  const auto corners = corners_of(vertices + "vn 0 1 0\ns 1\nf 4//1 3//1 2//1 1//1\n" + faces[2]);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(corners[i].normal, Vec3(0, 1, 0));
  // The face that lacks them shares those of its group.
  EXPECT_LT(glm::distance(corners[6].normal, glm::normalize(Vec3(0, -1, -1))), 1e-6);
}

TEST_F(ObjSmoothing, ABentPolygonIsOneFlatFace) {
  const auto corners = corners_of("v 0 0 0\nv 1 0 0.3\nv 1 1 0\nv 0 1 0.3\ns off\nf 1 2 3 4\n");
  // By symmetry about its middle.
  for (const Corner& c : corners) EXPECT_LT(glm::distance(c.normal, Vec3(0, 0, 1)), 1e-6);
}

TEST_F(ObjSmoothing, OtherValuesAreNamed) {
  load(vertices + "s one\ns -3\ns on\n" + all_faces());
  EXPECT_THAT(warnings_,
              testing::ElementsAre(testing::EndsWith(
                  "asset.obj:9:1: 2 \"s\" lines: must be a whole number or off, skipped")));
}

}  // namespace
}  // namespace restframe
