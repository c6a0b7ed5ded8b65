#include "support/sphere_scene.h"

#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "scene/generators.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

std::string text_of(const Vec3& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x, v.y, v.z);
}

// Slow ones as fractions of c, fast ones by gamma: each where its digits are.
std::string motion(const Vec3& gamma_beta) {
  const double gamma = std::hypot(1.0, glm::length(gamma_beta));
  if (gamma < 2) return fmt::format("velocity = {}\n", text_of(gamma_beta / gamma));
  return fmt::format("gamma = {:.17g}\ndirection = {}\n", gamma, text_of(gamma_beta));
}

std::string camera_table(const SphereScene& scene) {
  const reference::ObserverCamera& camera = scene.camera;
  const double gamma = std::hypot(1.0, glm::length(camera.gamma_beta));
  return fmt::format(
      "[camera]\nposition = {}\ntime = {:.17g}\nvelocity = {}\ndirection = {}\nup = {}\nfov = "
      "{:.17g}\n",
      text_of(camera.position * scene.light_speed), camera.time, text_of(camera.gamma_beta / gamma),
      text_of(-camera.back), text_of(camera.up), camera.vertical_fov * 180 / std::numbers::pi);
}

std::string object_table(const SphereScene& scene, std::size_t i) {
  const reference::MovingSphere& sphere = scene.spheres[i];
  return fmt::format(
      "[[object]]\nname = \"sphere_{}\"\nsphere = {{radius = {:.17g}, fineness = {}}}\nposition = "
      "{}\ntime = {:.17g}\nclock = {:.17g}\n{}",
      i + 1, sphere.radius * scene.light_speed, scene.fineness,
      text_of(sphere.center * scene.light_speed), sphere.time, sphere.clock,
      motion(sphere.gamma_beta));
}

}  // namespace

std::string scene_file(const SphereScene& scene) {
  std::string text = fmt::format(
      "[scene]\nlight_speed = {:.17g}\n[animation]\nstart = {:.17g}\n"
      "[render]\nresolution = [{}, {}]\nsamples = {}\n{}\n[output]\nlayers = {}\npreview = false\n",
      scene.light_speed, scene.start, scene.camera.width, scene.camera.height, scene.samples,
      scene.render, scene.layers);
  text += camera_table(scene);
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) text += object_table(scene, i);
  return text + scene.more;
}

ExrPicture rendered(const std::filesystem::path& program, const std::string& scene_file) {
  const TemporaryFolder folder;
  const auto scene = folder.write("scene.toml", scene_file);
  const auto picture = folder.path() / "picture.exr";
  const RunResult result =
      run_program(program, {"render", scene.string(), "--output", picture.string(), "--quiet"});
  if (result.exit_code != 0) {
    throw std::runtime_error(fmt::format("exit code {}: {}", result.exit_code, result.error));
  }
  return read_exr(picture);
}

// The plane of a facet is nowhere nearer to the centre than the facet's nearest point.
double facets_error(int fineness) {
  const Mesh ball = make_ball({1.0, fineness});
  double nearest = 1;
  for (const Triangle& t : ball.triangles) {
    const Vec3 a(ball.positions[t[0]]), b(ball.positions[t[1]]), c(ball.positions[t[2]]);
    nearest = std::min(nearest, std::abs(glm::dot(a, glm::normalize(glm::cross(b - a, c - a)))));
  }
  return 1 - nearest;
}

std::vector<reference::MovingSphere> inscribed(std::vector<reference::MovingSphere> spheres,
                                               int fineness) {
  const double factor = 1 - facets_error(fineness);
  for (reference::MovingSphere& sphere : spheres) sphere.radius *= factor;
  return spheres;
}

void place_in_sight(reference::MovingSphere& sphere, const reference::ObserverCamera& camera,
                    double proper_time, const Vec3& direction, double distance) {
  const reference::Long4 event = reference::camera_event(camera, proper_time);
  const reference::WorldSight sight =
      reference::world_sight(camera, reference::widened(glm::normalize(direction)));
  sphere.center = reference::narrowed(event.x + distance * sight.direction);
  sphere.time = static_cast<double>(event.t - distance);
}

}  // namespace restframe
