#include "tracer/apparent_motion.h"

#include <algorithm>
#include <cmath>

#include "physics/doppler.h"

namespace restframe {
namespace {

// From a camera's direction to weights of its film's steps in x and y, and of its corner: those of
// the film point over its distance along the camera's axis, and that distance's inverse.
Vec3 on_film(const Projection& projection, const Vec3& direction) {
  const Mat3 from_film(projection.step_x(), projection.step_y(), projection.corner());
  return glm::inverse(from_film) * direction;
}

Vec2 limited(const Vec2& motion) {
  const double length = glm::length(motion);
  return length > ApparentMotion::longest ? motion * (ApparentMotion::longest / length) : motion;
}

}  // namespace

ApparentMotion::ApparentMotion(const Scene& scene, const ExposedCamera& camera, double next_opening)
    : scene_(scene),
      camera_(camera),
      opening_(next_opening),
      moment_(camera.moment_at(next_opening)) {}

ApparentMotion::FilmPoint ApparentMotion::seen_by(const ExposedCamera::Moment& moment,
                                                  const SurfaceData& seen) const {
  const Object& object = scene_.objects[static_cast<std::size_t>(seen.object)];
  const AnchoredFrame<in::Rest> rest = object.worldline.rest_frame();
  const Vec3 to_point = seen.position - rest(moment.pose.event).x;
  const double distance = glm::length(to_point);
  if (!(distance > 0.0)) return {};
  const WaveVector<in::World> sight =
      rest.from_world.inverse()(looking_along<in::Rest>(to_point / distance));
  const Vec3 direction = sight_direction(moment.pose.world_from_camera.inverse()(sight));
  constexpr double least_cosine = 1e-9;
  const Vec3 film = on_film(moment.projection, direction);
  if (film.z > least_cosine) return {Vec2(film) / film.z, true};
  const Mat3& axes = moment.pose.axes;
  return {{glm::dot(direction, axes[0]), -glm::dot(direction, axes[1])}, false};
}

// A rolling shutter meets the point in the row where it is seen then: found by going to and fro, in
// rows that are near the picture.
ApparentMotion::FilmPoint ApparentMotion::seen_next(const SurfaceData& seen,
                                                    const Vec2& film) const {
  const double a_row = scene_.camera.rolling / scene_.render.height;
  if (!(a_row > 0.0)) return seen_by(moment_, seen);
  constexpr int rounds = 30;
  constexpr double near_enough = 1e-6;  // pixels
  const double height = scene_.render.height;
  FilmPoint next{film, true};
  for (int i = 0; i < rounds && next.ahead; ++i) {
    const double row = std::clamp(next.film.y, -height, 2.0 * height);
    next = seen_by(camera_.moment_at(opening_ + a_row * row), seen);
    if (std::abs(next.film.y - row) < near_enough) break;
  }
  return next;
}

Vec2 ApparentMotion::operator()(const SurfaceData& seen, const Vec2& film) const {
  const FilmPoint next = seen_next(seen, film);
  if (next.ahead) {
    const Vec2 motion = next.film - film;
    return limited({motion.x, -motion.y});
  }
  const double length = glm::length(next.film);
  const Vec2 side = length > 0.0 ? next.film / length : Vec2(1, 0);
  return longest * Vec2(side.x, -side.y);
}

}  // namespace restframe
