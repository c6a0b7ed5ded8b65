#include "film/png_preview.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "scene/atomic_file.h"
#include "scene/color.h"
#include "scene/error.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace restframe {
namespace {

void append_bytes(void* to, void* bytes, int count) {
  const auto* first = static_cast<const std::byte*>(bytes);
  static_cast<std::vector<std::byte>*>(to)->insert(static_cast<std::vector<std::byte>*>(to)->end(),
                                                   first, first + count);
}

std::uint8_t byte_of(float encoded) {
  const float value = std::isfinite(encoded) ? glm::clamp(encoded, 0.0F, 1.0F) : 1.0F;
  return static_cast<std::uint8_t>(std::lround(255.0F * value));
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture,
               const Development& development) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * picture.rgba().size());
  for (const Vec4f& pixel : picture.rgba()) {
    const Vec3f encoded = srgb_from_linear(developed(Vec3f(pixel), development));
    for (int i = 0; i < 3; ++i) rgb.push_back(byte_of(encoded[i]));
  }
  write_png(path, picture.width(), picture.height(), rgb);
}

void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const std::uint8_t> rgb) {
  std::vector<std::byte> file;
  if (stbi_write_png_to_func(append_bytes, &file, width, height, 3, rgb.data(), 3 * width) == 0) {
    throw OutputError(path.string() + ": the picture can not be encoded as PNG");
  }
  write_file_atomically(path, file);
}

// A PNG is a row of chunks, each with its length in front of its type, data and checksum; the last one is
// empty and of a type of its own.
bool is_whole_png(const std::filesystem::path& path) {
  using namespace std::string_literals;
  const std::string signature = "\x89PNG\r\n\x1a\n";
  const std::string end = "\0\0\0\0IEND\xae\x42\x60\x82"s;
  constexpr std::size_t around = 12;  // bytes of a chunk besides its data
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!bytes.starts_with(signature) || !bytes.ends_with(end)) return false;
  std::size_t at = signature.size();
  while (bytes.size() - at > end.size()) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    if (bytes.size() - at - around < length) return false;
    at += around + length;
  }
  return bytes.size() - at == end.size();
}

}  // namespace restframe
