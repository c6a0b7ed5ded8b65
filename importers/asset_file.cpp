#include "importers/asset_file.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

bool is_absolute_somewhere(const std::string& name) {
  const bool drive =
      name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0]));
  return drive || (!name.empty() && (name[0] == '/' || name[0] == '\\'));
}

// Both are canonical.
bool lies_within(const fs::path& path, const fs::path& folder) {
  const auto mismatch = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return mismatch.first == folder.end();
}

[[noreturn]] void fail(const std::string& what, const std::string& reason) {
  throw InputError(on_one_line(what + reason));
}

std::optional<fs::path> find_one(const fs::path& root, const fs::path& from,
                                 const std::string& name, const std::string& what) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(from) / name, error);
  if (error == std::errc::filename_too_long) return std::nullopt;
  if (error) fail(what, ": " + error.message());
  if (!lies_within(canonical, fs::canonical(root))) {
    fail(what, " leads out of the asset's folder; move the file there");
  }
  const fs::file_status status = fs::status(canonical, error);
  if (!fs::exists(status)) return std::nullopt;
  if (!fs::is_regular_file(status)) fail(what, " is not a regular file");
  return canonical;
}

}  // namespace

std::optional<fs::path> find_asset_file(const fs::path& root, const fs::path& from,
                                        const std::string& name, const std::string& what) {
  if (is_absolute_somewhere(name)) {
    fail(what, " is an absolute path; write one relative to the asset's folder");
  }
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  std::optional<fs::path> found = find_one(root, from, name, what);
  return found || slashed == name ? found : find_one(root, from, slashed, what);
}

}  // namespace restframe
