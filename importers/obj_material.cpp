#include "importers/obj_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "importers/asset_file.h"
#include "importers/mtl_read.h"
#include "importers/obj_texture.h"
#include "importers/text_lines.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr float default_grey = 0.8F;

Material grey_material(const std::string& name) {
  Material result;
  result.name = name;
  result.base_color.value = Vec3f(default_grey);
  result.metallic.value = 0;
  result.double_sided = true;
  return result;
}

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

// Brings MTL's numbers into the ranges of Material.
class Converter {
 public:
  Converter(const MtlMaterial& source, Warnings& warnings) : source_(source), warnings_(warnings) {}

  Material convert() {
    const tinyobj::material_t& values = source_.values;
    Material result = grey_material(source_.name);
    if (given("map_Kd")) result.base_color.value = Vec3f(1);
    if (given("Kd")) result.base_color.value = color("Kd", values.diffuse, 1);
    if (given("Ke")) result.emission.value = color("Ke", values.emission, greatest_emission);
    if (given("d") || given("Tr")) {
      result.opacity.value = clamped(given("d") ? "d" : "Tr", values.dissolve, 1);
    }
    if (result.opacity.value < 1) result.alpha_mode = AlphaMode::blend;
    // Phong's exponent as the width of a microfacet lobe.
    if (given("Ns")) {
      result.roughness.value =
          std::sqrt(2 / (clamped("Ns", values.shininess, greatest_exponent) + 2));
    }
    if (given("Ni")) result.ior.value = clamped("Ni", values.ior, greatest_ior, 1);
    if (given("Pr")) result.roughness.value = clamped("Pr", values.roughness, 1);
    if (given("Pm")) result.metallic.value = clamped("Pm", values.metallic, 1);
    return result;
  }

 private:
  static constexpr float greatest_exponent = 1e9F, greatest_emission = 1e15F, greatest_ior = 1e15F;

  bool given(const char* key) const { return source_.given.count(key) > 0; }

  float clamped(const char* key, float value, float greatest, float least = 0) {
    if (value >= least && value <= greatest) return value;
    warnings_.push_back(fmt::format("{}: material {}: {} is {}, brought into {} to {}",
                                    source_.file.string(), quote(source_.name), key, value, least,
                                    greatest));
    return value > greatest ? greatest : least;
  }

  Vec3f color(const char* key, const tinyobj::real_t (&rgb)[3], float greatest) {
    Vec3f result;
    for (int i = 0; i < 3; ++i) result[i] = clamped(key, rgb[i], greatest);
    return result;
  }

  const MtlMaterial& source_;
  Warnings& warnings_;
};

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
      asset.materials.push_back(Converter(*known->second, warnings).convert());
      textures.apply(*known->second, asset.materials.back());
    }
  }
  warn_of_unknown(unknown, path, warnings);
  const bool some_without = std::any_of(data.runs.begin(), data.runs.end(),
                                        [](const ObjRun& run) { return run.material < 0; });
  slots.push_back(some_without ? static_cast<int>(asset.materials.size()) : -1);
  if (some_without) asset.materials.push_back(grey_material("default"));
  return slots;
}

}  // namespace restframe
