#include "film/png_preview.h"

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

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

constexpr const char* label_type = "tEXt";
constexpr std::size_t around_chunk = 12;  // bytes of a chunk besides its data

// A text's keyword, a NUL, the text.
std::string label_data(const std::string& label) {
  return std::string("restframe") + '\0' + label;
}

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::string label_chunk(const std::string& label) {
  const std::string data = label_data(label);
  std::string summed = label_type + data;
  const unsigned sum = stbiw__crc32(reinterpret_cast<unsigned char*>(summed.data()),
                                    static_cast<int>(summed.size()));
  return big_endian(data.size()) + summed + big_endian(sum);
}

// Behind the signature and the first chunk, which has to be first.
void insert_chunk(std::vector<std::byte>& png, const std::string& chunk) {
  constexpr std::ptrdiff_t signature_and_header = 8 + 13 + around_chunk;
  const auto* bytes = reinterpret_cast<const std::byte*>(chunk.data());
  png.insert(png.begin() + signature_and_header, bytes, bytes + chunk.size());
}

}  // namespace

void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const std::uint8_t> rgb, const std::string& label) {
  prefer_speed();
  std::vector<std::byte> file;
  if (stbi_write_png_to_func(append_bytes, &file, width, height, 3, rgb.data(), 3 * width) == 0) {
    throw OutputError(path.string() + ": the picture can not be encoded as PNG");
  }
  if (!label.empty()) insert_chunk(file, label_chunk(label));
  write_file_atomically(path, file);
}

// A PNG is a row of chunks, each with its length in front of its type, data and checksum; the last one is
// empty and of a type of its own.
bool is_whole_png(const std::filesystem::path& path, const std::string& label) {
  using namespace std::string_literals;
  const std::string signature = "\x89PNG\r\n\x1a\n";
  const std::string end = "\0\0\0\0IEND\xae\x42\x60\x82"s;
  const std::string wanted = label_type + label_data(label);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!bytes.starts_with(signature) || !bytes.ends_with(end)) return false;
  std::size_t at = signature.size();
  bool labelled = false;
  while (bytes.size() - at > end.size()) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    if (bytes.size() - at - around_chunk < length) return false;
    labelled = labelled || std::string_view(bytes).substr(at + 4, 4 + length) == wanted;
    at += around_chunk + length;
  }
  return labelled && bytes.size() - at == end.size();
}

}  // namespace restframe
