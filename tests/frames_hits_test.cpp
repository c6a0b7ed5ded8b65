// Hits in rest frames: they do not depend on how a mesh is held, nor on the unit of length.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <optional>

#include "frames/frame_set.h"
#include "scene/generators.h"
#include "support/placed_triangles.h"
#include "tracer/surface.h"

namespace restframe {
namespace {

// The same ray in all lanes.
RayPacket rays_along(const Vec3& origin, const Vec3& direction, double time = 0) {
  RayPacket rays;
  for (int i = 0; i < packet_size; ++i) {
    rays.origin.set(i, {time, origin});
    rays.k.set(i, looking_along<in::World>(glm::normalize(direction)));
  }
  rays.s_min.fill(0);
  rays.active.fill(-1);
  return rays;
}

HitPacket refined_hits(const FrameSet& frames, const RayPacket& rays) {
  HitPacket hits;
  frames.nearest(rays, hits);
  for (int i = 0; i < packet_size; ++i) {
    if (hits.frame[i] >= 0) frames.refine(hits, i);
  }
  return hits;
}

struct Seen {
  double s = 0, clock = 0;
  Vec3 place{0};
  int object = -1;
  bool back = false;
};

std::optional<Seen> look(const Scene& scene, const Vec3& origin, const Vec3& direction,
                         double time = 0) {
  const FrameSet frames(scene, 1);
  const RayPacket rays = rays_along(origin, direction, time);
  const HitPacket hits = refined_hits(frames, rays);
  if (hits.frame[0] < 0) return std::nullopt;
  SurfaceLanes surfaces;
  surfaces_at(scene, frames, hits, rays.active, surfaces);
  const ObjectPlace place =
      object_places(scene, frames)[static_cast<std::size_t>(surfaces.object[0])];
  return Seen{hits.s[0], clock_at(place, hits, 0), position_on_object(frames, place, hits, 0),
              surfaces.object[0], surfaces.back[0] != 0};
}

// A part alone in its rest frame, one baked with another, and one of several instances.
std::array<Scene, 3> three_ways(const Mesh& mesh, const Object& object) {
  const Vec3 aside = object.worldline.reference.x + Vec3(500, 300, 100);
  Object other = object;
  other.worldline.reference.x = aside;
  Object another_mesh = other;
  another_mesh.parts = {{1, Mat4(1)}};
  return {scene_of({mesh}, {object}), scene_of({mesh, triangle()}, {object, another_mesh}),
          scene_of({mesh}, {object, other})};
}

TEST(Hits, DoNotDependOnHowAMeshIsHeld) {
  Object object = object_of(0, {0, 0, -6}, {0.1, -0.2, 0.7});
  object.worldline.reference.t = -6;  // its centre is seen there at time 0
  object.clock = 0.75;
  object.parts[0].object_from_mesh =
      glm::rotate(glm::scale(Mat4(1), Vec3(1.5)), 0.8, glm::normalize(Vec3(1, 2, 3)));
  const std::array<Scene, 3> scenes = three_ways(make_ball({1, 3}), object);
  for (const Vec3& direction : {Vec3(0, 0, -1), Vec3(0.02, 0.03, -1), Vec3(-0.05, 0.01, -1)}) {
    const auto alone = look(scenes[0], {0, 0, 0}, direction);
    ASSERT_TRUE(alone);
    EXPECT_NEAR(glm::length(alone->place), 1.5, 0.02);
    for (const std::size_t way : {1U, 2U}) {
      const auto seen = look(scenes[way], {0, 0, 0}, direction);
      ASSERT_TRUE(seen);
      EXPECT_EQ(seen->object, 0);
      // Corners are rounded to floats in coordinates that reach 600 light-seconds.
      EXPECT_NEAR(seen->s, alone->s, 1e-3);
      EXPECT_NEAR(seen->clock, alone->clock, 1e-3);
      EXPECT_LT(glm::length(seen->place - alone->place), 1e-3);
      EXPECT_FALSE(seen->back);
    }
  }
}

TEST(Hits, AHandComputedFlyer) {
  // A wall at z = 0 of its own moves with 0.6c towards the eye and is at z = -8 at time 0. Light that the eye
  // gets at time 0 left at t = -d where the wall was at -8 - 0.6 d: d = 20.
  Object wall = object_of(0, {-1, -1, -8}, {0, 0, 0.6});
  wall.clock = 3;
  const Scene scene = scene_of({triangle(Vec3f(0), 10)}, {wall});
  const auto seen = look(scene, {0, 0, 0}, {0, 0, -1});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->s, 20, 1e-12);
  // Its clock runs slow by 1.25: the event is at t = -20, and it shows 3 at t = 0.
  EXPECT_NEAR(seen->clock, 3 - 20 / 1.25, 1e-12);
  EXPECT_LT(glm::length(seen->place - Vec3(1, 1, 0)), 1e-12);
}

TEST(Hits, RaysThatAreNotFiniteFindNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Object object = object_of(0, {0, 0, -5}, {0, 0, 0.5});
  for (const Scene& scene : three_ways(make_ball({1, 2}), object)) {
    const FrameSet frames(scene, 1);
    for (const double bad : {nan, inf, -inf}) {
      RayPacket rays = rays_along({0, 0, 0}, {0, 0, -1});
      rays.origin.t[0] = bad;
      rays.origin.x.x[1] = bad;
      rays.origin.x.z[2] = bad;
      rays.k.x.y[3] = bad;
      rays.k.x.z[4] = bad;
      rays.k.t[5] = nan;
      const HitPacket hits = refined_hits(frames, rays);
      for (int lane = 1; lane < 6; ++lane) EXPECT_EQ(hits.frame[lane], -1) << bad << " " << lane;
      for (int lane = 6; lane < packet_size; ++lane) EXPECT_EQ(hits.frame[lane], 0);
    }
  }
}

TEST(Hits, LanesThatAreNotActiveFindNothing) {
  const Scene scene = scene_of({make_ball({1, 2})}, {object_of(0, {0, 0, -5})});
  const FrameSet frames(scene, 1);
  RayPacket rays = rays_along({0, 0, 0}, {0, 0, -1});
  for (int lane = 0; lane < packet_size; lane += 3) rays.active[lane] = 0;
  const HitPacket hits = refined_hits(frames, rays);
  for (int lane = 0; lane < packet_size; ++lane) {
    EXPECT_EQ(hits.frame[lane], lane % 3 == 0 ? -1 : 0) << lane;
  }
}

TEST(Hits, AMeshFarFromItsOriginIsHit) {
  const std::array<Scene, 3> scenes =
      three_ways(triangle({1e8F, 0, 0}, 64), object_of(0, {-1e8, 0, -5}));
  for (const std::size_t way : {0U, 2U}) {  // alone and as instances
    const auto seen = look(scenes[way], {8, 8, 0}, {0, 0, -1});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->s, 5, 1e-4);
  }
}

