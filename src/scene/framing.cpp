#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace restframe {
namespace {

constexpr double default_fov = glm::pi<double>() / 4.0;
constexpr double widest_fov = 2.6;       // radians
constexpr double margin = 1.08;          // some air around what is framed
constexpr std::size_t most_boxes = 500;  // of an object; more parts are taken together
const Vec3 view_from(0.35, 0.25, 1.0);

// Points at rest in an object's rest frame, around its origin, that show where it reaches.
struct Outline {
  Worldline worldline;
  std::vector<Vec3> points;
};

void add_corners(const Bounds& bounds, const Mat4& to, std::vector<Vec3>& points) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                 (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                 (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z);
    points.emplace_back(to * glm::dvec4(p, 1.0));
  }
}

Bounds bounds_of_points(const std::vector<Vec3>& points) {
  Bounds all;
  for (const Vec3& p : points) all.add(p);
  return all;
}

std::vector<Outline> outlines(const Scene& scene) {
  std::vector<Bounds> of_mesh;
  for (const Mesh& mesh : scene.meshes) of_mesh.push_back(bounds_of(mesh));
  std::vector<Outline> result;
  for (const Object& object : scene.objects) {
    Outline outline{object.worldline, {}};
    for (const PlacedMesh& part : object.parts) {
      const Bounds& bounds = of_mesh[static_cast<std::size_t>(part.mesh)];
      if (!bounds.empty()) add_corners(bounds, part.object_from_mesh, outline.points);
    }
    if (outline.points.empty()) continue;
    if (object.parts.size() > most_boxes) {
      const Bounds all = bounds_of_points(outline.points);
      outline.points.clear();
      add_corners(all, Mat4(1), outline.points);
    }
    result.push_back(std::move(outline));
  }
  return result;
}

// Unit directions, in the world, in which an observer at rest there sees the points.
std::vector<Vec3> seen_directions(const std::vector<Outline>& outlines,
                                  const Event<in::World>& observer) {
  std::vector<Vec3> directions;
  for (const Outline& outline : outlines) {
    const AnchoredFrame<in::Rest> rest = outline.worldline.rest_frame();
    for (const Vec3& point : outline.points) {
      const Event<in::World> seen = rest.to_world(seen_event(rest, observer, point));
      const Vec3 to_point = seen.x - observer.x;
      const double distance = glm::length(to_point);
      if (distance > 0.0) directions.push_back(to_point / distance);
    }
  }
  return directions;
}

struct View {
  Vec3 position{0};
  double time = 0;
  Vec3 forward{0, 0, -1};
  double reach = std::numeric_limits<double>::infinity();  // over half the film: 1 just fits
};

Vec3 up_for(const Vec3& forward) {
  return std::abs(forward.y) > 0.999 ? Vec3(0, 0, -1) : Vec3(0, 1, 0);
}

// The rectangle on the film (at distance 1) that holds all directions; empty if one is behind.
struct FilmBox {
  double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
  bool behind = false;
};

FilmBox film_box(const std::vector<Vec3>& directions, const Vec3& forward) {
  const Vec3 right = glm::normalize(glm::cross(forward, up_for(forward)));
  const Vec3 up = glm::cross(right, forward);
  FilmBox box;
  for (const Vec3& direction : directions) {
    const double depth = glm::dot(direction, forward);
    if (depth < 0.05) {
      box.behind = true;
      return box;
    }
    const double x = glm::dot(direction, right) / depth;
    const double y = glm::dot(direction, up) / depth;
    box.left = std::min(box.left, x);
    box.right = std::max(box.right, x);
    box.bottom = std::min(box.bottom, y);
    box.top = std::max(box.top, y);
  }
  return box;
}

// Aims at the middle of what is seen; a few steps, since turning the film changes its rectangle.
void aim(const std::vector<Vec3>& directions, double half_width, double half_height, View& view) {
  for (int step = 0; step < 8; ++step) {
    const FilmBox box = film_box(directions, view.forward);
    if (box.behind) return;
    const double x = 0.5 * (box.left + box.right);
    const double y = 0.5 * (box.bottom + box.top);
    const Vec3 right = glm::normalize(glm::cross(view.forward, up_for(view.forward)));
    const Vec3 up = glm::cross(right, view.forward);
    view.forward = glm::normalize(view.forward + x * right + y * up);
  }
  const FilmBox box = film_box(directions, view.forward);
  if (box.behind) return;
  const double width = std::max(std::abs(box.left), std::abs(box.right));
  const double height = std::max(std::abs(box.bottom), std::abs(box.top));
  view.reach = std::max(width / half_width, height / half_height);
}

// From as near as everything fits, or the best there is.
View best_view(const std::vector<Outline>& outlines, double start, double half_width,
               double half_height) {
  Bounds all;
  double latest = -std::numeric_limits<double>::infinity();
  for (const Outline& outline : outlines) {
    for (const Vec3& point : outline.points) all.add(outline.worldline.reference.x + point);
    latest = std::max(latest, outline.worldline.reference.t);
  }
  const double extent = glm::length(all.extent());
  const double size = extent > 0.0 ? extent : 1.0;
  View best;
  for (double distance = 0.05 * size; distance < 100.0 * size; distance *= 1.03) {
    View view;
    view.position = all.center() + distance * glm::normalize(view_from);
    // Light of the reference events is arriving: things are seen about where the scene puts them.
    view.time = latest + distance;
    view.forward = -glm::normalize(view_from);
    aim(seen_directions(outlines, {view.time + start, view.position}), half_width, half_height,
        view);
    if (view.reach < best.reach) best = view;
    if (best.reach * margin <= 1.0) break;
  }
  return best;
}

}  // namespace

Camera framing_camera(const Scene& scene, double proper_time) {
  const std::vector<Outline> all = outlines(scene);
  if (all.empty()) return {};
  const double aspect = static_cast<double>(scene.render.width) / scene.render.height;
  const double half_height = std::tan(0.5 * default_fov);
  const View view = best_view(all, proper_time, half_height * aspect, half_height);
  Camera camera;
  std::get<Worldline>(camera.motion).reference = {view.time, view.position};
  camera.aim = AimDirection{view.forward};
  camera.up = up_for(view.forward);
  const double widening = std::max(1.0, view.reach * margin);
  camera.vertical_fov = std::isfinite(widening)
                            ? std::min(2.0 * std::atan(half_height * widening), widest_fov)
                            : widest_fov;
  return camera;
}

}  // namespace restframe
