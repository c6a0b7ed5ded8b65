// The glTF files of the Debian package assimp-testmodels: each is read or refused, and what can be
// counted in the files themselves agrees.

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "importers/importers.h"
#include "scene/error.h"

namespace restframe {
namespace {

const std::filesystem::path models = "/usr/share/assimp/models/glTF2";

class GltfModels : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(models)) GTEST_SKIP() << "assimp-testmodels is not installed";
  }
};

// The JSON chunk of a .glb, or a whole .gltf.
nlohmann::json document_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  if (bytes.rfind("glTF", 0) == 0) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, 4);
    bytes = bytes.substr(20, length);
  }
  return nlohmann::json::parse(bytes);
}

TEST_F(GltfModels, EachIsReadOrRefused) {
  int read = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models)) {
    const std::string extension = entry.path().extension();
    if (extension != ".gltf" && extension != ".glb") continue;
    Warnings warnings;
    try {
      const Asset asset = load_gltf(entry.path(), {}, warnings);
      ++read;
      EXPECT_GE(asset.materials.size(), 1U) << entry.path();
      for (const Part& part : asset.parts) {
        EXPECT_LT(static_cast<std::size_t>(part.mesh), asset.meshes.size()) << entry.path();
      }
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).rfind(entry.path().string() + ":", 0), 0U)
          << error.what();
    }
  }
  EXPECT_GE(read, 25);
  EXPECT_GE(refused, 5);
}

TEST_F(GltfModels, TheEngineHasAllItsTriangles) {
  const auto path = models / "2CylinderEngine-glTF-Binary/2CylinderEngine.glb";
  const nlohmann::json document = document_of(path);
  std::size_t triangles = 0, placements = 0;
  for (const auto& mesh : document["meshes"]) {
    for (const auto& primitive : mesh["primitives"]) {
      const auto accessor = primitive["indices"].get<std::size_t>();
      triangles += document["accessors"][accessor]["count"].get<std::size_t>() / 3;
    }
  }
  for (const auto& node : document["nodes"]) placements += node.contains("mesh");

  Warnings warnings;
  const Asset asset = load_gltf(path, {}, warnings);
  std::size_t read = 0;
  for (const Mesh& mesh : asset.meshes) read += mesh.triangles.size();
  EXPECT_EQ(asset.meshes.size(), document["meshes"].size());
  EXPECT_EQ(asset.parts.size(), placements);
  EXPECT_EQ(asset.materials.size(), document["materials"].size());
  EXPECT_EQ(read, triangles);
}

TEST_F(GltfModels, TheTexturedBoxIsAUnitCubeWithOneImage) {
  Warnings warnings;
  for (const char* name :
       {"BoxTextured-glTF/BoxTextured.gltf", "BoxTextured-glTF-Binary/BoxTextured.glb",
        "BoxTextured-glTF-Embedded/BoxTextured.gltf"}) {
    const Asset asset = load_gltf(models / name, {}, warnings);
    ASSERT_EQ(asset.meshes.size(), 1U);
    const Bounds bounds = bounds_of(asset.meshes[0]);
    EXPECT_EQ(bounds.lower, Vec3(-0.5));
    EXPECT_EQ(bounds.upper, Vec3(0.5));
    EXPECT_EQ(asset.meshes[0].triangles.size(), 12U);
    ASSERT_EQ(asset.images.size(), 1U);
    EXPECT_EQ(asset.images[0].width, 211);
    EXPECT_EQ(asset.images[0].height, 211);
    EXPECT_GE(asset.materials[0].base_color_texture.texture, 0);
  }
}

TEST_F(GltfModels, RecursionAndMissingFilesAreNamed) {
  const auto fault_of = [](const char* name) -> std::string {
    Warnings warnings;
    try {
      load_gltf(models / name, {}, warnings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(fault_of("RecursiveNodes/RecursiveNodes.gltf").find("a cycle"), std::string::npos);
  EXPECT_NE(fault_of("MissingBin/BoxTextured.gltf").find(":/buffers/0/uri: can not find file"),
            std::string::npos);
  EXPECT_NE(fault_of("IndexOutOfRange/IndexOutOfRange.gltf").find("index 255 is not below"),
            std::string::npos);
}

}  // namespace
}  // namespace restframe
