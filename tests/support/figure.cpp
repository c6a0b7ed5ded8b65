#include "support/figure.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "importers/importers.h"
#include "support/exposed_scene.h"
#include "support/temporary_folder.h"

namespace restframe {

namespace {

struct Span {
  std::size_t begin = std::string::npos, end = std::string::npos;
};

// The lines after the header of a table, up to the next header.
std::optional<Span> table_span(const std::string& text, const std::string& table) {
  const std::string header = fmt::format("\n[{}]\n", table);
  const std::size_t at = ("\n" + text).find(header);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t begin = at + header.size() - 1;
  const std::size_t next = text.find("\n[", begin - 1);
  return Span{begin, next == std::string::npos ? text.size() : next + 1};
}

// A key's line with its end, within a table.
std::optional<Span> key_span(const std::string& text, const Span& table, const std::string& key) {
  for (std::size_t line = table.begin; line < table.end;) {
    const std::size_t end = std::min(text.find('\n', line), text.size() - 1) + 1;
    const std::size_t after = line + key.size();
    if (text.compare(line, key.size(), key) == 0 && (text[after] == ' ' || text[after] == '=')) {
      return Span{line, end};
    }
    line = end;
  }
  return std::nullopt;
}

}  // namespace

std::string with_key(std::string text, const std::string& table, const std::string& key,
                     const std::string& value) {
  const std::string line = fmt::format("{} = {}\n", key, value);
  const std::optional<Span> place = table_span(text, table);
  if (!place) return fmt::format("{}\n[{}]\n{}", text, table, line);
  const std::optional<Span> old = key_span(text, *place, key);
  if (!old) return text.insert(place->begin, line);
  return text.replace(old->begin, old->end - old->begin, line);
}

std::string without_key(std::string text, const std::string& table, const std::string& key) {
  const std::optional<Span> place = table_span(text, table);
  const std::optional<Span> old = place ? key_span(text, *place, key) : std::nullopt;
  if (!old) throw std::runtime_error(fmt::format("no {} in [{}]", key, table));
  return text.erase(old->begin, old->end - old->begin);
}

std::string small(std::string text, int width, int height, const std::string& layers) {
  text = with_key(text, "render", "resolution", fmt::format("[{}, {}]", width, height));
  text = with_key(text, "render", "samples", "1");
  text = with_key(text, "output", "layers", layers);
  return with_key(text, "output", "preview", "false");
}

std::string exposures_apart(std::string text) {
  const ExposureSettings exposure = figure_scene(text).exposure;
  text = with_key(text, "exposure", "count", "1");
  text = with_key(text, "animation", "rate", fmt::format("{:.17g}", 1 / exposure.interval));
  return with_key(text, "animation", "pictures", fmt::format("{}", exposure.count));
}

Scene figure_scene(const std::string& text) {
  const TemporaryFolder folder;
  Warnings warnings;
  return load_scene(folder.write("scene.toml", text), {}, warnings);
}

std::vector<reference::MovingSphere> figure_spheres(const Scene& scene,
                                                    const std::vector<double>& radii) {
  std::vector<reference::MovingSphere> spheres;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Object& object = scene.objects.at(i);
    if (object.frame_clock) throw std::runtime_error(object.name + " has the frame's clock");
    const Event<in::World>& at = object.worldline.reference;
    spheres.push_back({object.worldline.velocity.gamma_beta(), at.x, at.t, object.clock, radii[i]});
  }
  return spheres;
}

reference::ObserverCamera figure_camera(const Scene& scene) {
  const CameraPose pose = pose_at(scene.camera, 0);
  reference::ObserverCamera camera;
  camera.position = pose.event.x;
  camera.time = pose.event.t;
  camera.right = pose.axes[0];
  camera.up = pose.axes[1];
  camera.back = pose.axes[2];
  camera.vertical_fov = pose.vertical_fov;
  camera.width = scene.render.width;
  camera.height = scene.render.height;
  return camera;
}

Vec3 seen_from(const reference::ObserverCamera& camera, const reference::MovingSphere& sphere,
               double time) {
  const Vec3 u = sphere.gamma_beta, v = u / std::sqrt(1 + glm::dot(u, u));
  const Vec3 now = sphere.center + v * (camera.time + time - sphere.time) - camera.position;
  return now - v * delay_of(now, v);
}

glm::dvec2 film_offset(const reference::ObserverCamera& camera, const Vec3& seen) {
  const double focal_length = 0.5 * camera.height / std::tan(0.5 * camera.vertical_fov);
  const double depth = -glm::dot(seen, camera.back);
  return focal_length / depth *
         glm::dvec2(glm::dot(seen, camera.right), -glm::dot(seen, camera.up));
}

namespace {

bool yellow(float red, float green, float blue) {
  return red > 0 && std::abs(red - green) < 0.02F * red && blue < 0.1F * red;
}

}  // namespace

Spot spot_of(const ExrPicture& picture, int id) {
  const std::vector<float>&ids = picture.channel("id_object.V"), &red = picture.channel("R"),
        &green = picture.channel("G"), &blue = picture.channel("B");
  Spot spot;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (std::lround(ids[i]) != id) continue;
    const int at = static_cast<int>(i);
    ++spot.pixels;
    spot.yellow += yellow(red[i], green[i], blue[i]);
    spot.x += at % picture.width + 0.5 - 0.5 * picture.width;
    spot.y += at / picture.width + 0.5 - 0.5 * picture.height;
  }
  if (spot.pixels > 0) spot.x /= spot.pixels, spot.y /= spot.pixels;
  return spot;
}

bool is_yellow(const ExrPicture& picture, int x, int y) {
  return yellow(picture.at("R", x, y), picture.at("G", x, y), picture.at("B", x, y));
}

}  // namespace restframe
