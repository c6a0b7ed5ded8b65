#pragma once

// Scenes of moving spheres, described once for the analytic reference and written as a scene file
// for the program, which renders them.

#include <string>
#include <vector>

#include "support/analytic_spheres.h"
#include "support/exr_reader.h"

namespace restframe {

struct SphereScene {
  reference::ObserverCamera camera;
  double start = 0;                                // the camera's clock of the picture
  std::vector<reference::MovingSphere> spheres{};  // named sphere_1, sphere_2 ...; material "ball"
  int fineness = 5;
  double light_speed = 1;  // the file's lengths are this many times longer
  int samples = 1;
  std::string layers = R"(["beauty", "Z", "time", "doppler", "N", "P", "UV", "id"])";
  std::string render{}, more{};  // further lines of [render], and further tables
};

// With all digits of every number.
std::string scene_file(const SphereScene& scene);

// What the program makes of a scene file, which lies in a folder of its own. Throws
// std::runtime_error with the program's words if it fails.
ExrPicture rendered(const std::filesystem::path& program, const std::string& scene_file);

// The mesh of a sphere of radius 1 lies between the spheres of radius 1 - facets_error and 1.
double facets_error(int fineness);

// The spheres inside the facets of these.
std::vector<reference::MovingSphere> inscribed(std::vector<reference::MovingSphere> spheres,
                                               int fineness);

// The centre of a pixel.
inline reference::FilmPoint pixel_center(int x, int y) {
  return {x + 0.5, y + 0.5};
}

// Sets place and time so that the camera sees the centre in that direction of its own rest frame,
// and sees light from it that travelled `distance` as the world measures it.
void place_in_sight(reference::MovingSphere& sphere, const reference::ObserverCamera& camera,
                    double proper_time, const Vec3& direction, double distance);

}  // namespace restframe
