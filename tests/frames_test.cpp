// Rest frames: how objects are grouped, and what their clocks show.

#include <gtest/gtest.h>

#include <cmath>

#include "frames/frame_set.h"
#include "support/placed_triangles.h"

namespace restframe {
namespace {

std::size_t frame_count(const std::vector<Vec3>& betas) {
  std::vector<Object> objects;
  for (const Vec3& beta : betas) objects.push_back(object_of(0, Vec3(0), beta));
  const Scene scene = scene_of({triangle()}, objects);
  return FrameSet(scene, 1).frames().size();
}

TEST(FrameSet, EqualVelocitiesShareARestFrame) {
  EXPECT_EQ(frame_count({}), 0U);
  EXPECT_EQ(frame_count({{0, 0, 0.5}, {0, 0, 0.5}, {0, 0, 0.5}}), 1U);
  EXPECT_EQ(frame_count({{0, 0, 0.5}, {0, 0, std::nextafter(0.5, 1)}}), 2U);
  EXPECT_EQ(frame_count({{0, 0, 0}, {0, 0, -0.0}}), 1U);
  EXPECT_EQ(frame_count({{0.1, 0, 0}, {0, 0.1, 0}, {0.1, 0, 0}, {0, 0, 0}}), 3U);
}

TEST(FrameSet, ObjectsWithoutMeshesMakeNoRestFrame) {
  Scene scene = scene_of({triangle()}, {object_of(0, Vec3(0)), object_of(0, Vec3(0), {0, 0, 0.5})});
  scene.objects[1].parts.clear();
  EXPECT_EQ(FrameSet(scene, 1).frames().size(), 1U);
}

Object sized(double size, const Vec3& position) {
  Object object = object_of(0, position);
  object.parts[0].object_from_mesh = glm::dmat4(glm::dmat3(size));
  return object;
}

TEST(FrameSet, SizesThatFloatsDoNotSpanAreKeptApart) {
  const auto count = [](const std::vector<Object>& objects) {
    const Scene scene = scene_of({triangle()}, objects);
    return FrameSet(scene, 1).frames().size();
  };
  const Object large = sized(1e8, Vec3(0)), small = sized(1, Vec3(0)), far = sized(1, Vec3(1e8));
  EXPECT_EQ(count({sized(1e4, Vec3(0)), small, sized(1, Vec3(1e4))}), 1U);
  EXPECT_EQ(count({large, small}), 2U);
  EXPECT_EQ(count({small, large, small, sized(2, Vec3(10)), sized(1e8, Vec3(1e7))}), 2U);
  EXPECT_EQ(count({large, small, far}), 3U);
  EXPECT_EQ(count({small, far}), 2U);
}

TEST(FrameSet, ALonePartTraversesItsMeshesScene) {
  const Scene scene =
      scene_of({triangle()}, {object_of(0, Vec3(0)), object_of(0, Vec3(0), {0, 0, 0.5})});
  const FrameSet frames(scene, 1);
  ASSERT_EQ(frames.frames().size(), 2U);
  EXPECT_EQ(frames.frame(0).traversed(), frames.frame(1).traversed());
  EXPECT_NE(frames.frame(0).traversed(), nullptr);
}

// The object's clock at the camera's ray, by the textbook: it shows `clock` at its reference event.
TEST(Clocks, OneUnitApartAtNinetyNinePercent) {
  // Two objects one light-second apart along the motion, both given time 0: their clocks differ by gamma beta
  // = 7.02 s in their rest frame.
  std::vector<Object> objects = {object_of(0, {0, 0, 0}, {0, 0, 0.99}),
                                 object_of(0, {0, 0, 1}, {0, 0, 0.99})};
  const Scene scene = scene_of({triangle()}, objects);
  const FrameSet frames(scene, 1);
  ASSERT_EQ(frames.frames().size(), 1U);
  const RestFrame& frame = frames.frame(0);
  const double difference =
      frame.clock_at_anchor(scene.objects[1]) - frame.clock_at_anchor(scene.objects[0]);
  EXPECT_NEAR(difference, 7.0179, 1e-4);
  EXPECT_NEAR(difference, 0.99 / std::sqrt(1 - 0.99 * 0.99), 1e-12);
}

TEST(Clocks, AreSetByTheirReferenceEvents) {
  std::vector<Object> objects = {object_of(0, {3, 0, 1}, {0.6, 0, 0}),
                                 object_of(0, {-2, 5, 4}, {0.6, 0, 0})};
  objects[0].worldline.reference.t = 10;
  objects[0].clock = 2;
  objects[1].worldline.reference.t = 20;
  objects[1].clock = -7;
  const Scene scene = scene_of({triangle()}, objects);
  const FrameSet frames(scene, 1);
  const RestFrame& frame = frames.frame(0);
  for (const Object& object : scene.objects) {
    const double at_reference = frame.coordinates()(object.worldline.reference).t;
    EXPECT_NEAR(frame.clock_at_anchor(object) + at_reference, object.clock, 1e-13);
  }
  // t' = 1.25 (dt - 0.6 dx) between the two events.
  EXPECT_NEAR(frame.clock_at_anchor(scene.objects[0]) - frame.clock_at_anchor(scene.objects[1]),
              (2 + 7) + 1.25 * (10 - 0.6 * -5), 1e-13);
}

TEST(Clocks, FrameClocksAreZeroAtTheWorldsOriginEvent) {
  std::vector<Object> objects = {object_of(0, {3, 0, 1}, {0.6, 0, 0}),
                                 object_of(0, {-2, 5, 4}, {0.6, 0, 0})};
  for (Object& object : objects) object.frame_clock = true;
  objects[0].worldline.reference.t = 10;
  objects[0].clock = 99;  // means nothing to a frame clock
  const Scene scene = scene_of({triangle()}, objects);
  const FrameSet frames(scene, 1);
  const RestFrame& frame = frames.frame(0);
  for (const Object& object : scene.objects) {
    // The anchor is the first one's reference event: t' = 1.25 (10 - 0.6 * 3).
    EXPECT_NEAR(frame.clock_at_anchor(object), 1.25 * (10 - 0.6 * 3), 1e-13);
    EXPECT_NEAR(frame.clock_at_anchor(object) + frame.coordinates()(Event<in::World>{}).t, 0,
                1e-13);
  }
}

}  // namespace
}  // namespace restframe
