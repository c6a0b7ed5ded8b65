// Packets of rays that begin anywhere and go anywhere, as bounces and shadow rays do: they come back,
// and each finds what it finds alone.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "frames/frame_set.h"
#include "scene/generators.h"

namespace restframe {
namespace {

Object sphere_at(const Vec3& position, double scale, const Vec3& velocity = Vec3(0)) {
  Object object;
  object.worldline = {{0, position}, Velocity::from_beta(velocity)};
  object.parts = {{0, Mat4(scale)}};
  object.parts[0].object_from_mesh[3].w = 1;
  object.materials = {0};
  return object;
}

// A floor as large as a planet beside what stands on it, and something fast.
Scene floor_and_spheres() {
  Scene scene;
  scene.meshes = {make_ball({1, 5})};
  scene.materials.emplace_back();
  scene.objects = {sphere_at({0, -1000.5, -3}, 1000), sphere_at({-1.2, 0.4, 0}, 0.7),
                   sphere_at({0.6, 0.4, 0.8}, 0.7), sphere_at({-5, 0.2, -1.5}, 0.5, {0.9, 0, 0})};
  return scene;
}

using Random = std::mt19937;

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

// Origins near the floor, some of them on it; directions of any octant, or all of one.
RayPacket random_packet(Random& random, bool one_octant) {
  RayPacket rays;
  rays.coherent = false;
  for (int i = 0; i < packet_size; ++i) {
    const bool on_floor = uniform(random, 0, 1) < 0.5;
    const Vec3 origin(uniform(random, -3, 3), on_floor ? -0.5 : uniform(random, -0.5, 4),
                      uniform(random, -6, 3));
    Vec3 direction(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    if (one_octant) direction = glm::abs(direction);
    rays.origin.set(i, {0, origin});
    rays.k.set(i, looking_along<in::World>(glm::normalize(direction)));
    rays.s_min[i] = on_floor ? 1e-4 : 0;
    rays.active[i] = uniform(random, 0, 1) < 0.8 ? -1 : 0;
  }
  return rays;
}

void expect_alone_as_together(const FrameSet& frames, const RayPacket& rays, int lane) {
  HitPacket together, alone;
  Lanes<double> s_max;
  Lanes<std::int32_t> blocked, blocked_alone;
  for (int i = 0; i < packet_size; ++i) s_max[i] = 0.3 * (i + 1);
  RayPacket one = rays;
  one.active.fill(0);
  one.active[lane] = rays.active[lane];
  frames.nearest(rays, together);
  frames.nearest(one, alone);
  frames.find_blocked(rays, s_max, blocked);
  frames.find_blocked(one, s_max, blocked_alone);
  EXPECT_EQ(together.frame[lane], alone.frame[lane]);
  EXPECT_EQ(blocked[lane], blocked_alone[lane]);
  if (alone.frame[lane] < 0) return;
  EXPECT_NEAR(together.s[lane], alone.s[lane], 1e-3 * (1 + alone.s[lane]));
}

TEST(IncoherentPackets, ComeBackWithWhatEachRayFindsAlone) {
  const Scene scene = floor_and_spheres();
  const FrameSet frames(scene, 1);
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const RayPacket rays = random_packet(random, i % 2 == 0);
    expect_alone_as_together(frames, rays, i % packet_size);
    ASSERT_FALSE(HasFailure()) << "packet " << i;
  }
}

}  // namespace
}  // namespace restframe
