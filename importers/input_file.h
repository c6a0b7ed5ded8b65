#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace restframe {

// Why `path` can not be read as a file ("no such file"), or nothing if it can. Only regular files
// can: a FIFO would hang, a device never end.
std::optional<std::string> input_file_fault(const std::filesystem::path& path);

// The whole file. Throws InputError where it can not be read or holds more than `limit` bytes.
std::string read_input_file(const std::filesystem::path& path, std::size_t limit);

// The extension with its dot, in lower case.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace restframe
