#pragma once

// The files that make up an asset: the one that the user names, and those that it names in turn,
// which must lie in the same folder or below.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace restframe {

// A user's text for an error message: in quotes, short, on one line, control characters as '?'.
std::string quote(std::string_view text);

// All bytes of `path`. Throws InputError, `at` before the reason, if it is not a regular file that
// can be read, or is larger than `limit` bytes.
std::string read_regular_file(const std::filesystem::path& path, std::size_t limit,
                              const std::string& at);

// Where `name`, as written in a file that lies in `from`, leads to; nothing if there is no such
// file. Backslashes of Windows exporters may stand for slashes. Throws InputError, `at` before the
// reason, if it leads out of `root` (by .., an absolute path, a drive letter, a symbolic link) or
// is no regular file.
std::optional<std::filesystem::path> find_asset_file(const std::filesystem::path& root,
                                                     const std::filesystem::path& from,
                                                     const std::string& name,
                                                     const std::string& at);

// The folder of `path`, "." if it names none.
std::filesystem::path folder_of(const std::filesystem::path& path);

}  // namespace restframe
