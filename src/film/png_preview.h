#pragma once

#include <filesystem>

#include "film/picture.h"

namespace restframe {

// The beauty over black, in sRGB. Throws OutputError.
void write_png(const std::filesystem::path& path, const Picture& picture);

}  // namespace restframe
