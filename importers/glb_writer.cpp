#include "importers/glb_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "scene/atomic_file.h"
#include "scene/error.h"

namespace restframe {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF stores numbers little-endian");
static_assert(sizeof(Vec3f) == 12 && sizeof(Triangle) == 12);

// Values of the specification.
constexpr int no_target = 0, array_buffer = 34962, element_array_buffer = 34963;
constexpr int float_component = 5126, unsigned_int_component = 5125;
constexpr std::uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

// 0.8F as 0.8, not as 0.800000011920929.
double short_double(float value) {
  return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

nlohmann::ordered_json array_of(const Vec3f& v) {
  return {short_double(v.x), short_double(v.y), short_double(v.z)};
}

// The triangles of a material range, and the vertices from the first to the last that they use.
struct RangeExtent {
  std::size_t first_triangle, triangles;
  std::uint32_t first_vertex, vertices;
};

RangeExtent extent_of(const Mesh& mesh, std::size_t range) {
  const std::size_t begin = mesh.materials[range].first_triangle;
  const std::size_t end = range + 1 < mesh.materials.size()
                              ? mesh.materials[range + 1].first_triangle
                              : mesh.triangles.size();
  std::uint32_t lowest = std::numeric_limits<std::uint32_t>::max(), highest = 0;
  for (std::size_t i = begin; i < end; ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      lowest = std::min(lowest, vertex);
      highest = std::max(highest, vertex);
    }
  }
  return {begin, end - begin, lowest, highest - lowest + 1};
}

std::string as_bytes(std::initializer_list<std::uint32_t> words) {
  return {reinterpret_cast<const char*>(words.begin()), 4 * words.size()};
}

}  // namespace

GlbWriter::GlbWriter(const std::string& root_name) {
  json_["asset"] = {{"version", "2.0"}, {"generator", "restframe"}};
  json_["scene"] = 0;
  json_["scenes"][0]["nodes"][0] = 0;
  json_["nodes"][0]["name"] = root_name;
  json_["nodes"][0]["children"] = Json::array();
}

int GlbWriter::add_material(const Material& material) {
  Json color = array_of(material.base_color.value);
  color.push_back(short_double(material.opacity.value));
  Json json = {{"name", material.name},
               {"pbrMetallicRoughness",
                {{"baseColorFactor", color},
                 {"metallicFactor", short_double(material.metallic.value)},
                 {"roughnessFactor", short_double(material.roughness.value)}}}};
  if (material.double_sided) json["doubleSided"] = true;
  json_["materials"].push_back(std::move(json));
  return static_cast<int>(json_["materials"].size()) - 1;
}

int GlbWriter::add_mesh(const Mesh& mesh) {
  Json primitives = Json::array();
  for (std::size_t range = 0; range < mesh.materials.size(); ++range) {
    primitives.push_back(primitive(mesh, range));
  }
  json_["meshes"].push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
  return static_cast<int>(json_["meshes"].size()) - 1;
}

GlbWriter::Json GlbWriter::primitive(const Mesh& mesh, std::size_t range) {
  const RangeExtent extent = extent_of(mesh, range);
  std::span<const Triangle> triangles(mesh.triangles);
  triangles = triangles.subspan(extent.first_triangle, extent.triangles);
  if (extent.first_vertex > 0) {
    auto& rebased = rebased_.emplace_back(triangles.begin(), triangles.end());
    for (Triangle& triangle : rebased) {
      for (std::uint32_t& vertex : triangle) vertex -= extent.first_vertex;
    }
    triangles = rebased;
  }
  const auto used = [&](const std::vector<Vec3f>& attribute) {
    return std::span(attribute).subspan(extent.first_vertex, extent.vertices);
  };
  Json attributes;
  attributes["POSITION"] = add_vectors(used(mesh.positions), array_buffer, true);
  if (!mesh.normals.empty()) {
    attributes["NORMAL"] = add_vectors(used(mesh.normals), array_buffer, false);
  }
  return {{"attributes", std::move(attributes)},
          {"indices", add_indices(triangles)},
          {"material", mesh.materials[range].slot}};
}

GlbWriter::Json& GlbWriter::add_placed(const std::string& name, const Mat3& rotation) {
  Json& nodes = json_["nodes"];
  nodes[0]["children"].push_back(nodes.size());
  nodes.push_back({{"name", name}});
  Json& node = nodes.back();
  const glm::dquat q = glm::quat_cast(rotation);
  if (q.x != 0 || q.y != 0 || q.z != 0) node["rotation"] = {q.x, q.y, q.z, q.w};
  return node;
}

void GlbWriter::add_node(const std::string& name, int mesh, const Mat3& rotation,
                         const Vec3& translation) {
  Json& node = add_placed(name, rotation);
  node["mesh"] = mesh;
  node["translation"] = {translation.x, translation.y, translation.z};
}

void GlbWriter::add_instances(const std::string& name, int mesh, const Mat3& rotation,
                              const std::vector<Vec3f>& translations) {
  const char* const extension = "EXT_mesh_gpu_instancing";
  json_["extensionsUsed"][0] = extension;
  json_["extensionsRequired"][0] = extension;
  const std::size_t accessor = add_vectors(translations, no_target, false);
  Json& node = add_placed(name, rotation);
  node["mesh"] = mesh;
  node["extensions"][extension]["attributes"]["TRANSLATION"] = accessor;
}

std::size_t GlbWriter::add_view(std::span<const std::byte> bytes, int target) {
  Json view = {{"buffer", 0}, {"byteOffset", binary_size_}, {"byteLength", bytes.size()}};
  if (target != no_target) view["target"] = target;
  json_["bufferViews"].push_back(std::move(view));
  blocks_.push_back(bytes);
  binary_size_ += bytes.size();
  return json_["bufferViews"].size() - 1;
}

std::size_t GlbWriter::add_vectors(std::span<const Vec3f> vectors, int target, bool bounds) {
  Json accessor = {{"bufferView", add_view(std::as_bytes(vectors), target)},
                   {"componentType", float_component},
                   {"count", vectors.size()},
                   {"type", "VEC3"}};
  if (bounds) {
    Vec3f lower = vectors[0], upper = vectors[0];
    for (const Vec3f& vector : vectors) {
      lower = glm::min(lower, vector);
      upper = glm::max(upper, vector);
    }
    accessor["min"] = array_of(lower);
    accessor["max"] = array_of(upper);
  }
  json_["accessors"].push_back(std::move(accessor));
  return json_["accessors"].size() - 1;
}

std::size_t GlbWriter::add_indices(std::span<const Triangle> triangles) {
  json_["accessors"].push_back(
      {{"bufferView", add_view(std::as_bytes(triangles), element_array_buffer)},
       {"componentType", unsigned_int_component},
       {"count", 3 * triangles.size()},
       {"type", "SCALAR"}});
  return json_["accessors"].size() - 1;
}

void GlbWriter::write(const std::filesystem::path& path) {
  json_["buffers"][0]["byteLength"] = binary_size_;
  std::string text = json_.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  const std::uint64_t size = 12 + 8 + text.size() + 8 + binary_size_;
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw OutputError(
        fmt::format("{}: {} bytes are too many for a binary glTF file, which holds 4294967295",
                    path.string(), size));
  }
  const auto word = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  write_file_atomically(path, [&](AtomicFile& file) {
    file.write(as_bytes({glb_magic, 2, word(size), word(text.size()), json_chunk}));
    file.write(text);
    file.write(as_bytes({word(binary_size_), binary_chunk}));
    for (const auto& block : blocks_) file.write(block);
  });
}

}  // namespace restframe
