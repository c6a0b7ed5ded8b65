#pragma once

// Small image files, made in memory by tests.

#include <cstdint>
#include <string>
#include <vector>

namespace restframe::test {

// A PNG of 8-bit RGBA pixels, 4 bytes each, row after row from the top.
std::string png(int width, int height, const std::string& rgba);

// A PNG that claims these sizes and holds nothing.
std::string png_header(std::uint32_t width, std::uint32_t height);

// PNG's colour types.
enum class PngColor : char { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgba = 6 };

// A PNG of any kind. `rows` are the packed samples of each row, big-endian; `chunks` come before the
// pixels (png_chunk("PLTE", ...)).
std::string png_of(int width, int height, int depth, PngColor color,
                   const std::vector<std::string>& rows, const std::string& chunks = "");
std::string png_chunk(const std::string& type, const std::string& content);

// A JPEG of 8 x 8 pixels that all have these component values (0 to 255): YCbCr, grey, or with four
// components and the transform that Adobe's marker says (0: CMYK, each as 255 minus the ink).
struct JpegKind {
  bool progressive = false;
  int adobe_transform = -1;  // -1: no such marker
};
std::string flat_jpeg(const std::vector<std::uint8_t>& components, const JpegKind& kind = {});

}  // namespace restframe::test
