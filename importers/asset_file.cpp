#include "importers/asset_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "scene/error.h"

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

// Nothing if there is no such file.
std::optional<fs::path> find_one(const fs::path& root, const fs::path& from,
                                 const std::string& name, const std::string& at) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(from) / name, error);
  if (error == std::errc::filename_too_long) return std::nullopt;
  if (error) throw InputError(fmt::format("{}: {}: {}", at, quote(name), error.message()));
  if (!lies_within(canonical, fs::canonical(root))) {
    throw InputError(fmt::format("{}: {} leads out of the asset's folder; move the file there", at,
                                 quote(name)));
  }
  const fs::file_status status = fs::status(canonical, error);
  if (!fs::exists(status)) return std::nullopt;
  if (!fs::is_regular_file(status)) {
    throw InputError(fmt::format("{}: {} is not a regular file", at, quote(name)));
  }
  return canonical;
}

}  // namespace

std::string quote(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) {
    result += std::iscntrl(static_cast<unsigned char>(c)) ? '?' : c;
  }
  return result + (text.size() > longest ? "...\"" : "\"");
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

std::string read_regular_file(const fs::path& path, std::size_t limit, const std::string& at) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw InputError(
        fmt::format("{}: can not be opened: {}", at, error ? error.message() : "no such file"));
  }
  if (!fs::is_regular_file(status)) throw InputError(at + ": is not a regular file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > limit) {
    throw InputError(fmt::format("{}: has {} bytes, at most {} are allowed", at, size, limit));
  }
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) throw InputError(at + ": can not be opened: check its permissions");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size) {
    throw InputError(at + ": can not be read to its end");
  }
  return bytes;
}

std::optional<fs::path> find_asset_file(const fs::path& root, const fs::path& from,
                                        const std::string& name, const std::string& at) {
  if (is_absolute_somewhere(name)) {
    throw InputError(fmt::format(
        "{}: {} is an absolute path; write one relative to the asset's folder", at, quote(name)));
  }
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  std::optional<fs::path> found = find_one(root, from, name, at);
  return found || slashed == name ? found : find_one(root, from, slashed, at);
}

}  // namespace restframe
