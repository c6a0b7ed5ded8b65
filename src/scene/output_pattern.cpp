#include "scene/output_pattern.h"

namespace restframe {
namespace {

int runs_of_hashes(const std::string& path) {
  int runs = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] == '#' && (i == 0 || path[i - 1] != '#')) ++runs;
  }
  return runs;
}

bool names_an_exr(const std::string& path) {
  const std::size_t name = path.find_last_of('/') + 1;  // 0 where there is no folder
  return path.size() > name + 4 && path.ends_with(".exr");
}

}  // namespace

std::optional<std::string> output_pattern_fault(const std::string& path, int pictures) {
  const std::string shown = "path is \"" + path + "\", must ";
  const int runs = runs_of_hashes(path);
  if (path.find('\0') != std::string::npos) return "path holds a NUL character";
  if (!names_an_exr(path)) return shown + "name a file that ends in .exr";
  if (runs > 1) return shown + "have one run of #, for the picture's number";
  if (runs == 0 && pictures > 1) {
    return shown + "have a run of #, for the numbers of " + std::to_string(pictures) + " pictures";
  }
  return std::nullopt;
}

}  // namespace restframe
