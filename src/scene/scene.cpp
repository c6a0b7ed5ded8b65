#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/output_pattern.h"
#include "scene/validate_data.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

void check_positive(double value, const char* what, Faults& faults) {
  if (value > 0 && std::isfinite(value)) return;
  faults.push_back(fmt::format("{} is {}, must be above 0 and finite", what, value));
}

void check_count(int value, int low, int high, const char* what, Faults& faults) {
  if (value >= low && value <= high) return;
  faults.push_back(fmt::format("{} is {}, must be from {} to {}", what, value, low, high));
}

// What the noise of pixels is told from, and where it can not be told.
void check_noise(const Scene& scene, Faults& faults) {
  const double noise = scene.render.noise;
  if (!(noise >= 0 && noise <= 1)) {
    faults.push_back(fmt::format("render: noise is {}, must be from 0 to 1", noise));
  }
  const OutputSettings& output = scene.output;
  const bool statistics =
      has_layer(output.layers, Layer::variance) || has_layer(output.layers, Layer::samples);
  if (statistics && !has_layer(output.layers, Layer::beauty)) {
    faults.push_back(
        "output: the layers \"variance\" and \"samples\" tell of the beauty; add \"beauty\"");
  }
  if (!(noise > 0) && !has_layer(output.layers, Layer::variance)) return;
  const char* what = noise > 0 ? "render: noise" : "output: the layer \"variance\"";
  if (scene.render.samples < least_measured_samples) {
    faults.push_back(fmt::format("{} needs samples to be at least {}, it is {}", what,
                                 least_measured_samples, scene.render.samples));
  }
  if (scene.exposure.count > 1 && scene.exposure.combine == Combine::max) {
    faults.push_back(fmt::format(
        "{} can not be told of exposures combined by \"max\"; \"sum\" and \"mean\" can", what));
  }
}

void check_band(const RenderSettings& render, Faults& faults) {
  if (!render.observe) return;
  if (!render.doppler) faults.emplace_back("render: observe goes with doppler = true only");
  for (const std::string& fault : band_faults(*render.observe)) {
    faults.push_back("render: observe: " + fault);
  }
}

void check_window(const RenderSettings& render, Faults& faults) {
  check_count(render.width, 1, most_pixels_a_side, "render: width", faults);
  check_count(render.height, 1, most_pixels_a_side, "render: height", faults);
  check_count(render.overscan, 0, most_overscan, "render: overscan", faults);
  if (!render.crop) return;
  const PixelWindow& crop = *render.crop;
  if (crop.width > 0 && crop.height > 0 && contains(whole_window(render), crop)) return;
  faults.push_back(fmt::format(
      "render: crop [{}, {}, {}, {}] must hold a pixel, and lie within resolution and overscan",
      crop.left, crop.top, crop.width, crop.height));
}

void check_pixel_types(const OutputSettings& output, Faults& faults) {
  for (const std::vector<Layer>* layers : {&output.half_layers, &output.float_layers}) {
    for (const Layer layer : *layers) {
      if (has_layer(output.layers, layer)) continue;
      faults.emplace_back("output: half and float must name layers that are among `layers`");
      return;
    }
  }
  for (const Layer layer : output.half_layers) {
    if (needs_float(layer)) {
      faults.emplace_back(
          "output: half can not hold the layers \"time\", \"id\", \"variance\", \"samples\" and "
          "Cryptomattes");
    }
    if (has_layer(output.float_layers, layer)) {
      faults.emplace_back("output: a layer can not be both half and float");
    }
  }
}

void check_output(const Scene& scene, Faults& faults) {
  const OutputSettings& output = scene.output;
  if (!(std::abs(output.exposure) <= most_stops)) {
    faults.push_back(fmt::format("output: exposure is {}, must be from {} to {}", output.exposure,
                                 -most_stops, most_stops));
  }
  const auto fault = output_pattern_fault(output.path, scene.animation.pictures);
  if (fault) faults.push_back("output: " + *fault);
  const std::set<Layer> layers(output.layers.begin(), output.layers.end());
  if (layers.empty()) faults.push_back("output: layers must have at least one");
  if (layers.size() < output.layers.size()) faults.push_back("output: layers must not repeat");
  if (!(output.compression_level >= 0 && output.compression_level <= most_compression_level)) {
    faults.push_back(fmt::format("output: compression_level is {}, must be from 0 to {}",
                                 output.compression_level, most_compression_level));
  }
  check_pixel_types(output, faults);
}

void check_settings(const Scene& scene, Faults& faults) {
  check_positive(scene.light_speed, "light_speed", faults);
  check_positive(scene.animation.rate, "animation: rate", faults);
  if (!std::isfinite(scene.animation.start)) faults.push_back("animation: start must be finite");
  check_count(scene.animation.pictures, 1, 1'000'000, "animation: pictures", faults);
  check_window(scene.render, faults);
  check_count(scene.render.samples, 1, 65'536, "render: samples", faults);
  check_count(scene.render.depth, 1, 64, "render: depth", faults);
  check_noise(scene, faults);
  check_band(scene.render, faults);
  check_output(scene, faults);
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
    if (part.name < -1 || part.name >= static_cast<int>(object.part_names.size())) {
      faults.push_back(
          fmt::format("{}: a part has name {} of {}", name, part.name, object.part_names.size()));
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
    validate_worldline(object.worldline, name, faults);
    if (!std::isfinite(object.clock)) faults.push_back(name + ": clock must be finite");
    check_parts(scene, object, name, faults);
    for (const int material : object.materials) {
      if (material >= 0 && material < static_cast<int>(scene.materials.size())) continue;
      faults.push_back(
          fmt::format("{} refers to material {} of {}", name, material, scene.materials.size()));
    }
  }
}

void check_lights(const Scene& scene, Faults& faults) {
  std::set<std::string> names;
  for (const Light& light : scene.lights) {
    const std::string name = fmt::format("light \"{}\"", light.name);
    if (!names.insert(light.name).second) faults.push_back("two lights are " + name);
    validate_worldline(light.worldline, name, faults);
    validate_light(scene, light, name, faults);
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

// Now, a length along u = gamma beta is gamma times shorter: x - u (u.x) / (gamma (gamma + 1)).
Worldline at_rest_on(const Object& object, const Vec3& offset) {
  const Velocity& velocity = object.worldline.velocity;
  const Vec3& u = velocity.gamma_beta();
  const double gamma = velocity.gamma();
  const Vec3 contracted = offset - u * (glm::dot(u, offset) / (gamma * (gamma + 1.0)));
  const Event<in::World>& reference = object.worldline.reference;
  return {{reference.t, reference.x + contracted}, velocity};
}

std::vector<std::string> validate(const Scene& scene) {
  Faults faults;
  check_settings(scene, faults);
  validate_layers(scene, faults);
  validate_exposure(scene.exposure, faults);
  if (scene.camera_given) validate_camera(scene.camera, faults);
  if (scene.camera_given) validate_lens(scene.camera, faults);
  check_objects(scene, faults);
  check_lights(scene, faults);
  for (const Mesh& mesh : scene.meshes) validate_mesh(mesh, faults);
  validate_materials(scene, faults);
  validate_textures(scene, faults);
  for (const SkyMap& map : scene.sky_maps) validate_sky_map(map, faults);
  if (scene.camera_given && faults.empty()) validate_poses(scene, faults);
  for (std::size_t i = 0; i < scene.functions.size(); ++i) {
    for (const std::string& fault : temporal_faults(scene.functions[i])) {
      faults.push_back(fmt::format("temporal function {}: {}", i, fault));
    }
  }
  return faults;
}

}  // namespace restframe
