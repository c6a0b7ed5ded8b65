#include "importers/image_format.h"

#include <algorithm>
#include <array>
#include <string_view>

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
