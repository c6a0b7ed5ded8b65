#include "support/observer_camera.h"

#include <utility>

namespace restframe::reference {
namespace {

// Half the film's width and height at distance 1.
std::pair<long double, long double> half_film(const ObserverCamera& camera) {
  const long double half_height = std::tan(static_cast<long double>(camera.vertical_fov) / 2);
  return {half_height * camera.width / camera.height, half_height};
}

}  // namespace

Vec3 gamma_beta_from_beta(const Vec3& beta) {
  const Long3 b = widened(beta);
  return narrowed(b / std::sqrt(1 - dot(b, b)));
}

Vec3 gamma_beta_from_gamma(double gamma, const Vec3& direction) {
  const long double g = gamma;
  return narrowed(std::sqrt((g - 1) * (g + 1)) * normalized(widened(direction)));
}

void aim(ObserverCamera& camera, const Vec3& direction, const Vec3& up) {
  const Long3 forward = normalized(widened(direction));
  const Long3 right = normalized(cross(forward, widened(up)));
  camera.right = narrowed(right);
  camera.up = narrowed(cross(right, forward));
  camera.back = narrowed(-1.0L * forward);
}

Long4 camera_event(const ObserverCamera& camera, double proper_time) {
  const Long3 u = widened(camera.gamma_beta);
  const long double tau = proper_time;
  return {camera.time + gamma_of(u) * tau, widened(camera.position) + tau * u};
}

Long3 direction_through(const ObserverCamera& camera, const FilmPoint& film) {
  const auto [half_width, half_height] = half_film(camera);
  const long double x = half_width * (2.0L * film.x / camera.width - 1);
  const long double y = half_height * (1 - 2.0L * film.y / camera.height);
  return normalized(x * widened(camera.right) + y * widened(camera.up) - widened(camera.back));
}

std::optional<FilmPoint> film_point(const ObserverCamera& camera, const Long3& direction) {
  const long double depth = -dot(direction, widened(camera.back));
  if (depth <= 0) return std::nullopt;
  const auto [half_width, half_height] = half_film(camera);
  const long double x = dot(direction, widened(camera.right)) / (depth * half_width);
  const long double y = dot(direction, widened(camera.up)) / (depth * half_height);
  return FilmPoint{static_cast<double>(camera.width * (1 + x) / 2),
                   static_cast<double>(camera.height * (1 - y) / 2)};
}

// The light's wave vector, backwards in time, is (-1, e) in the camera and (-frequency, frequency
// n) in the world. The world moves with -u past the camera: frequency = gamma - u.e, which is below
// 1 for what the camera flies towards (it sees the blueshift), and the space part is e + u (u.e /
// (gamma + 1) - 1).
WorldSight world_sight(const ObserverCamera& camera, const Long3& e) {
  const Long3 u = widened(camera.gamma_beta);
  const Long3 k = e + (dot(u, e) / (gamma_of(u) + 1) - 1) * u;
  return {normalized(k), frequency_seen_from(-1.0L * u, e)};
}

Long3 camera_sight(const ObserverCamera& camera, const Long3& n) {
  const Long3 u = widened(camera.gamma_beta);
  return normalized(n + (dot(u, n) / (gamma_of(u) + 1) + 1) * u);
}

}  // namespace restframe::reference
