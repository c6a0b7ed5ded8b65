#include "film/png_preview.h"

#include <fstream>
#include <iterator>
#include <string>

#include "film/srgb_bytes.h"
#include "scene/atomic_file.h"
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

// A third faster than the library's defaults, and 3% larger.
void prefer_speed() {
  static const bool preferred = [] {
    stbi_write_png_compression_level = 5;
    stbi_write_force_png_filter = 4;  // Paeth's
    return true;
  }();
  static_cast<void>(preferred);
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture,
               const Development& development) {
  const SrgbBytes byte_of;
  std::vector<std::uint8_t> rgb(3 * picture.rgba().size());
  std::uint8_t* to = rgb.data();
  for (const Vec4f& pixel : picture.rgba()) {
    const Vec3f light = developed(Vec3f(pixel), development);
    for (int i = 0; i < 3; ++i) *to++ = byte_of(light[i]);
  }
  write_png(path, picture.width(), picture.height(), rgb);
}

void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const std::uint8_t> rgb) {
  prefer_speed();
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
