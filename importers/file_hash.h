#pragma once

#include <filesystem>
#include <string>

namespace restframe {

// XXH3 of 128 bits, in 32 hexadecimal digits, of the file's bytes. Throws InputError if it can not
// be read.
std::string file_hash(const std::filesystem::path& path);

}  // namespace restframe
