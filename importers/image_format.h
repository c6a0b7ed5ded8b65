#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace restframe {

using ByteSpan = std::span<const std::uint8_t>;

// By the first bytes: "PNG", "JPEG", or the name of another kind that people meet; nullptr if it is
// none of these.
const char* image_kind(ByteSpan bytes);

// What of a PNG stb_image would pass over: that a chunk which matters is damaged, by its checksum.
// Empty if nothing is wrong, and in fuzzers, which would never get past it.
std::string png_fault(ByteSpan bytes);

// What of a JPEG's markers stb_image would pass over: that the file is cut off, or that its four
// channels are of no known meaning. Empty if nothing is wrong.
std::string jpeg_fault(ByteSpan bytes);

}  // namespace restframe
