#pragma once

// What a camera sees of uniformly moving spheres, by formulas: an independent reference for
// rendered pictures. Written without src/physics, in long double. Lengths are light-seconds, c = 1.

#include <optional>
#include <vector>

#include "support/observer_camera.h"

namespace restframe::reference {

// A sphere in its rest frame, whose centre is at `center` at world time `time`; there its clock
// shows `clock`. Everywhere on it the clock is the rest frame's time, set so.
struct MovingSphere {
  Vec3 gamma_beta{0, 0, 0};
  Vec3 center{0, 0, 0};
  double time = 0;
  double clock = 0;
  double radius = 1;
};

struct SphereHit {
  int sphere = 0;
  Vec3 point{0, 0, 0};    // in the sphere's rest frame, relative to its centre
  Vec3 normal{0, 0, 0};   // outward unit normal there
  double clock = 0;       // the sphere's clock
  double world_time = 0;  // of the event that is seen
  double distance = 0;    // that the light travelled, in the camera's rest frame
  double doppler = 1;     // nu_observed / nu_emitted
};

// What the camera sees through a film point when its clock shows `proper_time`: the nearest sphere,
// the inside of one that it is in; nothing where there is none.
std::optional<SphereHit> nearest_hit(const std::vector<MovingSphere>& spheres,
                                     const ObserverCamera& camera, double proper_time,
                                     const FilmPoint& film);

// A point that rests in a sphere's rest frame as the camera sees it, if nothing is in the way.
struct SeenPoint {
  std::optional<FilmPoint> film;  // nothing if it is not in front of the camera
  Vec3 direction{0, 0, -1};       // unit, in the camera's rest frame
  double clock = 0, world_time = 0, distance = 0, doppler = 1;  // as of a SphereHit
  bool faces_camera = false;  // whether the sphere itself leaves the point of its surface visible
};

// point: in the sphere's rest frame, relative to its centre; it need not be on the surface.
SeenPoint seen_point(const MovingSphere& sphere, const Vec3& point, const ObserverCamera& camera,
                     double proper_time);

// A sphere's outline: a circle on the camera's sky, whatever the velocities.
struct Outline {
  Long3 axis;                  // unit, in the camera's rest frame
  long double half_angle = 0;  // radians, 0 to pi
};

// Nothing if the camera is inside the sphere.
std::optional<Outline> outline(const MovingSphere& sphere, const ObserverCamera& camera,
                               double proper_time);

// The angle in radians on the camera's sky from the outline to a film point: negative inside it.
double angle_outside(const Outline& circle, const ObserverCamera& camera, const FilmPoint& film);

}  // namespace restframe::reference
