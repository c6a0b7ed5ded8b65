#include "importers/image_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/message.h"

namespace restframe {
namespace {

struct Signature {
  const char* kind;
  std::size_t offset;
  std::string_view bytes;
};

constexpr std::array signatures = {
    Signature{"PNG", 0, "\x89PNG\r\n\x1a\n"},
    Signature{"JPEG", 0, "\xff\xd8\xff"},
    Signature{"WebP", 8, "WEBP"},
    Signature{"KTX2", 0, "\xabKTX 20"},
    Signature{"KTX", 0, "\xabKTX 11"},
    Signature{"DDS", 0, "DDS "},
    Signature{"GIF", 0, "GIF8"},
    Signature{"BMP", 0, "BM"},
    Signature{"TIFF", 0, "II*"},
    Signature{"TIFF", 0, "MM"},
    Signature{"OpenEXR", 0, "v/1\x01"},
    Signature{"Radiance HDR", 0, "#?"},
    Signature{"AVIF", 4, "ftypavif"},
    Signature{"SVG", 0, "<svg"},
};

bool has(ByteSpan bytes, const Signature& signature) {
  if (bytes.size() < signature.offset + signature.bytes.size()) return false;
  return std::equal(signature.bytes.begin(), signature.bytes.end(),
                    bytes.begin() + static_cast<std::ptrdiff_t>(signature.offset),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

std::uint32_t big_endian(ByteSpan bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[2]} << 8 | bytes[3];
}

// PNG's checksum (ISO/IEC 15948, annex D): the remainder modulo a polynomial, a byte at a time.
std::uint32_t crc32(ByteSpan bytes) {
  static const std::array<std::uint32_t, 256> remainders = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
      std::uint32_t rest = byte;
      for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ ((rest & 1) != 0 ? 0xEDB88320U : 0U);
      table[byte] = rest;
    }
    return table;
  }();
  std::uint32_t rest = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) rest = rest >> 8 ^ remainders[(rest ^ byte) & 0xFF];
  return ~rest;
}

// Markers of ITU-T T.81, table B.1.
constexpr std::uint8_t start_of_scan = 0xDA, end_of_image = 0xD9, adobe_segment = 0xEE;

bool stands_alone(std::uint8_t marker) {
  return marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8);
}

bool is_frame_header(std::uint8_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// Whether some scan ends in an end of image: inside of one, 0xFF is followed by 0 or a restart.
bool is_ended(ByteSpan scans) {
  for (std::size_t i = 0; i + 1 < scans.size(); ++i) {
    if (scans[i] == 0xFF && scans[i + 1] == end_of_image) return true;
  }
  return false;
}

}  // namespace

const char* image_kind(ByteSpan bytes) {
  for (const Signature& signature : signatures) {
    if (has(bytes, signature)) return signature.kind;
  }
  return nullptr;
}

std::string png_fault(ByteSpan bytes) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  if (!bytes.empty()) return "";
#endif
  constexpr std::size_t signature = 8, frame = 12;  // a chunk's length, name and checksum
  for (std::size_t at = signature; at + frame <= bytes.size();) {
    const std::size_t length = big_endian(bytes.subspan(at));
    if (length > bytes.size() - at - frame) break;  // the decoder will say that it is cut off
    const ByteSpan content = bytes.subspan(at + 4, 4 + length);
    const bool matters = (content[0] & 0x20) == 0;  // its name begins with a capital
    if (matters && crc32(content) != big_endian(bytes.subspan(at + 8 + length))) {
      return fmt::format("damaged: the checksum of its {} chunk is wrong",
                         quote(std::string(content.begin(), content.begin() + 4)));
    }
    at += frame + length;
  }
  return "";
}

std::string jpeg_fault(ByteSpan bytes) {
  int components = 0;
  bool adobe = false;
  for (std::size_t i = 2; i + 4 <= bytes.size();) {
    const std::uint8_t marker = bytes[i + 1];
    if (bytes[i] != 0xFF) break;  // the decoder will say what is wrong
    if (marker == 0xFF || stands_alone(marker)) {
      i += marker == 0xFF ? 1 : 2;
      continue;
    }
    const std::size_t length = std::size_t{256} * bytes[i + 2] + bytes[i + 3];
    if (is_frame_header(marker) && i + 9 < bytes.size()) components = bytes[i + 9];
    adobe |= marker == adobe_segment;
    if (marker == start_of_scan) {
      if (!is_ended(bytes.subspan(i))) return "cut off: it has no end-of-image marker";
      break;
    }
    i += 2 + length;
  }
  if (components == 4 && !adobe) {
    return "of four channels whose meaning it does not say; save it as RGB";
  }
  return "";
}

}  // namespace restframe
