#include "importers/obj_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "importers/asset_file.h"
#include "importers/mtl_material.h"
#include "importers/mtl_read.h"
#include "importers/obj_texture.h"
#include "importers/text_lines.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {
namespace {

std::optional<Path> find_library(const Path& folder, const ObjLibrary& library,
                                 const std::string& name) {
  return find_asset_file(folder, folder, name, library.at + ": " + quote(name));
}

// The names of an mtllib statement: the whole is one file if there is such a file, else spaces
// divide, but for those after a backslash.
std::vector<std::string> library_names(const ObjLibrary& library, const Path& folder) {
  if (find_library(folder, library, library.names)) return {library.names};
  std::vector<std::string> result;
  std::string_view rest = library.names;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    const bool escaped = !result.empty() && result.back().back() == '\\';
    if (escaped) {
      result.back().back() = ' ';
      result.back() += word;
    } else {
      result.emplace_back(word);
    }
  }
  return result;
}

std::vector<MtlMaterial> read_libraries(const ObjData& data, const Path& path,
                                        const ImportLimits& limits, std::set<Path>& read,
                                        Warnings& warnings) {
  const Path folder = folder_of(path);
  std::vector<MtlMaterial> result;
  std::set<std::string> missing;
  for (const ObjLibrary& library : data.libraries) {
    for (const std::string& name : library_names(library, folder)) {
      const std::optional<Path> file = find_library(folder, library, name);
      if (file) {
        if (read.insert(*file).second) read_mtl(*file, limits, result, warnings);
      } else if (missing.insert(name).second) {
        warnings.push_back(
            fmt::format("{}: material file {} does not exist", library.at, quote(name)));
      }
    }
  }
  return result;
}

void warn_of_unknown(const std::vector<std::string>& names, const Path& path, Warnings& warnings) {
  constexpr std::size_t most = 8;
  if (names.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    list += (i == 0 ? "" : ", ") + quote(names[i]);
  }
  if (names.size() > most) list += fmt::format(" and {} more", names.size() - most);
  warnings.push_back(
      fmt::format("{}: materials that no MTL file has are grey: {}", path.string(), list));
}

}  // namespace

std::vector<int> add_obj_materials(const ObjData& data, const Path& path,
                                   const ImportLimits& limits, Asset& asset, Warnings& warnings) {
  const std::vector<MtlMaterial> sources =
      read_libraries(data, path, limits, asset.files, warnings);
  std::map<std::string, const MtlMaterial*> by_name;
  for (const MtlMaterial& source : sources) {
    if (by_name.emplace(source.name, &source).second) continue;
    warnings.push_back(fmt::format("{}: material {} is defined again, the first holds",
                                   source.file.string(), quote(source.name)));
  }

  ObjTextures textures(folder_of(path), limits, asset, warnings);
  std::vector<int> slots;
  std::vector<std::string> unknown;
  for (const std::string& name : data.materials) {
    slots.push_back(static_cast<int>(asset.materials.size()));
    const auto known = by_name.find(name);
    if (known == by_name.end()) {
      unknown.push_back(name);
      asset.materials.push_back(grey_material(name));
    } else {
      asset.materials.push_back(material_from_mtl(*known->second, warnings));
      textures.apply(*known->second, asset.materials.back());
    }
  }
  warn_of_unknown(unknown, path, warnings);
  const bool some_without = std::any_of(data.runs.begin(), data.runs.end(),
                                        [](const ObjRun& run) { return run.material < 0; });
  slots.push_back(some_without ? static_cast<int>(asset.materials.size()) : -1);
  if (!some_without) return slots;
  asset.materials.push_back(grey_material("default"));
  if (!data.colors.empty()) asset.materials.back().base_color.value = Vec3f(1);  // theirs alone
  return slots;
}

}  // namespace restframe
