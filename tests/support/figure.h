#pragma once

// The scenes of the paper's figures as tests use them: the files of scenes/, with some keys changed
// so that they render quickly and hold the layers that are measured.

#include <string>
#include <vector>

#include "scene/scene.h"
#include "support/analytic_spheres.h"
#include "support/exr_reader.h"

namespace restframe {

// With `key = value` in the first [table], in place of what it says there; the table is added where
// there is none.
std::string with_key(std::string text, const std::string& table, const std::string& key,
                     const std::string& value);

// Without that line. Throws std::runtime_error if there is none.
std::string without_key(std::string text, const std::string& table, const std::string& key);

// Of this size and these layers, with one sample a pixel and no previews.
std::string small(std::string text, int width, int height, const std::string& layers);

// Each exposure on a picture of its own.
std::string exposures_apart(std::string text);

// As the program reads it.
Scene figure_scene(const std::string& text);

// One for each object, of these radii; the object's own clock, without clock = "frame".
std::vector<reference::MovingSphere> figure_spheres(const Scene& scene,
                                                    const std::vector<double>& radii);

// The camera at its clock's 0, of a scene in which it is at rest in the world and does not turn.
reference::ObserverCamera figure_camera(const Scene& scene);

// Closed form 1: where a camera at rest sees a sphere's centre, relative to the camera, when its
// clock shows `time`.
Vec3 seen_from(const reference::ObserverCamera& camera, const reference::MovingSphere& sphere,
               double time);

// That in pixels from the picture's middle, x right, y down.
glm::dvec2 film_offset(const reference::ObserverCamera& camera, const Vec3& seen);

// The pixels that see one object.
struct Spot {
  int pixels = 0, yellow = 0;
  double x = 0, y = 0;  // their mean, in pixels from the picture's middle, x right, y down
};
Spot spot_of(const ExrPicture& picture, int id);

// Shades of yellow have as much red as green; no other colour of the figures has.
bool is_yellow(const ExrPicture& picture, int x, int y);

}  // namespace restframe
