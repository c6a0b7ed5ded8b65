// Faults of cameras that track, ride, follow keys or accelerate: place and words of each.

#include <gmock/gmock.h>

#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::string ship = "[[object]]\nname = \"ship\"\nsphere = {}\n";

// From line 2.
std::string free_camera(const std::string& lines) {
  return "[camera]\n" + lines + "\n" + ship;
}
// From line 3.
std::string placed(const std::string& lines) {
  return free_camera("position = [0, 0, 4]\n" + lines);
}
std::string key(double time, const std::string& lines) {
  return "[[camera.key]]\ntime = " + std::to_string(time) + "\n" + lines + "\n";
}

class BadCamera : public SceneReading {
 protected:
  // Exactly one fault, which begins with its place and has the other words.
  void expect(const std::string& text, const std::vector<std::string>& words) {
    const std::vector<std::string> lines = faults(text);
    ASSERT_THAT(lines, SizeIs(1)) << text;
    EXPECT_THAT(lines[0], ::testing::StartsWith(words.at(0))) << text;
    for (const std::string& word : words) EXPECT_THAT(lines[0], HasSubstr(word)) << text;
  }
};

TEST_F(BadCamera, Tracks) {
  expect(placed("track = \"shp\""),
         {"3:9: camera: ", "there is no object \"shp\", the nearest is \"ship\""});
  expect(placed("track = {object = \"shop\"}"),
         {"3:19: camera: track: ", "\"shop\", the nearest is \"ship\""});
  expect(placed("track = {point = [0, 0, 0]}"), {"3:9: camera: track: object is missing"});
  expect(placed("track = {object = \"ship\", pont = [0, 0, 0]}"),
         {"3:27: ", "\"pont\"", "\"point\""});
  expect(placed("track = {object = \"ship\", point = [0, 0]}"), {"3:35: ", "must have 3"});
  expect(placed("track = 3"), {"3:9: ", "track is a whole number, must be an object's name or"});
  expect(placed("track = \"ship\"\nlook_at = [0, 0, 0]"),
         {"4:1: ", "track and look_at exclude each other"});
  expect(placed("direction = [0, 0, 1]\ntrack = \"ship\""),
         {"4:1: ", "direction and track exclude each other"});
}

TEST_F(BadCamera, Rides) {
  expect(free_camera("on = \"shipp\""), {"2:6: ", "\"shipp\", the nearest is \"ship\""});
  expect(free_camera("on = 3"), {"2:6: ", "on is a whole number, must be a text"});
  expect(free_camera("on = \"ship\"\ntime = 3"), {"3:1: ", "on and time exclude each other"});
  expect(free_camera("velocity = [0, 0, 0]\non = \"ship\""),
         {"3:1: ", "velocity and on exclude each other"});
  expect(free_camera("on = \"ship\"\n[[camera.leg]]\nduration = 1\nacceleration = [0, 0, 1]"),
         {"3:", "on and leg exclude each other"});
  expect(free_camera("fov = 50"), {"1:1: ", "position is missing"});
}

TEST_F(BadCamera, KeysOutOfOrder) {
  expect(placed(key(1, "fov = 20") + key(0.5, "fov = 30")),
         {"7:8: camera: key 2: ", "time is 0.5, must be above that of the key before, 1"});
  expect(placed(key(1, "fov = 20") + key(1, "fov = 30")), {"7:8: ", "time is 1, must be above"});
  expect(placed("[[camera.key]]\nfov = 20"), {"3:1: camera: key 1: time is missing"});
  expect(placed("[[camera.key]]\ntime = nan"), {"4:8: ", "finite"});
  expect(placed(key(0, "fov = 0")), {"5:7: camera: key 1: fov is 0, must be above 0"});
  expect(placed(key(0, "fof = 20")), {"5:1: camera: key 1: unknown key \"fof\"", "\"fov\""});
  expect(placed("key = 3"), {"3:7: ", "key is a whole number, must be an array of tables"});
}

