#include "support/compressed_gltf.h"

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include <cmath>

namespace restframe::test {
namespace {

int add_draco_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, int components,
                        const std::vector<float>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<std::uint8_t>(components), draco::DT_FLOAT32, false,
                 static_cast<std::int64_t>(sizeof(float)) * components, 0);
  const auto count = static_cast<std::uint32_t>(values.size()) / static_cast<unsigned>(components);
  const int id = mesh.AddAttribute(attribute, true, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                          &values[i * static_cast<unsigned>(components)]);
  }
  return id;
}

nlohmann::json accessor(int component, const char* type, std::size_t count) {
  return {{"componentType", component}, {"type", type}, {"count", count}};
}

}  // namespace

PlainMesh bent_sheet(int columns, int rows) {
  PlainMesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const auto x = static_cast<float>(i), y = static_cast<float>(j);
      const float u = x / static_cast<float>(columns), v = y / static_cast<float>(rows);
      for (const float p : {x, y, std::sin(0.5F * x) * std::cos(0.25F * y)}) {
        mesh.positions.push_back(p);
      }
      for (const float p : {u, v}) mesh.uvs.push_back(p);
      if (i == columns || j == rows) continue;
      const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i);
      const std::uint32_t b = a + static_cast<std::uint32_t>(columns) + 1;
      for (const std::uint32_t index : {a, a + 1, b, b, a + 1, b + 1}) {
        mesh.indices.push_back(index);
      }
    }
  }
  return mesh;
}

std::vector<std::uint8_t> draco_bytes(const PlainMesh& plain, const DracoSettings& settings) {
  draco::Mesh mesh;
  const std::size_t vertices = plain.positions.size() / 3;
  mesh.set_num_points(static_cast<std::uint32_t>(vertices));
  mesh.SetNumFaces(plain.indices.size() / 3);
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
    draco::Mesh::Face face;
    for (std::uint32_t k = 0; k < 3; ++k) face[k] = draco::PointIndex(plain.indices[3 * i + k]);
    mesh.SetFace(draco::FaceIndex(i), face);
  }
  add_draco_attribute(mesh, draco::GeometryAttribute::POSITION, 3, plain.positions);
  add_draco_attribute(mesh, draco::GeometryAttribute::TEX_COORD, 2, plain.uvs);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(settings.edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING
                                                 : draco::MESH_SEQUENTIAL_ENCODING);
  encoder.SetSpeedOptions(settings.edgebreaker ? 3 : 10, settings.edgebreaker ? 3 : 10);
  if (settings.position_bits > 0) {
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, settings.position_bits);
  }
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(mesh, &buffer).ok()) return {};
  return {buffer.data(), buffer.data() + buffer.size()};
}

GltfBuilder draco_gltf(const PlainMesh& mesh, const std::vector<std::uint8_t>& bytes) {
  GltfBuilder builder;
  builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  builder.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  const std::size_t vertices = mesh.positions.size() / 3;
  const int view = builder.add_view(bytes);
  const int positions = builder.add("accessors", accessor(5126, "VEC3", vertices));
  const int uvs = builder.add("accessors", accessor(5126, "VEC2", vertices));
  const int indices = builder.add("accessors", accessor(5125, "SCALAR", mesh.indices.size()));
  builder.add_mesh(
      {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
       {"indices", indices},
       {"extensions",
        {{"KHR_draco_mesh_compression",
          {{"bufferView", view}, {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}}}}}});
  return builder;
}

GltfBuilder plain_gltf(const PlainMesh& mesh) {
  GltfBuilder builder;
  const int positions = builder.add_accessor<float>(mesh.positions, "VEC3");
  const int uvs = builder.add_accessor<float>(mesh.uvs, "VEC2");
  const int indices = builder.add_accessor<std::uint32_t>(mesh.indices, "SCALAR");
  builder.add_mesh(
      {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}}, {"indices", indices}});
  return builder;
}

std::vector<std::uint8_t> meshopt_vertices(const void* vertices, std::size_t count,
                                           std::size_t stride) {
  std::vector<std::uint8_t> bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), vertices, count, stride));
  return bytes;
}

int add_meshopt_view(GltfBuilder& builder, const std::vector<std::uint8_t>& bytes,
                     std::size_t count, std::size_t stride, const char* mode, const char* filter) {
  builder.bin.resize((builder.bin.size() + 3) / 4 * 4);
  const nlohmann::json extension = {{"buffer", 0},
                                    {"byteOffset", builder.bin.size()},
                                    {"byteLength", bytes.size()},
                                    {"byteStride", stride},
                                    {"count", count},
                                    {"mode", mode},
                                    {"filter", filter}};
  builder.bin.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  nlohmann::json view = {{"buffer", 1},
                         {"byteLength", count * stride},
                         {"extensions", {{"EXT_meshopt_compression", extension}}}};
  if (std::string(mode) == "ATTRIBUTES") view["byteStride"] = stride;
  builder.json["buffers"] = {{{"byteLength", builder.bin.size()}},
                             {{"byteLength", 1'000'000},
                              {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  builder.json["extensionsUsed"] = {"EXT_meshopt_compression"};
  builder.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  return builder.add("bufferViews", view);
}

GltfBuilder meshopt_gltf(const PlainMesh& mesh) {
  GltfBuilder builder;
  const std::size_t vertices = mesh.positions.size() / 3;
  std::vector<std::uint8_t> indices(meshopt_encodeIndexBufferBound(mesh.indices.size(), vertices));
  indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), mesh.indices.data(),
                                           mesh.indices.size()));
  const int positions_view = add_meshopt_view(
      builder, meshopt_vertices(mesh.positions.data(), vertices, 12), vertices, 12, "ATTRIBUTES");
  const int uvs_view = add_meshopt_view(builder, meshopt_vertices(mesh.uvs.data(), vertices, 8),
                                        vertices, 8, "ATTRIBUTES");
  const int index_view = add_meshopt_view(builder, indices, mesh.indices.size(), 4, "TRIANGLES");
  const int positions =
      builder.add_accessor_of_view(positions_view, 5126, "VEC3", mesh.positions.size(), false);
  const int uvs = builder.add_accessor_of_view(uvs_view, 5126, "VEC2", mesh.uvs.size(), false);
  const int triangles =
      builder.add_accessor_of_view(index_view, 5125, "SCALAR", mesh.indices.size(), false);
  builder.add_mesh(
      {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}}, {"indices", triangles}});
  return builder;
}

}  // namespace restframe::test
