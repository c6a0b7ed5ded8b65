#include "scene/framing.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "physics/doppler.h"

namespace restframe {
namespace {

// A ball around an object's parts, at rest in the object's rest frame.
struct BoundingBall {
  Worldline worldline;
  Vec3 center{0};
  double radius = 0;
};

constexpr double default_fov = glm::pi<double>() / 4.0;
constexpr double widest_fov = 2.6;  // radians
constexpr double margin = 1.08;     // some air around what is framed
const Vec3 view_from(0.35, 0.25, 1.0);

std::vector<BoundingBall> bounding_balls(const Scene& scene) {
  std::vector<Bounds> of_mesh;
  for (const Mesh& mesh : scene.meshes) of_mesh.push_back(bounds_of(mesh));
  std::vector<BoundingBall> balls;
  for (const Object& object : scene.objects) {
    Bounds all;
    for (const PlacedMesh& part : object.parts) {
      const Bounds& b = of_mesh[static_cast<std::size_t>(part.mesh)];
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p((corner & 1) != 0 ? b.upper.x : b.lower.x,
                     (corner & 2) != 0 ? b.upper.y : b.lower.y,
                     (corner & 4) != 0 ? b.upper.z : b.lower.z);
        all.add(Vec3(part.object_from_mesh * glm::dvec4(p, 1.0)));
      }
    }
    if (!all.empty())
      balls.push_back({object.worldline, all.center(), 0.5 * glm::length(all.extent())});
  }
  return balls;
}

// The circle on the sky as which a ball is seen (closed form: a sphere's outline is a circle).
struct SkyCircle {
  Vec3 axis{0, 0, -1};  // unit, world frame
  double half_angle = 0;
  bool around_observer = false;
};

SkyCircle seen_circle(const BoundingBall& ball, const Event<in::World>& observer) {
  const AnchoredFrame<in::Rest> rest = ball.worldline.rest_frame();
  const Vec3 to_ball = ball.center - rest(observer).x;
  const double distance = glm::length(to_ball);
  if (distance <= ball.radius * 1.0001) return {{0, 0, -1}, 0, true};
  // In the rest frame n.a = cos(alpha) around a; with S = (-cos alpha, a) the outline is n.s = -S0
  // in any frame.
  const double sine = ball.radius / distance;
  const Displacement<in::Rest> cone{-std::sqrt(1.0 - sine * sine), to_ball / distance};
  const Displacement<in::World> seen = rest.from_world.inverse()(cone);
  const double length = glm::length(seen.x);
  return {seen.x / length, std::acos(glm::clamp(-seen.t / length, -1.0, 1.0)), false};
}

// Half the view, along the film's shorter side, that shows all circles when aimed at `forward`.
double needed_half_angle(const std::vector<SkyCircle>& circles, const Vec3& forward) {
  double needed = 0;
  for (const SkyCircle& circle : circles) {
    if (circle.around_observer) return glm::pi<double>();
    const double off_axis = std::acos(glm::clamp(glm::dot(circle.axis, forward), -1.0, 1.0));
    needed = std::max(needed, off_axis + circle.half_angle);
  }
  return needed;
}

struct View {
  Vec3 forward{0, 0, -1};
  double half_angle = 0;
};

// Aims between the circles: a few steps towards whichever reaches out farthest.
View best_view(const std::vector<BoundingBall>& balls, const Event<in::World>& observer) {
  std::vector<SkyCircle> circles;
  Vec3 forward(0);
  for (const BoundingBall& ball : balls) {
    circles.push_back(seen_circle(ball, observer));
    forward += circles.back().axis;
  }
  forward = glm::length(forward) > 1e-6 ? glm::normalize(forward) : circles[0].axis;
  View best{forward, needed_half_angle(circles, forward)};
  for (int step = 1; step <= 200; ++step) {
    const SkyCircle* farthest = &circles[0];
    for (const SkyCircle& circle : circles) {
      const auto reach = [&](const SkyCircle& c) {
        return std::acos(glm::clamp(glm::dot(c.axis, forward), -1.0, 1.0)) + c.half_angle;
      };
      if (reach(circle) > reach(*farthest)) farthest = &circle;
    }
    forward = glm::normalize(forward + (farthest->axis - forward) / (step + 1.0));
    const double needed = needed_half_angle(circles, forward);
    if (needed < best.half_angle) best = {forward, needed};
  }
  return best;
}

// Half the angle between opposite sides of the film's shorter side.
double half_view(const Scene& scene, double vertical_fov) {
  const double half_height = std::tan(0.5 * vertical_fov);
  return std::atan(half_height * std::min(1.0, double(scene.render.width) / scene.render.height));
}

Camera camera_at(const Vec3& position, const View& view, double fov) {
  Camera camera;
  camera.worldline.reference.x = position;
  camera.aim = AimDirection{view.forward};
  if (std::abs(view.forward.y) > 0.999) camera.up = {0, 0, -1};
  camera.vertical_fov = fov;
  return camera;
}

}  // namespace

Camera framing_camera(const Scene& scene, double proper_time) {
  const std::vector<BoundingBall> balls = bounding_balls(scene);
  if (balls.empty()) return {};
  Bounds all;  // where things are in the world at the reference time, without light's delay
  for (const BoundingBall& ball : balls) {
    const Vec3 center = ball.worldline.reference.x + ball.center;
    all.add(center - Vec3(ball.radius));
    all.add(center + Vec3(ball.radius));
  }
  const double size = std::max(glm::length(all.extent()), 1e-12);
  const double wanted = half_view(scene, default_fov) / margin;
  const double start_time = balls[0].worldline.reference.t;
  Vec3 position(0);
  View view;
  for (double distance = 0.05 * size; distance < 1e7 * size; distance *= 1.05) {
    position = all.center() + distance * glm::normalize(view_from);
    view = best_view(balls, {start_time + proper_time, position});
    if (view.half_angle <= wanted) break;
  }
  double fov = default_fov;
  while (half_view(scene, fov) < view.half_angle * margin && fov < widest_fov) fov *= 1.02;
  Camera camera = camera_at(position, view, fov);
  camera.worldline.reference.t = start_time;
  return camera;
}

}  // namespace restframe
