#pragma once

// Small scenes for the path integrator, with flat assets that tests write themselves.

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/exr_reader.h"
#include "support/long_vectors.h"
#include "support/observer_camera.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {

struct AssetFile {
  std::string name, content;
};

inline std::string toml(const Vec3& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x, v.y, v.z);
}

// The object of NAME.obj.
inline std::string placed(const std::string& asset, const std::string& material,
                          const std::string& more = "") {
  return fmt::format("[[object]]\nname = \"{0}\"\nasset = \"{0}.obj\"\nmaterial = \"{1}\"\n{2}\n",
                     asset, material, more);
}

// An OBJ of polygons, their corners counter-clockwise as seen from the front.
inline std::string polygons_obj(const std::vector<Vec3>& corners,
                                const std::vector<std::vector<int>>& faces) {
  std::string text;
  for (const Vec3& c : corners) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", c.x, c.y, c.z);
  for (const std::vector<int>& face : faces) {
    text += "f";
    for (const int corner : face) text += fmt::format(" {}", corner + 1);
    text += "\n";
  }
  return text;
}

// A parallelogram that faces along u x v.
inline std::string quad_obj(const Vec3& center, const Vec3& u, const Vec3& v) {
  return polygons_obj({center - u - v, center + u - v, center + u + v, center - u + v},
                      {{0, 1, 2, 3}});
}

// A closed prism over a polygon of (x, z) corners that runs clockwise as seen from +y.
inline std::string prism_obj(const std::vector<Vec3>& outline, double lower_y, double upper_y) {
  std::vector<Vec3> corners;
  std::vector<std::vector<int>> faces(2);
  const int n = static_cast<int>(outline.size());
  for (const double y : {lower_y, upper_y}) {
    for (const Vec3& c : outline) corners.emplace_back(c.x, y, c.z);
  }
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    faces[0].push_back(i);              // below
    faces[1].push_back(n + n - 1 - i);  // above
    faces.push_back({next, i, n + i, n + next});
  }
  return polygons_obj(corners, faces);
}

inline std::string box_obj(const Vec3& lower, const Vec3& upper) {
  return prism_obj(
      {{lower.x, 0, lower.z}, {upper.x, 0, lower.z}, {upper.x, 0, upper.z}, {lower.x, 0, upper.z}},
      lower.y, upper.y);
}

// What the program does with a scene file that uses these assets; pictures lie beside it.
struct PathRender {
  std::unique_ptr<TemporaryFolder> folder = std::make_unique<TemporaryFolder>();
  RunResult result;

  ExrPicture picture(int index = 0) const {
    return read_exr(folder->path() / fmt::format("picture.{:04}.exr", index));
  }
};

inline PathRender run_path(const std::string& scene_file, const std::vector<AssetFile>& assets,
                           const std::vector<std::string>& options = {}) {
  PathRender render;
  for (const AssetFile& asset : assets) render.folder->write(asset.name, asset.content);
  const auto scene = render.folder->write("scene.toml", scene_file);
  std::vector<std::string> arguments = {"render", scene.string(), "--output",
                                        (render.folder->path() / "picture.####.exr").string(),
                                        "--quiet"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  render.result = run_program(RESTFRAME_PROGRAM, arguments, {.timeout = std::chrono::seconds(60)});
  return render;
}

// Throws std::runtime_error with the program's words if it fails.
inline std::vector<ExrPicture> path_pictures(const std::string& scene_file,
                                             const std::vector<AssetFile>& assets,
                                             int pictures = 1) {
  const PathRender render = run_path(scene_file, assets);
  if (render.result.exit_code != 0) {
    throw std::runtime_error(
        fmt::format("exit code {}: {}", render.result.exit_code, render.result.error));
  }
  std::vector<ExrPicture> all;
  for (int i = 0; i < pictures; ++i) all.push_back(render.picture(i));
  return all;
}

// [camera] and [render] of the reference's camera.
inline std::string camera_text(const reference::ObserverCamera& camera,
                               const std::string& render_keys) {
  const double gamma = std::hypot(1.0, glm::length(camera.gamma_beta));
  return fmt::format(
      "[camera]\nposition = {}\ntime = {:.17g}\nvelocity = {}\ndirection = {}\nup = {}\nfov = "
      "{:.17g}\n[render]\nresolution = [{}, {}]\nintegrator = \"path\"\n{}\n[output]\nlayers = "
      "[\"beauty\", \"id\"]\npreview = false\n",
      toml(camera.position), camera.time, toml(camera.gamma_beta / gamma), toml(-camera.back),
      toml(camera.up), camera.vertical_fov * 57.295779513082320877, camera.width, camera.height,
      render_keys);
}

// Lambert's diffuser: without gloss, since its index of refraction is that of the vacuum.
inline std::string diffuse_material(const std::string& name, double grey = 1) {
  return fmt::format(
      "[[material]]\nname = \"{0}\"\nbase_color = [{1}, {1}, {1}]\nmetallic = 0\nroughness = 1\n"
      "ior = 1\n",
      name, grey);
}

}  // namespace restframe
