#include "app/picture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/provenance.h"
#include "app/render_picture.h"
#include "scene/error.h"
#include "scene/output_pattern.h"

namespace restframe {
namespace {

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
  files.whole = picture_path(pattern, number, single);
  files.preview = std::filesystem::path(files.whole).replace_extension(".png");
  if (!scene.output.split) {
    files.images = {{"", files.whole}};
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
  info.texts = {{"samples", std::to_string(scene.render.samples)},
                {"seed", std::to_string(scene.render.seed)}};
  for (auto& text : texts_of(provenance_of(scene))) info.texts.push_back(std::move(text));
  for (auto& text : cryptomatte_texts(scene)) info.texts.push_back(std::move(text));
  return info;
}

PictureInfo picture_info(PictureInfo common, const Scene& scene, int number) {
  common.number = number;
  common.camera_time = picture_time(scene.animation, number);
  common.pose = pose_at(scene.camera, common.camera_time);
  if (!scene.camera.stereo) return common;
  for (const Eye eye : eyes_of(scene.camera)) {
    common.views.push_back({eye_name(eye), pose_at(scene.camera, common.camera_time, eye)});
  }
  return common;
}

}  // namespace restframe
