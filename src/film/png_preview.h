#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "film/picture.h"
#include "film/view_transform.h"

namespace restframe {

// The beauty over black, in sRGB. Throws OutputError.
void write_png(const std::filesystem::path& path, const Picture& picture,
               const Development& development = {});

// An sRGB picture of 3 bytes a pixel, rows from the top. Throws OutputError.
void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const std::uint8_t> rgb);

// Whether a file is a PNG from its beginning to its end.
bool is_whole_png(const std::filesystem::path& path);

}  // namespace restframe
