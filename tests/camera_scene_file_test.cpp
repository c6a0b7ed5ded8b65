// Cameras of scene files that track, ride, follow keys or accelerate.

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Two lengths are a light-second.
const std::string ship = R"(
[scene]
light_speed = 2
[[object]]
name = "ship"
sphere = {}
position = [2, 4, 6]
time = 4
velocity = [0, 0, 0.6]
clock = 0.5
scale = 2
rotation = [0, 0, 90]
)";

void expect_near(const Vec3& a, const Vec3& b, double precision = 1e-14) {
  EXPECT_LT(glm::length(a - b), precision) << a.x << ' ' << a.y << ' ' << a.z;
}

class CameraFile : public SceneReading {
 protected:
  Camera camera(const std::string& lines) {
    const Scene scene = read("[camera]\n" + lines + ship);
    EXPECT_THAT(warnings, IsEmpty());
    return scene.camera;
  }
};

// (a, b, c) of the asset is (-b, a, c) lengths, as the ship is turned and doubled.
TEST_F(CameraFile, TracksAPointOfAnObject) {
  const Camera free =
      camera("position = [0, 0, 0]\ntrack = {object = \"ship\", point = [1, 2, 3]}\n");
  const AimTrack& aim = std::get<AimTrack>(free.aim);
  EXPECT_EQ(aim.name, "ship");
  EXPECT_EQ(aim.target.reference.t, 4);
  expect_near(aim.target.reference.x, Vec3(1 - 2, 2 + 1, 3 + 3 / 1.25));
  expect_near(aim.target.velocity.beta(), Vec3(0, 0, 0.6));
  EXPECT_FALSE(is_steady(free));
}

TEST_F(CameraFile, TracksAnObjectsOrigin) {
  const Camera free = camera("position = [0, 0, 0]\ntrack = \"ship\"\n");
  expect_near(std::get<AimTrack>(free.aim).target.reference.x, Vec3(1, 2, 3));
  const Camera same = camera("position = [0, 0, 0]\ntrack = {object = \"ship\"}\n");
  expect_near(std::get<AimTrack>(same.aim).target.reference.x, Vec3(1, 2, 3));
}

TEST_F(CameraFile, RidesAnObjectInItsCoordinatesAndByItsClock) {
  const Camera rider =
      camera("on = \"ship\"\nposition = [1, 0, 1]\ndirection = [0, 1, 0]\nup = [1, 0, 0]\n");
  const CameraPose pose = pose_at(rider, 0.5);
  // When the ship's clock shows 0.5 the event is the ship's reference moved by (0, 1, 1) in its
  // rest frame: gamma = 1.25.
  EXPECT_NEAR(pose.event.t, 4 + 0.75, 1e-14);
  expect_near(pose.event.x, Vec3(1, 3, 3 + 1.25));
  EXPECT_EQ(std::get<Worldline>(rider.motion).velocity, Velocity::from_beta({0, 0, 0.6}));
  expect_near(-pose.axes[2], Vec3(-1, 0, 0));
  expect_near(pose.axes[1], Vec3(0, 1, 0));
  EXPECT_TRUE(is_steady(rider));
}

TEST_F(CameraFile, RidesAtAnObjectsOriginByDefault) {
  expect_near(pose_at(camera("on = \"ship\"\n"), 0.5).event.x, Vec3(1, 2, 3));
}

TEST_F(CameraFile, RidesByTheFramesClock) {
  const Scene scene = read(
      "[camera]\non = \"a\"\n[[object]]\nname = \"a\"\nsphere = {}\nposition = [1, 2, 3]\n"
      "time = 4\nvelocity = [0, 0, 0.6]\nclock = \"frame\"\n");
  const CameraPose pose = pose_at(scene.camera, 1.25 * 4 - 0.75 * 3);
  EXPECT_NEAR(pose.event.t, 4, 1e-14);
  expect_near(pose.event.x, Vec3(1, 2, 3));
}

TEST_F(CameraFile, ARiderMayLookAtTheWorld) {
  const Camera rider = camera("on = \"ship\"\nposition = [1, 0, 1]\nlook_at = [0, 0, 100]\n");
  EXPECT_EQ(std::get<AimPoint>(rider.aim).point, Vec3(0, 0, 50));
  EXPECT_EQ(rider.up, Vec3(0, 1, 0)) << "the world's";
}

const std::string three_keys = R"(
[[camera.key]]
time = 1
position = [0, 0, 8]
look_at = [0, 0, 0]
fov = 60
[[camera.key]]
time = 3
position = [3, 0, 8]
look_at = [2, 4, 0]
fov = 40
[[camera.key]]
time = 4
position = [3, 0, 8]
look_at = [2, 4, 0]
fov = 40
)";