TEST_F(BadCamera, KeysPositions) {
  const std::string here = "position = [0, 0, 4]";
  expect(free_camera(key(0, here) + key(1, "")),
         {"5:1: camera: key 2: position is missing, the first key has it"});
  expect(placed(key(0, "") + key(1, here)),
         {"8:1: camera: key 2: position is not given by the first key"});
  expect(placed(key(0, here)), {"2:1: camera: position and keys with positions exclude"});
  expect(free_camera("velocity = [0, 0, 0.1]\n" + key(0, here)),
         {"2:1: camera: velocity and keys with positions exclude"});
  expect(free_camera("on = \"ship\"\n" + key(0, here)),
         {"2:1: camera: on and keys with positions exclude"});
  expect(free_camera(key(0, "position = [0, 0, 1e9]") + key(1, "position = [0, 1, 0]")),
         {"7:12: camera: key 2: ", "gamma is 1000000000"});
}

TEST_F(BadCamera, KeysVelocities) {
  const std::string here = "position = [0, 0, 4]\n", moving = here + "velocity = [0, 0, 0.5]";
  expect(free_camera(key(0, moving) + key(1, here)),
         {"6:1: camera: key 2: velocity is missing, the first key has it"});
  expect(free_camera(key(0, here) + key(1, moving)),
         {"9:1: camera: key 2: velocity is not given by the first key"});
  expect(placed(key(0, "velocity = [0, 0, 0.5]")), {"5:1: ", "velocity needs a position"});
  expect(free_camera(key(0, here + "velocity = [0, 0, 1]")), {"5:12: ", "|velocity| is 1"});
}

TEST_F(BadCamera, KeysAims) {
  expect(placed(key(0, "look_at = [0, 0, 0]") + key(1, "direction = [0, 0, -1]")),
         {"8:13: camera: key 2: its aim is a direction, that of the key before is a look_at"});
  expect(
      placed(key(0, "look_at = [0, 0, 0]") + key(1, "")),
      {"6:1: ", "its aim is a direction, the camera's own, that of the key before is a look_at"});
  expect(placed("track = \"ship\"\n" + key(0, "") + key(1, "look_at = [0, 0, 0]")),
         {"9:11: ", "its aim is a look_at, that of the key before is a track"});
  expect(placed(key(0, "direction = [0, 0, -1]") + key(1, "direction = [0, 0, 2]")),
         {"8:13: ", "direction is opposite to that of the key before"});
  expect(placed(key(0, "direction = [0, 3, 0]")), {"5:13: ", "direction is along up"});
  expect(placed(key(0, "track = \"shp\"")), {"5:9: camera: key 1: ", "\"ship\""});
  expect(placed(key(0, "look_at = [0, 0, 0]\ndirection = [0, 0, 1]")),
         {"6:1: ", "look_at and direction exclude"});
}

TEST_F(BadCamera, Legs) {
  const auto leg = [](const std::string& lines) { return placed("[[camera.leg]]\n" + lines); };
  const std::string forth = "acceleration = [0, 0, 1]\n";
  expect(leg(forth), {"3:1: camera: leg 1: duration is missing"});
  expect(leg("duration = 1"), {"3:1: camera: leg 1: acceleration is missing"});
  expect(leg(forth + "duration = 0"), {"5:12: camera: leg 1: duration is 0, must be above 0"});
  expect(leg(forth + "duration = -1"), {"5:12: ", "duration is -1"});
  expect(leg("duration = 1\nacceleration = [0, 0, inf]"), {"5:23: ", "finite"});
  expect(leg("duration = 30\nacceleration = [0, 0, 1]"),
         {"5:16: camera: leg 1: gamma is ", "at the end of this leg, must be at most 100000000"});
  expect(leg("duration = 1000\nacceleration = [0, 0, 1]"), {"5:16: ", "gamma is inf"});
  expect(leg(forth + "duration = 1\nacc = 3"), {"6:1: camera: leg 1: unknown key"});
  expect(placed(key(0, "") + "[[camera.leg]]\nduration = 1\n" + forth),
         {"6:", "key and leg exclude each other"});
}

}  // namespace
}  // namespace restframe
