// The PLY, STL and OFF files of the Debian package assimp-testmodels: each is read, with as many
// triangles as it says, or refused for what is wrong with it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "importers/importers.h"
#include "scene/error.h"

namespace restframe {
namespace {

const std::filesystem::path models = "/usr/share/assimp/models";

class MeshModels : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(models)) GTEST_SKIP() << "assimp-testmodels is not installed";
  }
};

bool is_mesh_file(const std::filesystem::path& path) {
  const std::string extension = path.extension();
  return extension == ".ply" || extension == ".off" || extension == ".stl" || extension == ".STL";
}

// Triangles as the files' own counts have them: quads are two.
const std::map<std::string, std::size_t> triangles = {{"Cube.off", 12},
                                                      {"Wuson.off", 3732},
                                                      {"Wuson.ply", 3732},
                                                      {"cube.ply", 12},
                                                      {"cube_binary.ply", 12},
                                                      {"cube_uv.ply", 12},
                                                      {"float-color.ply", 1},
                                                      {"3DSMaxExport.STL", 2000},
                                                      {"Spider_ascii.stl", 1368},
                                                      {"Spider_binary.stl", 1368},
                                                      {"Wuson.stl", 3732},
                                                      {"sphereWithHole.stl", 285},
                                                      {"triangle.stl", 1},
                                                      {"triangle_with_empty_solid.stl", 1},
                                                      {"triangle_with_two_solids.stl", 2}};

const std::map<std::string, std::string> faults = {
    {"empty.off", ": the file ends early: no OFF header"},
    {"empty.ply", ":1:1: no PLY file: the first line must be \"ply\""},
    {"invalid.off", ":7:1: a face of 2 corners ends after 0"},
    {"OutOfMemory.off", ":2:1: 353535235358 vertices can not be in a file of 309 bytes"},
    {"issue623.ply", ":14:1: \"7.941797\", must be a whole number from 0 to 255"},
    {"points.ply",
     ": nothing to render: 4 vertices, no faces (points and lines are not renderable)"},
    {"pond.0.ply",
     ": element \"vertex\" of 70051 rows needs at least 31 bytes a row, the file has "
     "2171512 left (truncated?)"}};

std::string result_of(const std::filesystem::path& path) {
  Warnings warnings;
  try {
    std::size_t count = 0;
    for (const Mesh& mesh : load_asset(path, {}, warnings).meshes) count += mesh.triangles.size();
    return std::to_string(count);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(path.string().size());
  }
}

TEST_F(MeshModels, EachIsReadOrRefused) {
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models)) {
    if (!is_mesh_file(entry.path())) continue;
    ++found;
    const std::string name = entry.path().filename();
    const auto fault = faults.find(name);
    if (fault != faults.end()) {
      EXPECT_EQ(result_of(entry.path()), fault->second) << name;
    } else {
      ASSERT_EQ(triangles.count(name), 1U) << name;
      EXPECT_EQ(result_of(entry.path()), std::to_string(triangles.at(name))) << name;
    }
  }
  EXPECT_EQ(found, triangles.size() + faults.size());
}

}  // namespace
}  // namespace restframe
