#include "support/glb_reader.h"

#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace restframe {
namespace {

void require(bool condition, const char* rule) {
  if (!condition) throw std::runtime_error(rule);
}

std::uint32_t word(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.substr(offset, 4).c_str(), 4);
  return value;
}

template <class T>
std::vector<T> elements(const GlbFile& glb, std::size_t index, const char* type, int component) {
  const auto& accessor = glb.json.at("accessors").at(index);
  require(accessor.at("type") == type && accessor.at("componentType") == component,
          "accessor type");
  const auto& view = glb.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const auto offset = view.at("byteOffset").get<std::size_t>();
  std::vector<T> result(accessor.at("count").get<std::size_t>());
  require(result.size() * sizeof(T) <= view.at("byteLength"), "accessor beyond its view");
  require(offset + result.size() * sizeof(T) <= glb.binary.size(), "view beyond the buffer");
  std::memcpy(result.data(), glb.binary.data() + offset, result.size() * sizeof(T));
  return result;
}

}  // namespace

std::vector<Vec3f> GlbFile::vectors(std::size_t accessor) const {
  std::vector<Vec3f> result;
  for (const auto& v : elements<std::array<float, 3>>(*this, accessor, "VEC3", 5126)) {
    result.emplace_back(v[0], v[1], v[2]);
  }
  return result;
}

std::vector<std::uint32_t> GlbFile::indices(std::size_t accessor) const {
  return elements<std::uint32_t>(*this, accessor, "SCALAR", 5125);
}

GlbFile read_glb(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  require(bytes.size() >= 28 && bytes.substr(0, 4) == "glTF", "magic number");
  require(word(bytes, 4) == 2, "version 2");
  require(word(bytes, 8) == bytes.size(), "length of the file");
  const std::size_t json_size = word(bytes, 12);
  require(bytes.substr(16, 4) == "JSON" && json_size % 4 == 0, "JSON chunk");
  const std::size_t binary = 20 + json_size;
  require(bytes.substr(binary + 4, 4) == std::string("BIN\0", 4), "BIN chunk");
  require(binary + 8 + word(bytes, binary) == bytes.size(), "length of the BIN chunk");
  return {nlohmann::json::parse(bytes.substr(20, json_size)), bytes.substr(binary + 8)};
}

}  // namespace restframe
