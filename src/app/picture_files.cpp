#include "app/picture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/provenance.h"
#include "app/render_picture.h"
#include "app/version.h"
#include "scene/error.h"
#include "scene/output_pattern.h"

namespace restframe {
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
                {"seed", std::to_string(scene.render.seed)}};
  for (auto& text : texts_of(provenance_of(scene))) info.texts.push_back(std::move(text));
  for (auto& text : cryptomatte_texts(scene)) info.texts.push_back(std::move(text));
  return info;
}

PictureInfo picture_info(PictureInfo common, const Scene& scene, int number) {
  common.number = number;
  common.camera_time = picture_time(scene.animation, number);
  common.pose = pose_at(scene.camera, common.camera_time);
  return common;
}

}  // namespace restframe
