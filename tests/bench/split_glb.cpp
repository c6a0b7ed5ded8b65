#include "split_glb.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace restframe {
namespace {

using nlohmann::json;

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A;

std::string little_endian(std::size_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

void split(json& document, std::size_t primitives) {
  json& all = document["meshes"][0]["primitives"];
  const json one = all[0], indices = document["accessors"][one["indices"].get<std::size_t>()];
  const auto triangles = indices["count"].get<std::size_t>() / 3;
  all.erase(0);
  for (std::size_t i = 0; i < primitives; ++i) {
    const std::size_t begin = triangles * i / primitives, end = triangles * (i + 1) / primitives;
    json part = indices;
    part["byteOffset"] = 3 * sizeof(std::uint32_t) * begin;
    part["count"] = 3 * (end - begin);
    all.push_back(one);
    all.back()["indices"] = document["accessors"].size();
    document["accessors"].push_back(part);
  }
}

}  // namespace

void split_glb(const std::string& from, const std::string& to, std::size_t primitives) {
  std::ifstream file(from, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + header_bytes, sizeof length);
  const std::size_t begin = header_bytes + chunk_header_bytes;
  json document = json::parse(bytes.substr(begin, length));
  split(document, primitives);
  std::string text = document.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  const std::size_t rest = begin + length;
  std::ofstream(to, std::ios::binary)
      << bytes.substr(0, 8) << little_endian(begin + text.size() + bytes.size() - rest)
      << little_endian(text.size()) << little_endian(json_chunk) << text << bytes.substr(rest);
}

}  // namespace restframe