TEST_F(CameraFile, FollowsKeys) {
  const Camera keyed = camera("time = 10\n" + three_keys);
  // It rests until its clock shows 1; then 1.5 light-seconds in 2 s: gamma beta 0.75.
  const CameraPose pose = pose_at(keyed, 2);
  EXPECT_NEAR(pose.event.t, 10 + 1 + 1.25, 1e-14);
  expect_near(pose.event.x, Vec3(0.75, 0, 4));
  EXPECT_NEAR(pose.vertical_fov, 50 * std::numbers::pi / 180, 1e-15);
  expect_near(pose.world_from_camera.velocity().beta(), Vec3(-0.6, 0, 0));
  // The point at (0.5, 1, 0), aimed at where it is seen, is that of a camera of its own.
  Camera still;
  still.motion = Worldline{pose.event, Velocity::from_beta({0.6, 0, 0})};
  still.aim = AimPoint{{0.5, 1, 0}};
  expect_near(pose.axes[2], pose_at(still, 0).axes[2]);
  EXPECT_EQ(pose_at(keyed, -5).vertical_fov, pose_at(keyed, 1).vertical_fov);
  EXPECT_EQ(pose_at(keyed, 9).event.x, Vec3(1.5, 0, 4));
  EXPECT_NEAR(pose_at(keyed, 9).event.t, 10 + 1 + 2.5 + 6, 1e-13);
  EXPECT_FALSE(is_steady(keyed));
}

TEST_F(CameraFile, DirectionsOfKeysTurn) {
  const Camera keyed = camera(R"(position = [1, 2, 3]
[[camera.key]]
time = 0
direction = [0, 0, -1]
[[camera.key]]
time = 2
direction = [-1, 0, 0]
)");
  expect_near(-pose_at(keyed, 1).axes[2], Vec3(-1, 0, -1) / std::sqrt(2.0));
  expect_near(pose_at(keyed, 1).event.x, Vec3(0.5, 1, 1.5));
  EXPECT_FALSE(is_steady(keyed));
}

TEST_F(CameraFile, KeysOfPositionTakeTheCamerasAim) {
  const Camera keyed = camera(R"(track = "ship"
fov = 30
[[camera.key]]
time = 0
position = [0, 0, 8]
[[camera.key]]
time = 1
position = [0, 0, 7]
)");
  EXPECT_THAT(keyed.view_keys, IsEmpty());
  EXPECT_TRUE(std::holds_alternative<AimTrack>(keyed.aim));
  EXPECT_NEAR(pose_at(keyed, 0.5).vertical_fov, std::numbers::pi / 6, 1e-15);
}

TEST_F(CameraFile, AKeyMayTrackAnotherObject) {
  const Camera keyed = camera(R"(position = [0, 0, 0]
track = "ship"
[[camera.key]]
time = 0
fov = 30
[[camera.key]]
time = 1
track = {object = "ship", point = [0, 0, 3]}
)");
  ASSERT_THAT(keyed.view_keys, SizeIs(2));
  const auto seen = [&](double tau) { return -pose_at(keyed, tau).axes[2]; };
  Camera plain = keyed;
  plain.view_keys.clear();
  expect_near(seen(0.9), -pose_at(plain, 0.9).axes[2]);
  EXPECT_GT(glm::length(seen(1.0) + pose_at(plain, 1.0).axes[2]), 0.01);
}

TEST_F(CameraFile, KeysMayStateVelocities) {
  const Camera keyed = camera(R"([[camera.key]]
time = 0
position = [0, 0, 8]
velocity = [0, 0, -0.6]
[[camera.key]]
time = 2
position = [0, 0, 8]
velocity = [0, 0, -0.8]
)");
  expect_near(state_at(keyed.motion, 1).velocity.gamma_beta(), Vec3(0, 0, -0.5 * (0.75 + 4.0 / 3)));
  expect_near(state_at(keyed.motion, 1).event.x, Vec3(0, 0, 4));
}

TEST_F(CameraFile, ARiderMayTurnByKeys) {
  const Camera rider = camera(R"(on = "ship"
up = [0, 0, 1]
[[camera.key]]
time = 0
direction = [0, 1, 0]
[[camera.key]]
time = 2
direction = [1, 0, 0]
)");
  expect_near(-pose_at(rider, 0).axes[2], Vec3(-1, 0, 0));
  expect_near(-pose_at(rider, 1).axes[2], Vec3(-1, 1, 0) / std::sqrt(2.0));
  expect_near(-pose_at(rider, 2).axes[2], Vec3(0, 1, 0));
}

TEST_F(CameraFile, Accelerates) {
  const Camera observer = camera(R"(position = [0, 0, 4]
time = 3
velocity = [0, 0, 0.6]
[[camera.leg]]
duration = 2.0
acceleration = [0, 0, -0.5]
[[camera.leg]]
duration = 1
acceleration = [0, 0, 0]
)");
  const CameraState state = state_at(observer.motion, 3);
  EXPECT_NEAR(std::asinh(state.velocity.gamma_beta().z), std::atanh(0.6) - 1, 1e-14);
  EXPECT_NEAR(state_at(observer.motion, 0).event.t, 3, 1e-15);
  expect_near(state_at(observer.motion, 0).event.x, Vec3(0, 0, 2));
  EXPECT_FALSE(is_steady(observer));
}

TEST_F(CameraFile, AMeetingWithWhatItTracksNamesThePicture) {
  const std::vector<std::string> lines = faults(
      "[camera]\nposition = [0, 0, 0]\ntime = 4\ntrack = \"a\"\n[animation]\nrate = 1\n"
      "pictures = 9\n[[object]]\nname = \"a\"\nsphere = {}\nposition = [-3, 0, 0]\n"
      "velocity = [0.5, 0, 0]\n");
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_THAT(lines[0], HasSubstr("picture 2: camera: it meets \"a\""));
}

}  // namespace
}  // namespace restframe
