#include "importers/jpeg_check.h"

#include <algorithm>
#include <cstddef>

namespace restframe {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t marker_dht = 0xC4, marker_soi = 0xD8, marker_sos = 0xDA;

// As stb_image has it, what is beyond the end is zeros.
unsigned byte_at(Bytes jpeg, std::size_t at) {
  return at < jpeg.size() ? jpeg[at] : 0U;
}

std::size_t length_at(Bytes jpeg, std::size_t at) {
  return byte_at(jpeg, at) << 8 | byte_at(jpeg, at + 1);
}

// The segment's tables, one after the other: a byte, the numbers of codes of 1 to 16 bits, then a
// value a code. The last table counts even where it leaves the segment.
bool is_sound_segment(Bytes jpeg, std::size_t segment) {
  const std::size_t end = segment + length_at(jpeg, segment);
  for (std::size_t table = segment + 2; table < end;) {
    unsigned codes = 0;
    for (std::size_t bits = 1; bits <= 16; ++bits) codes += byte_at(jpeg, table + bits);
    if (codes > 256) return false;
    table += 17 + codes;
  }
  return true;
}

// From the first scan on, segments can not be told from picture data with certainty, so whatever
// looks like the start of tables must be sound.
bool are_sound_from(Bytes jpeg, std::size_t at) {
  for (; at + 1 < jpeg.size(); ++at) {
    if (jpeg[at] == 0xFF && jpeg[at + 1] == marker_dht && !is_sound_segment(jpeg, at + 2)) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool has_sound_huffman_tables(Bytes jpeg) {
  std::size_t at = 0;
  while (true) {
    while (at < jpeg.size() && jpeg[at] != 0xFF) ++at;
    while (at < jpeg.size() && jpeg[at] == 0xFF) ++at;
    if (at >= jpeg.size()) return true;
    const std::uint8_t marker = jpeg[at++];
    if (marker == marker_soi) continue;
    if (marker == marker_sos) return are_sound_from(jpeg, at);
    if (marker == marker_dht && !is_sound_segment(jpeg, at)) return false;
    at += std::max<std::size_t>(length_at(jpeg, at), 2);
  }
}

}  // namespace restframe
