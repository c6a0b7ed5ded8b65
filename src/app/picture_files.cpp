#include "app/picture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/render_picture.h"
#include "app/version.h"
#include "scene/canonical.h"
#include "scene/error.h"
#include "scene/output_pattern.h"

namespace restframe {
namespace {

constexpr const char* settings_attribute = "restframeSettings";
constexpr const char* sources_attribute = "restframeSources";

std::string sources_text(const Scene& scene) {
  std::string text;
  for (const SourceFile& source : scene.sources) {
    text += fmt::format("{} {}\n", source.hash, source.name);
  }
  return text;
}

// The first line in which the two texts differ, as it is now.
std::string first_difference(const std::string& before, const std::string& now) {
  std::istringstream old_lines(before);
  std::istringstream new_lines(now);
  std::string old_line;
  std::string new_line;
  while (true) {
    const bool has_old = static_cast<bool>(std::getline(old_lines, old_line));
    const bool has_new = static_cast<bool>(std::getline(new_lines, new_line));
    if (!has_old && !has_new) return {};
    if (!has_old) return "now also " + new_line;
    if (!has_new) return "no longer " + old_line;
    if (old_line != new_line) return fmt::format("was {}, is {}", old_line, new_line);
  }
}

ExistingPicture compare_with(const std::filesystem::path& path, const std::string& settings,
                             const std::string& sources) {
  const std::string old_settings = exr_text(path, settings_attribute);
  if (old_settings.empty()) return {};
  std::string difference = first_difference(old_settings, settings);
  if (difference.empty()) difference = first_difference(exr_text(path, sources_attribute), sources);
  if (difference.empty()) return {Found::the_same, {}, {}};
  return {Found::another, difference, path};
}

// Of all files of a picture.
ExistingPicture compare_with(const PictureFiles& files, const std::string& settings,
                             const std::string& sources) {
  ExistingPicture whole{Found::the_same, {}, {}};
  for (const LayerFile& image : files.images) {
    ExistingPicture existing = compare_with(image.path, settings, sources);
    existing.path = image.path;
    if (existing.found == Found::another) return existing;
    if (existing.found == Found::nothing_of_use) whole = existing;
  }
  return whole;
}

bool is_separator(char c) {
  return c == '.' || c == '_' || c == '-';
}

}  // namespace

std::string layer_pattern(const std::string& pattern, const std::string& layer) {
  const std::size_t name = pattern.find_last_of('/') + 1;  // 0 where there is no folder
  const std::size_t number = pattern.find('#', name);
  if (number == std::string::npos) {
    const std::size_t extension = pattern.size() - std::string(".exr").size();
    return pattern.substr(0, extension) + "." + layer + pattern.substr(extension);
  }
  const bool separated = number > name && is_separator(pattern[number - 1]);
  const std::string separator(1, separated ? pattern[number - 1] : '.');
  const bool leads = number > name && !separated;
  return pattern.substr(0, number) + (leads ? separator : "") + layer + separator +
         pattern.substr(number);
}

PictureFiles picture_files(const Scene& scene, int number, bool single) {
  const std::string& pattern = scene.output.path;
  PictureFiles files;
  const std::filesystem::path whole = picture_path(pattern, number, single);
  files.preview = std::filesystem::path(whole).replace_extension(".png");
  if (!scene.output.split) {
    files.images = {{"", whole}};
    return files;
  }
  for (const std::string& layer : layer_names(scene.output.layers)) {
    files.images.push_back({layer, picture_path(layer_pattern(pattern, layer), number, single)});
  }
  return files;
}

std::filesystem::path picture_path(const std::string& pattern, int number, bool single) {
  if (const auto fault = output_pattern_fault(pattern, single ? 1 : 2)) {
    throw InputError("output: " + *fault);
  }
  const std::size_t first = pattern.find('#');
  if (first == std::string::npos) return pattern;
  const std::size_t after = std::min(pattern.find_first_not_of('#', first), pattern.size());
  return pattern.substr(0, first) + fmt::format("{:0{}}", number, after - first) +
         pattern.substr(after);
}

std::string file_content(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream || content.view().empty()) {
    throw InputError(path.string() + ": can not be read, or is empty");
  }
  return std::move(content).str();
}

std::vector<int> pictures_to_make(const Scene& scene, int first, int last, bool overwrite) {
  const std::string settings = canonical_settings(scene);
  const std::string sources = sources_text(scene);
  std::vector<int> numbers;
  for (int number = first; number <= last; ++number) {
    const PictureFiles files = picture_files(scene, number, first == last);
    const ExistingPicture existing =
        overwrite ? ExistingPicture{} : compare_with(files, settings, sources);
    if (existing.found == Found::another) {
      throw InputError(fmt::format("{}: was made from another scene ({}); --overwrite replaces it",
                                   existing.path.string(), existing.difference));
    }
    if (existing.found == Found::nothing_of_use) numbers.push_back(number);
  }
  return numbers;
}

std::vector<ExistingPicture> existing_pictures(const Scene& scene, int first, int last) {
  const std::string settings = canonical_settings(scene);
  const std::string sources = sources_text(scene);
  std::vector<ExistingPicture> pictures;
  for (int number = first; number <= last; ++number) {
    pictures.push_back(
        compare_with(picture_files(scene, number, first == last), settings, sources));
  }
  return pictures;
}

PictureInfo common_info(const Scene& scene) {
  PictureInfo info;
  const OutputSettings& output = scene.output;
  info.display = display_window(scene.render);
  if (scene.render.crop) info.uncropped = whole_window(scene.render);
  info.light_speed = scene.light_speed;
  info.rate = scene.animation.rate;
  info.shutter = scene.exposure.shutter;
  if (scene.camera.aperture > 0) info.focus = scene.camera.focus;
  info.float_beauty = has_layer(output.float_layers, Layer::beauty) ||
                      (scene.render.beaming && !has_layer(output.half_layers, Layer::beauty));
  info.half_layers = layer_names(output.half_layers);
  info.compression = output.compression;
  info.compression_level = output.compression_level;
  for (const Object& object : scene.objects) info.object_names.push_back(object.name);
  for (const Material& material : scene.materials) info.material_names.push_back(material.name);
  info.texts = {{"software", std::string("restframe ") + program_version},
                {"samples", std::to_string(scene.render.samples)},
                {"seed", std::to_string(scene.render.seed)},
                {settings_attribute, canonical_settings(scene)},
                {sources_attribute, sources_text(scene)}};
  for (auto& text : cryptomatte_texts(scene)) info.texts.push_back(std::move(text));
  return info;
}

PictureInfo picture_info(PictureInfo common, const Scene& scene, int number) {
  common.number = number;
  common.camera_time = picture_time(scene.animation, number);
  common.pose = pose_at(scene.camera, common.camera_time);
  if (!scene.camera.stereo) return common;
  for (const auto& [eye, name] : {std::pair{Eye::left, "left"}, std::pair{Eye::right, "right"}}) {
    common.views.push_back({name, pose_at(scene.camera, common.camera_time, eye)});
  }
  return common;
}

}  // namespace restframe
