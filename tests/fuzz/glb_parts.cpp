#include "fuzz/glb_parts.h"

#include "support/gltf_builder.h"

namespace restframe::fuzz {
namespace {

constexpr std::size_t header_size = 12, chunk_header_size = 8;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

}  // namespace

std::optional<GlbParts> split_glb(std::string_view bytes) {
  if (bytes.size() < header_size + chunk_header_size || bytes.substr(0, 4) != "glTF") {
    return std::nullopt;
  }
  GlbParts parts;
  std::string* into = &parts.json;
  bytes.remove_prefix(header_size);
  while (bytes.size() >= chunk_header_size && into != nullptr) {
    const std::size_t size = number_at(bytes, 0);
    bytes.remove_prefix(chunk_header_size);
    if (size > bytes.size()) return std::nullopt;
    *into = bytes.substr(0, size);
    bytes.remove_prefix(size);
    into = into == &parts.json ? &parts.bin : nullptr;
  }
  return parts;
}

std::string join_glb(const GlbParts& parts) {
  return test::glb_of(parts.json, parts.bin);
}

}  // namespace restframe::fuzz
