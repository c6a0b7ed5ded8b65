#pragma once

#include <filesystem>
#include <string>

namespace restframe {

// The folder of `path`, "." if it names none.
std::filesystem::path folder_of(const std::filesystem::path& path);

// The extension with its dot, in lower case.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace restframe
