#include "support/image_files.h"

#include <cstdlib>

#include "support/gltf_builder.h"

namespace restframe::test {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes = little_endian(value);
  return {bytes.rbegin(), bytes.rend()};
}

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

std::uint32_t adler32(const std::string& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

// Huffman-coded bits of a JPEG, the first the highest.
class BitWriter {
 public:
  void put(unsigned bits, int count) {
    for (int i = count - 1; i >= 0; --i) {
      byte_ = byte_ << 1 | (bits >> i & 1U);
      if (++filled_ == 8) flush();
    }
  }

  std::string take() {
    while (filled_ != 0) put(1, 1);
    return std::move(bytes_);
  }

 private:
  void flush() {
    bytes_ += static_cast<char>(byte_);
    if ((byte_ & 0xFFU) == 0xFFU) bytes_ += '\0';
    byte_ = 0;
    filled_ = 0;
  }

  std::string bytes_;
  unsigned byte_ = 0;
  int filled_ = 0;
};

std::string jpeg_segment(int marker, const std::string& content) {
  const std::size_t length = content.size() + 2;
  const std::string head = {'\xff', static_cast<char>(marker), static_cast<char>(length >> 8),
                            static_cast<char>(length & 0xFF)};
  return head + content;
}

// One block a component, with nothing but its mean. With a quantisation step of 8, the coefficient
// is the value less 128; its difference from the one before, 0, has as many bits as it needs.
std::string flat_scan(const std::vector<std::uint8_t>& components, bool progressive) {
  BitWriter bits;
  for (const std::uint8_t component : components) {
    const int value = component - 128;
    int size = 0;
    while (std::abs(value) >> size != 0) ++size;
    bits.put(static_cast<unsigned>(size), 4);
    bits.put(static_cast<unsigned>(value < 0 ? value + (1 << size) - 1 : value), size);
    if (!progressive) bits.put(0, 1);  // the end of the block
  }
  return bits.take();
}

}  // namespace

std::string png_chunk(const std::string& type, const std::string& content) {
  return big_endian(static_cast<std::uint32_t>(content.size())) + type + content +
         big_endian(crc32(type + content));
}

std::string png_header(std::uint32_t width, std::uint32_t height) {
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", big_endian(width) + big_endian(height) +
                                                     std::string("\x08\x06\0\0\0", 5));
}

std::string png_of(int width, int height, int depth, PngColor color,
                   const std::vector<std::string>& rows, const std::string& chunks) {
  std::string filtered;
  for (const std::string& row : rows) filtered += '\0' + row;
  // One stored block: deflate without compression holds up to 65535 bytes.
  const auto size = static_cast<std::uint32_t>(filtered.size());
  const std::string zlib = std::string("\x78\x01\x01", 3) + little_endian(size | (~size << 16)) +
                           filtered + big_endian(adler32(filtered));
  const std::string kind = {static_cast<char>(depth), static_cast<char>(color), 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" +
         png_chunk("IHDR", big_endian(static_cast<std::uint32_t>(width)) +
                               big_endian(static_cast<std::uint32_t>(height)) + kind) +
         chunks + png_chunk("IDAT", zlib) + png_chunk("IEND", "");
}

std::string png(int width, int height, const std::string& rgba) {
  std::vector<std::string> rows;
  const auto row_size = static_cast<std::size_t>(4 * width);
  for (int row = 0; row < height; ++row) {
    rows.push_back(rgba.substr(static_cast<std::size_t>(row) * row_size, row_size));
  }
  return png_of(width, height, 8, PngColor::rgba, rows);
}

std::string flat_jpeg(const std::vector<std::uint8_t>& components, const JpegKind& kind) {
  const std::string count(1, static_cast<char>(components.size()));
  std::string frame = std::string("\x08\0\x08\0\x08", 5) + count, scan = count;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const char id = static_cast<char>(i + 1);
    frame += {id, '\x11', '\0'};
    scan += {id, '\0'};
  }
  scan += {'\0', kind.progressive ? '\0' : '\x3f', '\0'};
  // Nine codes of four bits for the sizes 0 to 8; one code of one bit for the end of a block.
  std::string dc = std::string("\0\0\0\0\x09", 5) + std::string(12, '\0');
  for (char size = 0; size <= 8; ++size) dc += size;
  const std::string ac = std::string("\x10\x01", 2) + std::string(15, '\0') + '\0';
  std::string file = "\xff\xd8";
  if (kind.adobe_transform >= 0) {
    file += jpeg_segment(
        0xEE, "Adobe" + std::string("\0\x64\0\0\0\0", 6) + static_cast<char>(kind.adobe_transform));
  }
  file += jpeg_segment(0xDB, '\0' + std::string(64, '\x08'));
  file += jpeg_segment(kind.progressive ? 0xC2 : 0xC0, frame);
  file += jpeg_segment(0xC4, dc) + jpeg_segment(0xC4, ac);
  return file + jpeg_segment(0xDA, scan) + flat_scan(components, kind.progressive) + "\xff\xd9";
}

}  // namespace restframe::test
