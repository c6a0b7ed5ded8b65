#include "support/gltf_builder.h"

namespace restframe::test {
namespace {

int components_of(const std::string& type) {
  if (type == "SCALAR") return 1;
  const int n = type[3] - '0';
  return type[0] == 'M' ? n * n : n;
}

}  // namespace

int GltfBuilder::add_view(const void* bytes, std::size_t size, int stride) {
  bin.resize((bin.size() + 3) / 4 * 4);
  nlohmann::json view = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", size}};
  if (stride > 0) view["byteStride"] = stride;
  bin.append(static_cast<const char*>(bytes), size);
  return add("bufferViews", view);
}

int GltfBuilder::add_accessor_of_view(int view, int component, const std::string& type,
                                      std::size_t components, bool normalized) {
  return add("accessors", {{"bufferView", view},
                           {"componentType", component},
                           {"type", type},
                           {"count", components / static_cast<std::size_t>(components_of(type))},
                           {"normalized", normalized}});
}

int GltfBuilder::add(const std::string& key, const nlohmann::json& element) {
  json[key].push_back(element);
  return static_cast<int>(json[key].size()) - 1;
}

int GltfBuilder::add_mesh(const nlohmann::json& primitive) {
  const int mesh = add("meshes", {{"primitives", nlohmann::json::array({primitive})}});
  add("nodes", {{"mesh", mesh}});
  return mesh;
}

std::string GltfBuilder::glb() const {
  nlohmann::json document = json;
  if (!bin.empty() && !document.contains("buffers")) {
    document["buffers"].push_back({{"byteLength", bin.size()}});
  }
  return glb_of(document.dump(), bin);
}

std::string GltfBuilder::gltf(const std::string& bin_uri) const {
  nlohmann::json document = json;
  document["buffers"].push_back({{"byteLength", bin.size()}, {"uri", bin_uri}});
  return document.dump();
}

GltfBuilder one_triangle() {
  GltfBuilder builder;
  const int positions = builder.add_accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const int indices = builder.add_accessor<std::uint16_t>({0, 1, 2}, "SCALAR");
  builder.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  return builder;
}

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& content) {
  return little_endian(static_cast<std::uint32_t>(content.size())) + type + content;
}

std::string glb_of(const std::string& json, const std::string& bin) {
  std::string padded = json, padded_bin = bin;
  padded.resize((json.size() + 3) / 4 * 4, ' ');
  padded_bin.resize((bin.size() + 3) / 4 * 4);
  std::string chunks = chunk("JSON", padded);
  if (!bin.empty()) chunks += chunk(std::string("BIN\0", 4), padded_bin);
  return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(12 + chunks.size())) +
         chunks;
}

std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace restframe::test
