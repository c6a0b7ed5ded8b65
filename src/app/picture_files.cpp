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
  if (difference.empty()) return {Found::the_same, {}};
  return {Found::another, difference};
}

}  // namespace

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
    const auto path = picture_path(scene.output.path, number, first == last);
    const ExistingPicture existing =
        overwrite ? ExistingPicture{} : compare_with(path, settings, sources);
    if (existing.found == Found::another) {
      throw InputError(fmt::format("{}: was made from another scene ({}); --overwrite replaces it",
                                   path.string(), existing.difference));
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
    const auto path = picture_path(scene.output.path, number, first == last);
    pictures.push_back(compare_with(path, settings, sources));
  }
  return pictures;
}

PictureInfo common_info(const Scene& scene) {
  PictureInfo info;
  info.display = {0, 0, scene.render.width, scene.render.height};
  info.light_speed = scene.light_speed;
  info.rate = scene.animation.rate;
  info.float_beauty = scene.render.beaming;
  info.compression = scene.output.compression;
  for (const Object& object : scene.objects) info.object_names.push_back(object.name);
  for (const Material& material : scene.materials) info.material_names.push_back(material.name);
  info.texts = {{"software", std::string("restframe ") + program_version},
                {"samples", std::to_string(scene.render.samples)},
                {"seed", std::to_string(scene.render.seed)},
                {settings_attribute, canonical_settings(scene)},
                {sources_attribute, sources_text(scene)}};
  return info;
}

PictureInfo picture_info(PictureInfo common, const Scene& scene, int number) {
  common.number = number;
  common.camera_time = picture_time(scene.animation, number);
  common.pose = pose_at(scene.camera, common.camera_time);
  return common;
}

}  // namespace restframe
