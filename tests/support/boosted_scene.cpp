#include "support/boosted_scene.h"

#include <stdexcept>

#include "support/long_vectors.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;
using reference::narrowed;
using reference::widened;

// The four-velocity (gamma, u) is boosted like any displacement.
Long3 boosted_velocity(const Long3& u, const Long3& new_world) {
  return reference::boosted(new_world, {reference::gamma_of(u), u}).x;
}

Worldline boosted(const Worldline& line, const Velocity& new_world) {
  const Long3 w = widened(new_world.gamma_beta());
  const Long4 event = reference::boosted(w, {line.reference.t, widened(line.reference.x)});
  const Long3 u = boosted_velocity(widened(line.velocity.gamma_beta()), w);
  return {{static_cast<double>(event.t), narrowed(event.x)},
          Velocity::from_gamma_beta(narrowed(u))};
}

}  // namespace

// From old rest-frame coordinates to the old world's (boost by -u), to the new world's (by w), to
// the new rest-frame coordinates (by u'): the same frame twice, so what is left is a rotation.
Mat3 wigner_rotation(const Velocity& velocity, const Velocity& new_world) {
  const Long3 u = widened(velocity.gamma_beta()), w = widened(new_world.gamma_beta());
  const reference::LongMatrix loop = reference::boost_matrix(boosted_velocity(u, w)) *
                                     reference::boost_matrix(w) *
                                     reference::boost_matrix(-1.0L * u);
  Mat3 rotation;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rotation[column][row] = static_cast<double>(
          loop[static_cast<std::size_t>(row + 1)][static_cast<std::size_t>(column + 1)]);
    }
  }
  return rotation;
}

Scene boosted(const Scene& scene, const Velocity& new_world) {
  Scene result = scene;
  for (Object& object : result.objects) {
    const Mat4 turn(wigner_rotation(object.worldline.velocity, new_world));
    for (PlacedMesh& part : object.parts) part.object_from_mesh = turn * part.object_from_mesh;
    object.worldline = boosted(object.worldline, new_world);
  }
  for (Light& light : result.lights) {
    const Mat3 turn = wigner_rotation(light.worldline.velocity, new_world);
    light.direction = turn * light.direction;
    light.rest_from_map = turn * light.rest_from_map;
    if (light.sweep) light.sweep->axis = turn * light.sweep->axis;
    light.worldline = boosted(light.worldline, new_world);
  }
  Camera& camera = result.camera;
  AimDirection* aim = std::get_if<AimDirection>(&camera.aim);
  if (!aim) throw std::invalid_argument("boosted: the camera's aim must be a direction");
  const Mat3 turn = wigner_rotation(std::get<Worldline>(camera.motion).velocity, new_world);
  aim->direction = turn * aim->direction;
  camera.up = turn * camera.up;
  camera.motion = boosted(std::get<Worldline>(camera.motion), new_world);
  return result;
}

}  // namespace restframe
