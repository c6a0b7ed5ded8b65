#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace restframe {

// Empty where there is no such file.
inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace restframe