// Meshes of every size, seen at the same angle: what is seen does not depend on the unit of length, in
// whatever way the mesh is held.
TEST(Hits, DoNotDependOnTheScale) {
  for (const double scale : {1e-25, 1e-12, 1e-9, 1.0, 1e9, 1e25}) {
    Object object = object_of(0, {0, 0, -5 * scale}, {0, 0, 0.6});
    object.parts[0].object_from_mesh = glm::scale(Mat4(1), Vec3(scale));
    Object beside = object;
    beside.worldline.reference.x.x += 30 * scale;
    Object another_mesh = beside;
    another_mesh.parts[0].mesh = 1;
    const std::array<Scene, 3> scenes = {
        scene_of({make_ball({1, 3})}, {object}),
        scene_of({make_ball({1, 3}), make_ball({1, 2})}, {object, another_mesh}),
        scene_of({make_ball({1, 3})}, {object, beside})};
    for (const Scene& scene : scenes) {
      const auto seen = look(scene, Vec3(0), {0, 0, -1});
      ASSERT_TRUE(seen) << scale;
      // The front is at rest 1 from the centre: at -5 + 1/gamma = -4.2 at time 0, and seen 2.5 times as far.
      EXPECT_NEAR(seen->s / scale, 4.2 * 2.5, 0.03) << scale;
      EXPECT_FALSE(seen->back);
    }
  }
}

TEST(Hits, FrontAndBackOfAMirroredPlacement) {
  for (const double mirror : {1.0, -1.0}) {
    // Mirrored along x, the triangle's corners run clockwise, but its front stays its front.
    Object object = object_of(0, {0, 0, -5});
    object.parts[0].object_from_mesh = glm::scale(Mat4(1), Vec3(mirror, 1, 1));
    for (const Scene& scene : three_ways(triangle(Vec3f(-5), 20), object)) {
      const Vec3 eye(mirror, 1, 0);
      const auto front = look(scene, eye, {0, 0, -1});
      ASSERT_TRUE(front);
      EXPECT_FALSE(front->back) << mirror;
      const auto back = look(scene, eye + Vec3(0, 0, -20), {0, 0, 1});
      ASSERT_TRUE(back);
      EXPECT_TRUE(back->back) << mirror;
    }
  }
}

// Triangles one behind the other, all parallel.
Mesh sheets(int count, float distance) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) append(mesh, triangle({-8, -8, -distance * float(i)}, 64), 0);
  pad_for_embree(mesh);
  return mesh;
}

// How far along the ray each surface is.
std::vector<double> depths(const FrameSet& frames, RayPacket rays) {
  std::vector<double> found;
  while (found.size() < 100) {
    HitPacket hits = refined_hits(frames, rays);
    if (hits.frame[0] < 0) break;
    found.push_back(hits.s[0]);
    rays.s_min.fill(frames.frame(hits.frame[0]).s_behind(hits, 0));
  }
  return found;
}

TEST(Hits, BehindASurfaceTheNextOneIsFound) {
  constexpr int count = 10;
  for (const Scene& scene : three_ways(sheets(count, 0.125F), object_of(0, {0, 0, -5}))) {
    const FrameSet frames(scene, 1);
    for (const Vec3& direction : {Vec3(0, 0, -1), Vec3(0.3, 0.2, -1), Vec3(1, 0.5, -0.7)}) {
      const std::vector<double> found = depths(frames, rays_along({0, 0, 0}, direction));
      ASSERT_EQ(found.size(), static_cast<std::size_t>(count));
      const double slant = -glm::length(direction) / direction.z;
      for (int i = 0; i < count; ++i) {
        EXPECT_NEAR(found[static_cast<std::size_t>(i)], slant * (5 + 0.125 * i), 5e-4);
      }
    }
  }
}

}  // namespace
}  // namespace restframe
