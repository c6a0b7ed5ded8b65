#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/glb_reader.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::json;

// 12 balls of 80 triangles; rods of 10: 1*3*2 along x, 2*2*2 along y, 2*3*1 along z.
const LatticeSettings small{2, 3, 2, 1.0, 0.2, 0.1, 1, 5};
constexpr std::size_t small_balls = 12, small_rods = 20, small_triangles = 12 * 80 + 20 * 10;

GlbFile written(const LatticeSettings& settings, InstanceMode mode) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "lattice.glb";
  write_lattice(settings, mode, path);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  return read_glb(path);
}

// What the format asks of every file, whatever is in it.
void expect_valid(const GlbFile& glb) {
  const Json& json = glb.json;
  EXPECT_EQ(json["asset"], (Json{{"version", "2.0"}, {"generator", "restframe"}}));
  ASSERT_EQ(json["buffers"].size(), 1U);
  EXPECT_EQ(json["buffers"][0]["byteLength"], glb.binary.size());
  std::size_t end = 0;
  for (const Json& view : json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
    EXPECT_EQ(view["byteOffset"], end);  // neither gaps nor overlaps
    end += view["byteLength"].get<std::size_t>();
  }
  EXPECT_EQ(end, glb.binary.size());
  for (const Json& accessor : json["accessors"]) {
    const std::size_t size = accessor["type"] == "VEC3" ? 12 : 4;
    EXPECT_GT(accessor["count"], 0);
    EXPECT_EQ(json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteLength"],
              size * accessor["count"].get<std::size_t>());
  }
}

// Bounds given are those of the vertices; triangles use all of their vertices and face along the
// normals.
void expect_sound_primitive(const GlbFile& glb, const Json& primitive) {
  const auto positions = glb.vectors(primitive["attributes"]["POSITION"]);
  const auto normals = glb.vectors(primitive["attributes"]["NORMAL"]);
  const auto indices = glb.indices(primitive["indices"]);
  ASSERT_EQ(normals.size(), positions.size());
  Bounds bounds;
  for (const Vec3f& position : positions) bounds.add(position);
  const Json& accessor = glb.json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(accessor["min"][i].get<float>(), static_cast<float>(bounds.lower[i]));
    EXPECT_EQ(accessor["max"][i].get<float>(), static_cast<float>(bounds.upper[i]));
  }
  EXPECT_EQ(std::set(indices.begin(), indices.end()).size(), positions.size());
  EXPECT_EQ(*std::max_element(indices.begin(), indices.end()), positions.size() - 1);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Vec3f p = positions.at(indices[i]), q = positions.at(indices[i + 1]),
                r = positions.at(indices[i + 2]);
    const Vec3f normal = glm::normalize(glm::cross(q - p, r - p));
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_GT(glm::dot(normal, normals.at(indices[i + corner])), 0.6F);
      EXPECT_NEAR(glm::length(normals.at(indices[i + corner])), 1, 1e-6);
    }
  }
}

