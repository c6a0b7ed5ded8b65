#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "scene/error.h"
#include "scene/output_pattern.h"
#include "scene/validate_data.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

// Light-seconds and seconds beyond which squares and products could overflow.
constexpr double farthest = 1e100;

bool is_near(const Event<in::World>& e) {
  return std::abs(e.t) <= farthest && std::abs(e.x.x) <= farthest && std::abs(e.x.y) <= farthest &&
         std::abs(e.x.z) <= farthest;  // false for NaN
}

void check_positive(double value, const char* what, Faults& faults) {
  if (value > 0 && std::isfinite(value)) return;
  faults.push_back(fmt::format("{} is {}, must be above 0 and finite", what, value));
}

void check_count(int value, int low, int high, const char* what, Faults& faults) {
  if (value >= low && value <= high) return;
  faults.push_back(fmt::format("{} is {}, must be from {} to {}", what, value, low, high));
}

void check_worldline(const Worldline& worldline, const std::string& name, Faults& faults) {
  if (!is_near(worldline.reference)) {
    faults.push_back(name + ": position and time must be finite and within 1e100 light-seconds");
  }
  if (!is_finite(worldline.velocity.gamma_beta()) || !std::isfinite(worldline.velocity.gamma())) {
    faults.push_back(name + ": |velocity| must be below 1");
  }
}

void check_camera(const Camera& camera, Faults& faults) {
  check_worldline(camera.worldline, "camera", faults);
  const double fov = camera.vertical_fov;
  if (!(fov > 0 && fov < std::numbers::pi)) {
    faults.push_back(
        fmt::format("camera: fov is {}, must be above 0 and below 180", glm::degrees(fov)));
  }
  if (!is_finite(camera.up) || !(glm::length(camera.up) > 0)) {
    faults.push_back("camera: up must be finite and of a length above 0");
  }
  if (const auto* aim = std::get_if<AimDirection>(&camera.aim)) {
    const double sine =
        glm::length(glm::cross(glm::normalize(aim->direction), glm::normalize(camera.up)));
    if (!(sine > 1e-9)) {
      faults.push_back("camera: direction must be finite, of length 1, and not along up");
    }
  } else if (const auto* point = std::get_if<AimPoint>(&camera.aim);
             point != nullptr && !is_finite(point->point)) {
    faults.push_back("camera: look_at must be finite");
  }
}

// A moving camera may pass the point that it looks at.
void check_poses(const Scene& scene, Faults& faults) {
  for (int picture = 0; picture < scene.animation.pictures; ++picture) {
    try {
      pose_at(scene.camera, scene.animation.start + picture / scene.animation.rate);
    } catch (const InputError& error) {
      faults.push_back(fmt::format("picture {}: {}", picture, error.what()));
      return;
    }
  }
}

void check_settings(const Scene& scene, Faults& faults) {
  check_positive(scene.light_speed, "light_speed", faults);
  check_positive(scene.animation.rate, "animation: rate", faults);
  if (!std::isfinite(scene.animation.start)) faults.push_back("animation: start must be finite");
  check_count(scene.animation.pictures, 1, 1'000'000, "animation: pictures", faults);
  check_count(scene.render.width, 1, 32'768, "render: width", faults);
  check_count(scene.render.height, 1, 32'768, "render: height", faults);
  check_count(scene.render.samples, 1, 65'536, "render: samples", faults);
  const auto fault = output_pattern_fault(scene.output.path, scene.animation.pictures);
  if (fault) faults.push_back("output: " + *fault);
  const std::set<Layer> layers(scene.output.layers.begin(), scene.output.layers.end());
  if (layers.empty()) faults.push_back("output: layers must have at least one");
  if (layers.size() < scene.output.layers.size()) {
    faults.push_back("output: layers must not repeat");
  }
}

bool is_usable(const Mat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(matrix[column][row]) <= farthest)) return false;
    }
  }
  const bool affine = matrix[0].w == 0 && matrix[1].w == 0 && matrix[2].w == 0 && matrix[3].w == 1;
  return affine && glm::determinant(Mat3(matrix)) != 0;
}

void check_slots(const Object& object, const Mesh& mesh, const std::string& name, Faults& faults) {
  for (const MaterialRange& range : mesh.materials) {
    if (range.slot >= 0 && range.slot < static_cast<int>(object.materials.size())) continue;
    faults.push_back(fmt::format("{}: mesh \"{}\" uses material slot {}, the object has {}", name,
                                 mesh.name, range.slot, object.materials.size()));
    return;
  }
}

void check_parts(const Scene& scene, const Object& object, const std::string& name,
                 Faults& faults) {
  std::set<int> checked;
  for (const PlacedMesh& part : object.parts) {
    if (part.mesh < 0 || part.mesh >= static_cast<int>(scene.meshes.size())) {
      faults.push_back(
          fmt::format("{} refers to mesh {} of {}", name, part.mesh, scene.meshes.size()));
      continue;
    }
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(part.mesh)];
    if (checked.insert(part.mesh).second) check_slots(object, mesh, name, faults);
    if (is_usable(part.object_from_mesh)) continue;
    faults.push_back(fmt::format(
        "{}: mesh \"{}\" is placed by a matrix that is not affine, regular, and within 1e100", name,
        mesh.name));
  }
}

void check_objects(const Scene& scene, Faults& faults) {
  if (scene.objects.empty()) faults.push_back("there is no object, must be at least one");
  std::set<std::string> names;
  for (const Object& object : scene.objects) {
    const std::string name = fmt::format("object \"{}\"", object.name);
    if (!names.insert(object.name).second) faults.push_back("two objects are " + name);
    check_worldline(object.worldline, name, faults);
    if (!std::isfinite(object.clock)) faults.push_back(name + ": clock must be finite");
    check_parts(scene, object, name, faults);
    for (const int material : object.materials) {
      if (material >= 0 && material < static_cast<int>(scene.materials.size())) continue;
      faults.push_back(
          fmt::format("{} refers to material {} of {}", name, material, scene.materials.size()));
    }
  }
}

}  // namespace

double clock_at_reference(const Object& object) {
  if (!object.frame_clock) return object.clock;
  const Boost<in::Rest, in::World> rest_from_world(object.worldline.velocity);
  return rest_from_world(object.worldline.reference - Event<in::World>{}).t;
}

Worldline at_rest_on(const Object& object, const Vec3& offset, double clock) {
  const double since_reference = clock - clock_at_reference(object);
  return {object.worldline.rest_frame().to_world({since_reference, offset}),
          object.worldline.velocity};
}

std::vector<std::string> validate(const Scene& scene) {
  Faults faults;
  check_settings(scene, faults);
  if (scene.camera_given) check_camera(scene.camera, faults);
  check_objects(scene, faults);
  for (const Mesh& mesh : scene.meshes) validate_mesh(mesh, faults);
  validate_materials(scene, faults);
  validate_textures(scene, faults);
  if (scene.camera_given && faults.empty()) check_poses(scene, faults);
  for (std::size_t i = 0; i < scene.functions.size(); ++i) {
    for (const std::string& fault : temporal_faults(scene.functions[i])) {
      faults.push_back(fmt::format("temporal function {}: {}", i, fault));
    }
  }
  return faults;
}

}  // namespace restframe
