// The camera that is chosen where a scene gives none: everything is seen inside the picture, and fills
// it. Where things are seen comes from the light-cone equation of a moving point, in long double.

#include "scene/framing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/generators.h"
#include "support/long_vectors.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::widened;

struct Placed {
  Vec3 half_size{1};  // of a box around the object's origin, in its rest frame
  Vec3 position{0};
  double time = 0;
  Vec3 beta{0};
};

// A mesh of a box's corners; its faces matter to nobody here.
Mesh box(const Vec3& half) {
  Mesh mesh;
  mesh.name = "box";
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back((corner & 1) != 0 ? half.x : -half.x,
                                (corner & 2) != 0 ? half.y : -half.y,
                                (corner & 4) != 0 ? half.z : -half.z);
  }
  mesh.triangles = {{0, 1, 2}, {5, 6, 7}, {3, 4, 5}};
  mesh.materials = {{0, 0}};
  pad_for_embree(mesh);
  return mesh;
}

Scene scene_of(const std::vector<Placed>& things, int width = 1280, int height = 720) {
  Scene scene;
  scene.render.width = width;
  scene.render.height = height;
  scene.materials.emplace_back();
  for (const Placed& thing : things) {
    Object object;
    object.name = "thing " + std::to_string(scene.objects.size());
    object.worldline = {{thing.time, thing.position}, Velocity::from_beta(thing.beta)};
    object.parts = {{static_cast<int>(scene.meshes.size()), Mat4(1)}};
    object.materials = {0};
    scene.objects.push_back(object);
    scene.meshes.push_back(box(thing.half_size));
  }
  return scene;
}

// The direction in which an observer at rest at `place` and time `t` sees the point that rests at `point` of
// the object: R is its true position now, d = gamma^2 (-R.v + sqrt((R.v)^2 + r^2 / gamma^2)) the delay.
Long3 seen_direction(const Object& object, const Vec3& point, const Vec3& place, double t) {
  const Long3 u = widened(object.worldline.velocity.gamma_beta());
  const long double gamma = reference::gamma_of(u);
  const Long3 v = u / gamma;
  // The point's event of the rest-frame time 0, in the world.
  const reference::Long4 event = reference::boosted(-1.0L * u, {0, widened(point)});
  const Event<in::World>& reference = object.worldline.reference;
  const long double since = static_cast<long double>(t) - reference.t - event.t;
  const Long3 now = (widened(reference.x) - widened(place)) + event.x + since * v;
  const long double along = reference::dot(now, v);
  const long double delay =
      gamma * gamma *
      (-along + std::sqrt(along * along + reference::dot(now, now) / (gamma * gamma)));
  return reference::normalized(now - delay * v);
}

// Over half the picture: within -1 to 1 is inside.
struct FilmExtent {
  long double least_x = 1e9L, most_x = -1e9L, least_y = 1e9L, most_y = -1e9L;
  bool in_front = true;
};

FilmExtent extent_on_film(const Scene& scene, const Camera& camera, double proper_time) {
  EXPECT_EQ(std::get<Worldline>(camera.motion).velocity, Velocity());
  const CameraPose pose = pose_at(camera, proper_time);
  const long double half_height = std::tan(0.5L * camera.vertical_fov);
  const long double half_width = half_height * scene.render.width / scene.render.height;
  FilmExtent film;
  for (const Object& object : scene.objects) {
    for (const PlacedMesh& part : object.parts) {
      for (const Vec3f& p : scene.meshes[static_cast<std::size_t>(part.mesh)].positions) {
        const Vec3 point(part.object_from_mesh * glm::dvec4(Vec3(p), 1.0));
        const Long3 sight = seen_direction(object, point, pose.event.x, pose.event.t);
        const long double depth = -reference::dot(sight, widened(pose.axes[2]));
        if (depth <= 0) film.in_front = false;
        const long double x = reference::dot(sight, widened(pose.axes[0])) / depth / half_width;
        const long double y = reference::dot(sight, widened(pose.axes[1])) / depth / half_height;
        film.least_x = std::min(film.least_x, x);
        film.most_x = std::max(film.most_x, x);
        film.least_y = std::min(film.least_y, y);
        film.most_y = std::max(film.most_y, y);
      }
    }
  }
  return film;
}

