#include "support/analytic_spheres.h"

namespace restframe::reference {
namespace {

Long3 velocity_of(const MovingSphere& sphere) {
  const Long3 u = widened(sphere.gamma_beta);
  return u / gamma_of(u);
}

// Contraction undone: a displacement between things at rest in the sphere's frame, measured in the
// world at one time, becomes their displacement in the rest frame. The part along u grows by gamma.
Long3 uncontracted(const MovingSphere& sphere, const Long3& r) {
  const Long3 u = widened(sphere.gamma_beta);
  return r + (dot(u, r) / (gamma_of(u) + 1)) * u;
}

// Where the camera is in the sphere's rest frame, relative to the centre.
Long3 camera_from_center(const MovingSphere& sphere, const Long4& camera) {
  const Long3 u = widened(sphere.gamma_beta);
  return boosted(u, {camera.t - sphere.time, camera.x - widened(sphere.center)}).x;
}

// nu_observed / nu_emitted for light that the world sees come from n: the clock's slowness and the
// growing distance make 1 / (gamma (1 + v.n)), the camera's own motion the rest.
double doppler(const MovingSphere& sphere, const WorldSight& sight) {
  const long double emitted =
      sight.frequency * frequency_seen_from(widened(sphere.gamma_beta), sight.direction);
  return static_cast<double>(1 / emitted);
}

// The distance lambda >= 0, as the world measures it, that light came from the sphere.
//
// In the world, the sphere is an ellipsoid that flies: at time t the place x is in it where
// r = x - center - v (t - time) fulfils |uncontracted(r)| <= radius. Back along the sight line,
// x = x_c + lambda n and t = t_c - lambda, so r = r_c + lambda (n + v): a quadratic in lambda.
std::optional<long double> light_path(const MovingSphere& sphere, const Long4& camera,
                                      const Long3& n) {
  const Long3 v = velocity_of(sphere);
  const Long3 q = uncontracted(sphere, n + v);
  const Long3 r =
      uncontracted(sphere, camera.x - widened(sphere.center) - (camera.t - sphere.time) * v);
  const long double radius = sphere.radius;
  const Long3 q_cross_r = cross(q, r);
  const long double discriminant = radius * radius * dot(q, q) - dot(q_cross_r, q_cross_r);
  if (discriminant < 0) return std::nullopt;
  const long double root = std::sqrt(discriminant), middle = -dot(q, r);
  for (const long double lambda : {(middle - root) / dot(q, q), (middle + root) / dot(q, q)}) {
    if (lambda > 0) return lambda;
  }
  return std::nullopt;
}

SphereHit hit_at(const MovingSphere& sphere, const Long4& camera, const WorldSight& sight,
                 long double lambda) {
  const Long3 u = widened(sphere.gamma_beta);
  const long double t = camera.t - lambda, elapsed = t - sphere.time;
  const Long3 x = camera.x + lambda * sight.direction;
  const Long3 r = x - widened(sphere.center) - elapsed * velocity_of(sphere);
  const Long3 point = uncontracted(sphere, r);
  SphereHit hit;
  hit.point = narrowed(point);
  hit.normal = narrowed(normalized(point));
  // The centre's clock at that world time, minus what the rest frame's simultaneity takes off ahead
  // of it.
  hit.clock = static_cast<double>(sphere.clock + elapsed / gamma_of(u) - dot(u, r));
  hit.world_time = static_cast<double>(t);
  hit.distance = static_cast<double>(lambda / sight.frequency);
  hit.doppler = doppler(sphere, sight);
  return hit;
}

}  // namespace

std::optional<SphereHit> nearest_hit(const std::vector<MovingSphere>& spheres,
                                     const ObserverCamera& camera, double proper_time,
                                     const FilmPoint& film) {
  const Long4 event = camera_event(camera, proper_time);
  const WorldSight sight = world_sight(camera, direction_through(camera, film));
  std::optional<SphereHit> nearest;
  long double nearest_path = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const std::optional<long double> path = light_path(spheres[i], event, sight.direction);
    if (!path || (nearest && *path >= nearest_path)) continue;
    nearest_path = *path;
    nearest = hit_at(spheres[i], event, sight, *path);
    nearest->sphere = static_cast<int>(i);
  }
  return nearest;
}

// With R the point's true place at the camera's time relative to the camera, r its length, the
// light left it when it was at R - v d, a distance d away: d^2 / gamma^2 + 2 d R.v - r^2 = 0, so d
// = gamma^2 [-R.v + sqrt((R.v)^2 + r^2 / gamma^2)].
SeenPoint seen_point(const MovingSphere& sphere, const Vec3& point, const ObserverCamera& camera,
                     double proper_time) {
  const Long3 u = widened(sphere.gamma_beta), p = widened(point), v = velocity_of(sphere);
  const long double gamma = gamma_of(u);
  const Long4 event = camera_event(camera, proper_time);
  const long double elapsed = event.t - sphere.time;
  // Contraction: the point's place beside the centre at one world time.
  const Long3 beside = p - (dot(u, p) / (gamma * (gamma + 1))) * u;
  const Long3 R = widened(sphere.center) + elapsed * v + beside - event.x;
  const long double along = gamma * dot(R, u), root = std::hypot(along, gamma * length(R));
  const long double d = along > 0 ? gamma * gamma * dot(R, R) / (along + root) : root - along;
  const Long3 n = normalized(R - d * v);
  const Long3 e = camera_sight(camera, n);
  const WorldSight sight{n, 1 / frequency_seen_from(widened(camera.gamma_beta), n)};
  SeenPoint seen;
  seen.film = film_point(camera, e);
  seen.direction = narrowed(e);
  seen.clock = static_cast<double>(sphere.clock + (elapsed - d - dot(u, p)) / gamma);
  seen.world_time = static_cast<double>(event.t - d);
  seen.distance = static_cast<double>(d / sight.frequency);
  seen.doppler = doppler(sphere, sight);
  seen.faces_camera = dot(camera_from_center(sphere, event) - p, p) > 0;
  return seen;
}

// In the sphere's rest frame the outline is the cone around a, the direction of its centre, of
// half-angle alpha with sin(alpha) = radius / distance: a sight line k = (-1, n') meets the sphere
// where n'.a - cos(alpha) > 0. That is the Minkowski product of k with S' = (-cos(alpha), a), so in
// the camera, where S' becomes S = (S0, s) and k is (-1, e) but for a factor, it is e.s + S0 > 0: a
// cone around s whose half-angle has the cosine -S0/|s|, and the sine sin(alpha)/|s| since |s|^2 -
// S0^2 = sin^2(alpha).
std::optional<Outline> outline(const MovingSphere& sphere, const ObserverCamera& camera,
                               double proper_time) {
  const Long3 from_camera = -1.0L * camera_from_center(sphere, camera_event(camera, proper_time));
  const long double distance = length(from_camera), sine = sphere.radius / distance;
  if (sine >= 1) return std::nullopt;
  const Long4 in_rest{-std::sqrt((1 - sine) * (1 + sine)), from_camera / distance};
  const Long4 in_world = boosted(-1.0L * widened(sphere.gamma_beta), in_rest);
  const Long4 in_camera = boosted(widened(camera.gamma_beta), in_world);
  return Outline{normalized(in_camera.x), std::atan2(sine, -in_camera.t)};
}

double angle_outside(const Outline& circle, const ObserverCamera& camera, const FilmPoint& film) {
  const Long3 e = direction_through(camera, film);
  return static_cast<double>(angle_between(e, circle.axis) - circle.half_angle);
}

}  // namespace restframe::reference
