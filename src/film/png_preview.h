#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace restframe {

// An sRGB picture of 3 bytes a pixel, rows from the top. `label`: a text for is_whole_png. Throws
// OutputError.
void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const std::uint8_t> rgb, const std::string& label = {});

// Whether a file is a PNG from its beginning to its end, with this label.
bool is_whole_png(const std::filesystem::path& path, const std::string& label);

}  // namespace restframe