void expect_framed(const Scene& scene, double proper_time, const char* what,
                   long double least_filled = 0.8L) {
  const FilmExtent film = extent_on_film(scene, framing_camera(scene, proper_time), proper_time);
  EXPECT_TRUE(film.in_front) << what;
  EXPECT_GE(film.least_x, -1.0L) << what;
  EXPECT_LE(film.most_x, 1.0L) << what;
  EXPECT_GE(film.least_y, -1.0L) << what;
  EXPECT_LE(film.most_y, 1.0L) << what;
  const long double filled = std::max(film.most_x - film.least_x, film.most_y - film.least_y) / 2;
  EXPECT_GE(filled, least_filled) << what;
}

TEST(Framing, OneObjectAtRest) {
  expect_framed(scene_of({{}}), 0, "a cube");
  expect_framed(scene_of({{{1, 1, 1}}}, 100, 1000), 0, "a cube in a tall picture");
  expect_framed(scene_of({{{1, 1, 1}}}, 4000, 100), 0, "a cube in a wide picture");
  expect_framed(scene_of({{{5, 0.01, 0.01}}}), 0, "a rod across");
  expect_framed(scene_of({{{0.01, 5, 0.01}}}), 0, "a rod upright");
  expect_framed(scene_of({{{2, 3, 0}}}), 0, "a sheet");
}

TEST(Framing, ALongLattice) {
  LatticeSettings settings;
  settings.cells_x = settings.cells_y = 3;
  settings.cells_z = 20;
  settings.fineness = 1;
  settings.rod_radius = 0.03;
  Asset lattice = make_lattice(settings, false);
  Scene scene = scene_of({});
  scene.meshes = lattice.meshes;
  scene.materials.resize(2);
  Object object;
  for (const Part& part : lattice.parts) object.parts.push_back({part.mesh, part.asset_from_mesh});
  object.materials = {0, 1};
  for (const Vec3& beta : {Vec3(0), Vec3(0, 0, 0.9), Vec3(0, 0, -0.99)}) {
    object.worldline.velocity = Velocity::from_beta(beta);
    scene.objects = {object};
    expect_framed(scene, 0, "lattice");
  }
}

TEST(Framing, FlyersInEveryDirection) {
  for (const double speed : {0.5, 0.9, 0.99}) {
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
                                  Vec3(0, 0, -1), Vec3(0.6, 0, 0.8), Vec3(-0.36, 0.48, -0.8)}) {
      const std::string what = "at " + std::to_string(speed) + " along " +
                               std::to_string(direction.x) + " " + std::to_string(direction.y) +
                               " " + std::to_string(direction.z);
      expect_framed(scene_of({{{1, 1, 1}, {0, 0, 0}, 0, speed * direction}}), 0, what.c_str(),
                    // What comes fast is seen much further away a step further back.
                    speed > 0.95 ? 0.5L : 0.8L);
    }
  }
}

TEST(Framing, TwoObjects) {
  expect_framed(scene_of({{{1, 1, 1}, {-4, 0, 0}}, {{0.5, 0.5, 0.5}, {6, 1, -2}}}), 0, "at rest");
  expect_framed(
      scene_of({{{1, 1, 1}, {-4, 0, 0}, 0, {0.5, 0, 0}}, {{1, 1, 1}, {4, 0, 0}, 0, {0, 0, -0.8}}}),
      0, "of two velocities");
}

TEST(Framing, FarFromTheOriginAndLate) {
  expect_framed(scene_of({{{1, 1, 1}, {1e6, -2e6, 3e6}}}), 0, "far");
  expect_framed(scene_of({{{1, 1, 1}, {1e6, -2e6, 3e6}, 1e6, {0, 0, 0.9}}}), 0, "far and fast");
  expect_framed(scene_of({{{1, 1, 1}, {0, 0, 0}, -1e6, {0.9, 0, 0}}}), 0, "early");
  expect_framed(scene_of({{{1e6, 1e6, 1e6}}}), 0, "large");
  expect_framed(scene_of({{{1e-9, 1e-9, 1e-9}}}), 0, "small");
}

TEST(Framing, AtTheMomentThatIsAskedFor) {
  for (const double start : {-2.0, 0.0, 3.0}) {
    expect_framed(scene_of({{{1, 1, 1}, {0, 0, 0}, 0, {0.3, 0, 0}}}), start, "a flyer");
  }
}

TEST(Framing, ASceneWithoutAnythingToSeeStillHasACamera) {
  EXPECT_NO_THROW(pose_at(framing_camera(scene_of({}), 0), 0));
  Scene scene = scene_of({{}});
  scene.objects[0].parts.clear();
  EXPECT_NO_THROW(pose_at(framing_camera(scene, 0), 0));
}

}  // namespace
}  // namespace restframe
