#pragma once

// The scenes of scenes/, as they are or a little changed, rendered by the program.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/exr_reader.h"
#include "support/long_vectors.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {

inline std::filesystem::path folder_of_scene(const std::string& name) {
  return std::filesystem::path(RESTFRAME_SOURCE_DIR) / "scenes" / name;
}

inline std::string scene_text(const std::string& name) {
  std::ifstream stream(folder_of_scene(name) / "scene.toml", std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// With every `from` replaced. Throws std::runtime_error if there is none: the scene has changed.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("not in the scene: " + from);
  for (; at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// What it takes to know what is seen where. `layers` of scenes/ are the default ones.
inline std::string with_places(const std::string& text) {
  return replaced(text, "[output]\n",
                  "[output]\npreview = false\nlayers = [\"beauty\", \"N\", \"P\", \"id\"]\n");
}

struct Shown {
  std::string size = "160x90";
  int samples = 1;
  int pictures = 1;  // from the first
};

// Pictures of a scene with this text in place of its own. Throws std::runtime_error with the
// program's words if it fails.
inline std::vector<ExrPicture> shown(const std::string& name, const std::string& text,
                                     const Shown& what = {}) {
  const TemporaryFolder folder;
  std::filesystem::copy(folder_of_scene(name), folder.path());
  const auto scene = folder.write("scene.toml", text);
  const auto pattern = folder.path() / "picture.####.exr";
  const RunResult result = run_program(
      RESTFRAME_PROGRAM, {"render", scene.string(), "--output", pattern.string(), "--size",
                          what.size, "--samples", std::to_string(what.samples), "--pictures",
                          fmt::format("0-{}", what.pictures - 1), "--quiet"});
  if (result.exit_code != 0) {
    throw std::runtime_error(fmt::format("exit code {}: {}", result.exit_code, result.error));
  }
  std::vector<ExrPicture> all;
  for (int i = 0; i < what.pictures; ++i) {
    all.push_back(read_exr(folder.path() / fmt::format("picture.{:04}.exr", i)));
  }
  return all;
}

// One sample of a picture of with_places().
struct ShownPixel {
  int object = 0;       // 1 for the scene's first
  reference::Long3 at;  // relative to the object's origin, in its rest frame, scene lengths
  reference::Long3 normal;
  Vec3 color{0};
};

inline ShownPixel pixel_at(const ExrPicture& picture, int x, int y) {
  const auto of = [&](const char* channel) {
    return static_cast<double>(picture.at(channel, x, y));
  };
  return {static_cast<int>(of("id_object.V")),
          {of("P.X"), of("P.Y"), of("P.Z")},
          {of("N.X"), of("N.Y"), of("N.Z")},
          {of("R"), of("G"), of("B")}};
}

// Those of a picture that hit an object.
inline std::vector<ShownPixel> pixels_of(const ExrPicture& picture, int object) {
  std::vector<ShownPixel> all;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const ShownPixel pixel = pixel_at(picture, x, y);
      if (pixel.object == object) all.push_back(pixel);
    }
  }
  return all;
}

// A lamp in uniform motion along x, by its world coordinates at world time `time`; there its clock
// shows `clock`. c = 1.
struct MovingLamp {
  reference::Long3 place;
  long double time = 0, clock = 0, beta = 0;
  long double gamma() const { return 1 / std::sqrt(1 - beta * beta); }
};

// When and where light left it that reaches an event, and which way as the lamp has it.
struct Emission {
  long double time = 0;     // of the world
  reference::Long3 place;   // in the world
  reference::Long3 onward;  // unit, in the lamp's rest frame
  long double clock = 0;
};

// In the lamp's rest frame the light left a distance ago; u is the world's time since the reference.
inline Emission emission_towards(const MovingLamp& lamp, const reference::Long4& event) {
  const reference::Long3 r = event.x - lamp.place;
  const long double t = event.t - lamp.time;
  const long double gamma = lamp.gamma();
  const reference::Long3 from_lamp{gamma * (r.x - lamp.beta * t), r.y, r.z};
  const long double distance = reference::length(from_lamp);
  const long double u = gamma * (gamma * (t - lamp.beta * r.x) - distance);
  Emission emission;
  emission.time = lamp.time + u;
  emission.place = lamp.place + reference::Long3{lamp.beta * u, 0, 0};
  emission.clock = lamp.clock + u / gamma;
  emission.onward = from_lamp / distance;
  return emission;
}

// The ramp of KHR_lights_punctual: 1 within `inner` radians, 0 beyond `outer`.
inline long double spot_ramp(long double cosine, long double inner, long double outer) {
  const long double within = (cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
  const long double clamped = std::min(1.0L, std::max(0.0L, within));
  return clamped * clamped;
}

// `v` turned about the y axis, counter-clockwise as seen from its tip.
inline reference::Long3 turned_about_y(const reference::Long3& v, long double angle) {
  const long double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

}  // namespace restframe
