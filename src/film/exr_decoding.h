#pragma once

#include <filesystem>

namespace restframe {

// Whether a file is an EXR, of whatever make, all of whose pixels can be read.
bool decodes(const std::filesystem::path& path);

}  // namespace restframe
