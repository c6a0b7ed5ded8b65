#include "importers/referred_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "importers/input_file.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// Whether `name` is a regular file in the asset's folder or below.
bool is_inside(const fs::path& asset, const std::string& name) {
  const fs::path relative = fs::path(name).lexically_normal();
  if (name.empty() || relative.is_absolute() || *relative.begin() == "..") return false;
  return !input_file_fault(asset.parent_path() / relative);
}

int hex_digit(char c) {
  const std::string digits = "0123456789abcdef";
  const std::size_t at =
      digits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  return at == std::string::npos ? -1 : static_cast<int>(at);
}

std::string percent_decoded(const std::string& uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                        hex_digit(uri[i + 2]) >= 0;
    decoded +=
        escape ? static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return decoded;
}

Names names_in_gltf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const nlohmann::json gltf = nlohmann::json::parse(in, nullptr, false);
  Names names;
  if (!gltf.is_object()) return names;
  for (const char* list : {"buffers", "images"}) {
    const auto elements = gltf.find(list);
    if (elements == gltf.end() || !elements->is_array()) continue;
    for (const auto& element : *elements) {
      const auto uri = element.is_object() ? element.find("uri") : element.end();
      if (!element.is_object() || uri == element.end() || !uri->is_string()) continue;
      const std::string text = uri->get<std::string>();
      if (!text.starts_with("data:")) names.push_back(percent_decoded(text));
    }
  }
  return names;
}

// The rest of every line whose first word begins with `start`; of a texture's line, whose options
// come first, the last word.
Names names_after(const fs::path& path, const std::string& start, bool last_word) {
  std::ifstream in(path, std::ios::binary);
  Names names;
  for (std::string line; std::getline(in, line);) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    if (line.compare(begin, start.size(), start) != 0) continue;
    std::istringstream words(line);
    std::string word, rest;
    words >> word;
    while (words >> word) rest = last_word || rest.empty() ? word : rest + " " + word;
    std::replace(rest.begin(), rest.end(), '\\', '/');
    names.push_back(rest);
  }
  return names;
}

Names names_in_obj(const fs::path& path) {
  Names names = names_after(path, "mtllib", false);
  const Names libraries = names;
  for (const std::string& library : libraries) {
    if (!is_inside(path, library)) continue;
    const fs::path file = path.parent_path() / library;
    const Names textures = names_after(file, "map_", true);
    names.insert(names.end(), textures.begin(), textures.end());
  }
  return names;
}

}  // namespace

std::vector<std::string> referred_files(const fs::path& asset) {
  const std::string extension = lower_extension(asset);
  Names names;
  if (extension == ".gltf") names = names_in_gltf(asset);
  if (extension == ".obj") names = names_in_obj(asset);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const auto is_outside = [&](const std::string& name) { return !is_inside(asset, name); };
  names.erase(std::remove_if(names.begin(), names.end(), is_outside), names.end());
  return names;
}

}  // namespace restframe
