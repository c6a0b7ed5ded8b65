#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "importers/importers.h"
#include "support/temporary_folder.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

namespace restframe {
namespace {

struct ObjFile {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string complaints;
};

ObjFile read_obj(const std::filesystem::path& path) {
  ObjFile obj;
  std::string warnings, errors;
  EXPECT_TRUE(tinyobj::LoadObj(&obj.attributes, &obj.shapes, &obj.materials, &warnings, &errors,
                               path.c_str(), (path.parent_path().string() + "/").c_str(), false));
  obj.complaints = warnings + errors;
  return obj;
}

TEST(LatticeObj, IsTheFlatLattice) {
  const LatticeSettings settings{2, 3, 2, 0.7, 0.2, 0.1, 1, 5};
  const TemporaryFolder folder;
  // Instances are not for OBJ: any mode gives the flat mesh.
  write_lattice(settings, InstanceMode::nodes, folder.path() / "lattice.obj");
  const ObjFile obj = read_obj(folder.path() / "lattice.obj");
  EXPECT_EQ(obj.complaints, "");
  const Mesh mesh = make_lattice(settings, true).meshes.at(0);
  ASSERT_EQ(obj.shapes.size(), 1U);
  EXPECT_EQ(obj.shapes[0].name, "lattice");
  ASSERT_EQ(obj.attributes.vertices.size(), 3 * mesh.positions.size());
  ASSERT_EQ(obj.attributes.normals.size(), 3 * mesh.normals.size());
  for (std::size_t i = 0; i < obj.attributes.vertices.size(); ++i) {
    ASSERT_FLOAT_EQ(obj.attributes.vertices[i], mesh.positions[i / 3][static_cast<int>(i % 3)]);
    ASSERT_FLOAT_EQ(obj.attributes.normals[i], mesh.normals[i / 3][static_cast<int>(i % 3)]);
  }
  const auto& indices = obj.shapes[0].mesh.indices;
  ASSERT_EQ(indices.size(), 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    ASSERT_EQ(indices[i].vertex_index, static_cast<int>(mesh.triangles[i / 3][i % 3]));
    ASSERT_EQ(indices[i].normal_index, indices[i].vertex_index);
  }
}

TEST(LatticeObj, UsesTwoMaterialsOfTheFileBesideIt) {
  const TemporaryFolder folder;
  write_lattice({2, 3, 2, 1.0, 0.2, 0.1, 1, 5}, InstanceMode::none,
                folder.path() / "my lattice.obj");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "my_lattice.mtl"));
  const ObjFile obj = read_obj(folder.path() / "my lattice.obj");
  EXPECT_EQ(obj.complaints, "");
  ASSERT_EQ(obj.materials.size(), 2U);
  EXPECT_EQ(obj.materials[0].name, "balls");
  EXPECT_EQ(obj.materials[1].name, "rods");
  EXPECT_FLOAT_EQ(static_cast<float>(obj.materials[0].diffuse[1]), 0.15F);
  EXPECT_FLOAT_EQ(static_cast<float>(obj.materials[0].roughness), 0.5F);
  const auto& ids = obj.shapes.at(0).mesh.material_ids;
  EXPECT_EQ(std::count(ids.begin(), ids.end(), 0), 12 * 80);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), 1), 20 * 10);
}

TEST(LatticeObj, HoldsNumbersThatReadBackExactly) {
  const TemporaryFolder folder;
  const LatticeSettings settings{1, 1, 2, 0.7, 0.2, 0.1, 2, 5};
  write_lattice(settings, InstanceMode::none, folder.path() / "a.obj");
  const Mesh mesh = make_lattice(settings, true).meshes.at(0);
  std::ifstream file(folder.path() / "a.obj");
  std::size_t vertices = 0;
  for (std::string keyword, line; file >> keyword; std::getline(file, line)) {
    if (keyword != "v") continue;
    std::string x, y, z;
    file >> x >> y >> z;
    const Vec3f read(std::stof(x), std::stof(y), std::stof(z));
    ASSERT_EQ(read, mesh.positions.at(vertices++));
  }
  EXPECT_EQ(vertices, mesh.positions.size());
}

}  // namespace
}  // namespace restframe