void expect_sound_meshes(const GlbFile& glb) {
  for (const Json& mesh : glb.json["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) expect_sound_primitive(glb, primitive);
  }
}

std::size_t triangles_of(const GlbFile& glb, const Json& mesh) {
  std::size_t triangles = 0;
  for (const Json& primitive : mesh["primitives"]) {
    triangles += glb.indices(primitive["indices"]).size() / 3;
  }
  return triangles;
}

// The corners of all triangles in the file's coordinates, rounded, to be compared as sets.
using Corners = std::multiset<std::array<long, 3>>;
std::array<long, 3> rounded(const Vec3& p) {
  return {std::lround(p.x * 1e4), std::lround(p.y * 1e4), std::lround(p.z * 1e4)};
}

// Vec3 `v` turned by a glTF quaternion, by the textbook's formula.
Vec3 turned(const Json& node, const Vec3& v) {
  if (!node.contains("rotation")) return v;
  const auto q = node["rotation"].get<std::vector<double>>();
  const Vec3 u(q.at(0), q.at(1), q.at(2));
  EXPECT_NEAR(glm::dot(u, u) + q.at(3) * q.at(3), 1, 1e-12);
  return v + 2.0 * glm::cross(u, glm::cross(u, v) + q.at(3) * v);
}

std::vector<Vec3f> instances_of(const GlbFile& glb, const Json& node) {
  if (!node.contains("extensions")) return {Vec3f(0)};
  return glb.vectors(node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"]);
}

Vec3 translation_of(const Json& node) {
  const auto t = node.value("translation", std::vector<double>{0, 0, 0});
  return {t.at(0), t.at(1), t.at(2)};
}

Corners corners_of(const GlbFile& glb) {
  Corners corners;
  for (const Json& node : glb.json["nodes"]) {
    if (!node.contains("mesh")) continue;
    for (const Json& primitive : glb.json["meshes"][node["mesh"].get<int>()]["primitives"]) {
      const auto positions = glb.vectors(primitive["attributes"]["POSITION"]);
      const auto indices = glb.indices(primitive["indices"]);
      for (const Vec3f& instance : instances_of(glb, node)) {
        for (const std::uint32_t i : indices) {
          corners.insert(
              rounded(turned(node, Vec3(instance + positions.at(i))) + translation_of(node)));
        }
      }
    }
  }
  return corners;
}

Corners expected_corners(const LatticeSettings& settings) {
  const Asset asset = make_lattice(settings, true);
  Corners corners;
  for (const Triangle& triangle : asset.meshes[0].triangles) {
    for (const std::uint32_t vertex : triangle) {
      corners.insert(rounded(asset.meshes[0].positions[vertex]));
    }
  }
  return corners;
}

// Rounding may fall either way: each corner has one in `b` at most a unit away along each axis.
void expect_alike(const Corners& a, const Corners& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [x, y, z] : a) {
    bool found = false;
    for (long i = 0; i < 27 && !found; ++i) {
      found = b.count({x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1}) > 0;
    }
    ASSERT_TRUE(found) << x << " " << y << " " << z;
  }
}

TEST(LatticeGlb, HasANodeForEachPart) {
  const GlbFile glb = written(small, InstanceMode::nodes);
  expect_valid(glb);
  expect_sound_meshes(glb);
  const Json& nodes = glb.json["nodes"];
  ASSERT_EQ(nodes.size(), 1 + small_balls + small_rods);
  EXPECT_EQ(glb.json["scenes"][glb.json["scene"].get<int>()]["nodes"], Json::array({0}));
  EXPECT_EQ(nodes[0]["children"].size(), small_balls + small_rods);
  ASSERT_EQ(glb.json["meshes"].size(), 2U);
  std::size_t triangles = 0;
  for (const Json& node : nodes) {
    if (node.contains("mesh")) {
      triangles += triangles_of(glb, glb.json["meshes"][node["mesh"].get<int>()]);
    }
  }
  EXPECT_EQ(triangles, small_triangles);
  EXPECT_FALSE(glb.json.contains("extensionsUsed"));
  expect_alike(corners_of(glb), expected_corners(small));
}

TEST(LatticeGlb, HasInstances) {
  const GlbFile glb = written(small, InstanceMode::gpu);
  expect_valid(glb);
  expect_sound_meshes(glb);
  EXPECT_EQ(glb.json["extensionsUsed"], Json::array({"EXT_mesh_gpu_instancing"}));
  EXPECT_EQ(glb.json["extensionsRequired"], Json::array({"EXT_mesh_gpu_instancing"}));
  std::vector<std::size_t> counts;
  for (const Json& node : glb.json["nodes"]) {
    if (node.contains("mesh")) counts.push_back(instances_of(glb, node).size());
  }
  EXPECT_THAT(counts, ElementsAre(small_balls, 6, 8, 6));
  expect_alike(corners_of(glb), expected_corners(small));
}

TEST(LatticeGlb, IsOneFlatMesh) {
  const GlbFile glb = written(small, InstanceMode::none);
  expect_valid(glb);
  expect_sound_meshes(glb);
  ASSERT_EQ(glb.json["meshes"].size(), 1U);
  ASSERT_EQ(glb.json["meshes"][0]["primitives"].size(), 2U);
  EXPECT_EQ(glb.json["meshes"][0]["primitives"][0]["material"], 0);
  EXPECT_EQ(glb.json["meshes"][0]["primitives"][1]["material"], 1);
  EXPECT_EQ(triangles_of(glb, glb.json["meshes"][0]), small_triangles);
  expect_alike(corners_of(glb), expected_corners(small));
}

TEST(LatticeGlb, HasTwoMaterials) {
  for (const auto mode : {InstanceMode::nodes, InstanceMode::gpu, InstanceMode::none}) {
    const Json materials = written(small, mode).json["materials"];
    ASSERT_EQ(materials.size(), 2U);
    EXPECT_EQ(materials[0]["name"], "balls");
    EXPECT_EQ(materials[1]["name"], "rods");
    EXPECT_EQ(materials[0]["pbrMetallicRoughness"],
              (Json{{"baseColorFactor", {0.8, 0.15, 0.1, 1.0}},
                    {"metallicFactor", 0.0},
                    {"roughnessFactor", 0.5}}));
  }
}

TEST(LatticeGlb, OfOneBallHasNothingEmpty) {
  for (const auto mode : {InstanceMode::nodes, InstanceMode::gpu, InstanceMode::none}) {
    const GlbFile glb = written({1, 1, 1, 1.0, 0.2, 0.1, 1, 5}, mode);
    expect_valid(glb);
    expect_sound_meshes(glb);
    ASSERT_EQ(glb.json["meshes"].size(), 1U);
    EXPECT_EQ(glb.json["nodes"].size(), 2U);
  }
}

TEST(LatticeGlb, OfAMillionBallsTakesLittleSpace) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "million.glb";
  write_lattice({100, 100, 100}, InstanceMode::gpu, path);
  const std::size_t vectors = 12 * (1'000'000 + 3 * 99 * 100 * 100);
  EXPECT_GT(fs::file_size(path), vectors);
  EXPECT_LT(fs::file_size(path), vectors + 100'000);
}

std::string fault_of(const LatticeSettings& settings, InstanceMode mode, const fs::path& path) {
  try {
    write_lattice(settings, mode, path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LatticeWriter, RefusesWhatItCanNotWrite) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glb";
  EXPECT_THAT(fault_of({100, 100, 100}, InstanceMode::nodes, path),
              AllOf(HasSubstr("3970000"), HasSubstr("100000"), HasSubstr("gpu")));
  EXPECT_THAT(fault_of({100, 100, 100}, InstanceMode::none, path), HasSubstr("triangles"));
  EXPECT_THAT(fault_of({100, 100, 100}, InstanceMode::gpu, folder.path() / "a.obj"),
              HasSubstr("triangles"));
  EXPECT_THAT(fault_of({0, 1, 1}, InstanceMode::gpu, path), HasSubstr("cells along x 0"));
  for (const char* name : {"a.gltf", "a.stl", "glb", "a"}) {
    EXPECT_THAT(fault_of(small, InstanceMode::none, folder.path() / name),
                AllOf(HasSubstr(name), HasSubstr(".glb or .obj")));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(LatticeWriter, LeavesNothingWhereItCanNotWrite) {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder.path() / "full.glb");
  fs::create_symlink("/dev/full", folder.path() / "full.obj");
  fs::create_symlink("/dev/full", folder.path() / "good.mtl");
  for (const char* name : {"full.glb", "full.obj", "good.obj"}) {
    EXPECT_THROW(write_lattice(small, InstanceMode::none, folder.path() / name), OutputError);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 3);
}

TEST(LatticeWriter, WritesTheSameBytesEachTime) {
  const TemporaryFolder folder;
  for (const char* name : {"a.GLB", "b.glb"}) {
    write_lattice(small, InstanceMode::nodes, folder.path() / name);
  }
  const auto bytes = [&](const char* name) {
    std::ifstream file(folder.path() / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(bytes("a.GLB"), bytes("b.glb"));
}

}  // namespace
}  // namespace restframe
