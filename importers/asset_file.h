#pragma once

// The files that an asset's files name in turn; they must lie in the asset's folder or below.

#include <filesystem>
#include <optional>
#include <string>

namespace restframe {

// The file that `name`, as written in a file that lies in `from`, leads to, symbolic links
// resolved; nothing if there is no such file. Backslashes of Windows exporters may stand for
// slashes. Throws InputError if it leads out of `root` (by .., an absolute path, a drive letter, a
// symbolic link) or is no regular file; `what` (the place and the name) is put before the reason.
std::optional<std::filesystem::path> find_asset_file(const std::filesystem::path& root,
                                                     const std::filesystem::path& from,
                                                     const std::string& name,
                                                     const std::string& what);

}  // namespace restframe
