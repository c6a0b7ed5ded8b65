#include "importers/input_file.h"

#include <fmt/format.h>

#include <cctype>
#include <fstream>

#include "scene/error.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::optional<std::string> input_file_fault(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return "no such file";
  if (status.type() == fs::file_type::directory) return "is a folder, must be a file";
  if (status.type() == fs::file_type::none) return "can not be read: " + error.message();
  if (status.type() != fs::file_type::regular) return "is not a regular file";
  if (!std::ifstream(path, std::ios::binary)) return "can not be read, see its permissions";
  return std::nullopt;
}

std::string read_input_file(const fs::path& path, std::size_t limit) {
  if (const auto fault = input_file_fault(path)) {
    throw InputError(fmt::format("{}: {}", path.string(), *fault));
  }
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > limit) {
    throw InputError(
        fmt::format("{}: the file has {} bytes, must have at most {}", path.string(), size, limit));
  }
  std::string text(error ? 0 : static_cast<std::size_t>(size), '\0');
  std::ifstream in(path, std::ios::binary);
  if (error || !in.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    throw InputError(path.string() + ": can not be read");
  }
  return text;
}

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace restframe
