#pragma once

#include <cstdint>
#include <span>

namespace restframe {

// Whether every Huffman table of a JPEG has at most the 256 codes that there can be (ITU T.81,
// B.2.4.2): stb_image writes past the end of its tables where one has more. Tells nothing else.
bool has_sound_huffman_tables(std::span<const std::uint8_t> jpeg);

}  // namespace restframe
