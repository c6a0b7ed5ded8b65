// The layers `depth` and `normal`: what the camera sees as a shape, whatever moves.

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/direct_render.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

constexpr int kWidth = 24, kHeight = 16;
constexpr double kFov = 20;

class Apparent : public SceneReading {
 protected:
  // A wall of the width 80 around the origin of its coordinates, across z.
  Apparent() {
    folder.write("wall.obj", "v -40 -40 0\nv 40 -40 0\nv 40 40 0\nv -40 40 0\nf 1 2 3 4\n");
  }

  Picture picture(const std::string& camera, const std::string& wall,
                  const std::string& render = "") {
    const std::string text = "[camera]\nfov = 20\n" + camera +
                             "[render]\nresolution = [24, 16]\nsamples = 1\n" + render +
                             "[output]\nlayers = [\"Z\", \"depth\", \"normal\"]\n"
                             "[[object]]\nasset = \"wall.obj\"\n" +
                             wall;
    return first_picture(read(text));
  }
};

// Unit direction through a pixel's centre, in the camera's axes.
Vec3 sight(int x, int y) {
  const double half_height = std::tan(0.5 * kFov * std::numbers::pi / 180);
  const double up = half_height * (1 - (2 * y + 1.0) / kHeight);
  const double right = half_height * ((2 * x + 1.0) / kHeight - 1.0 * kWidth / kHeight);
  return glm::normalize(Vec3(right, up, -1));
}

struct Seen {
  std::vector<double> distance, depth, x, y, z;
  explicit Seen(const Picture& picture)
      : distance(channel_of(picture, "Z")),
        depth(channel_of(picture, "depth_planar.Z")),
        x(channel_of(picture, "normal.X")),
        y(channel_of(picture, "normal.Y")),
        z(channel_of(picture, "normal.Z")) {}

  static std::size_t at(int px, int py) { return static_cast<std::size_t>(py * kWidth + px); }
  Vec3 normal(int px, int py) const { return {x[at(px, py)], y[at(px, py)], z[at(px, py)]}; }
  Vec3 point(int px, int py) const { return distance[at(px, py)] * sight(px, py); }
};

// Differences of the points that neighbouring pixels see, each in error by the second order of a
// pixel's angle, 0.02.
void expect_shape(const Seen& seen) {
  int compared = 0;
  for (int y = 1; y + 1 < kHeight; ++y) {
    for (int x = 1; x + 1 < kWidth; ++x) {
      const Vec3 right = seen.point(x + 1, y) - seen.point(x - 1, y);
      const Vec3 up = seen.point(x, y - 1) - seen.point(x, y + 1);
      if (!(glm::length(right) + glm::length(up) < 100)) continue;  // some see nothing
      const Vec3 across = glm::normalize(glm::cross(right, up));
      const Vec3 expected = glm::dot(across, sight(x, y)) < 0 ? across : -across;
      EXPECT_LT(glm::length(seen.normal(x, y) - expected), 2e-3) << x << " " << y;
      EXPECT_NEAR(glm::length(seen.normal(x, y)), 1, 1e-6);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

TEST_F(Apparent, NormalIsThatOfTheSeenShape) {
  const std::string camera =
      "position = [0.5, 0.2, 6]\nvelocity = [0.2, -0.3, -0.4]\nlook_at = [0, 0, 0]\n";
  for (const char* wall :
       {"position = [0, 0, 0]\nrotation = [20, 30, 0]\n",
        "position = [0, 0, 0]\nrotation = [20, 30, 0]\nvelocity = [0.3, 0.5, -0.6]\n",
        "position = [0, 0, 0]\nrotation = [-20, 10, 0]\nvelocity = [0.9, 0.1, 0]\n",
        "position = [0, 0, 0]\nrotation = [10, -40, 0]\nvelocity = [0, -0.7, 0.5]\n"}) {
    SCOPED_TRACE(wall);
    expect_shape(Seen(picture(camera, wall)));
    expect_shape(Seen(picture(camera, wall, "integrator = \"path\"\n")));
  }
}

// A wall that comes along z at beta and would reach z = -h as light from it arrives is seen, in the
// direction d, where it was at -r: -h - beta r = r d_z. So F = z + beta r is constant on what is seen,
// and its normal is z + beta d.
TEST_F(Apparent, NormalOfAWallThatComesHeadOn) {
  for (const double beta : {0.0, 0.6, -0.6, -0.999999}) {
    const Seen seen(picture("position = [0, 0, 0]\n", "position = [0, 0, -4]\nvelocity = [0, 0, " +
                                                          std::to_string(beta) + "]\n"));
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Vec3 d = sight(x, y);
        const double distance = 4 / (-d.z - beta);
        EXPECT_NEAR(seen.distance[Seen::at(x, y)], distance, 1e-5 * distance);
        EXPECT_NEAR(seen.depth[Seen::at(x, y)], -d.z * distance, 1e-5 * distance);
        const Vec3 expected = glm::normalize(Vec3(0, 0, 1) + beta * d);
        EXPECT_LT(glm::length(seen.normal(x, y) - expected), 2e-6) << beta << " " << x << " " << y;
      }
    }
  }
}

// Each row is seen by a camera of its own.
TEST_F(Apparent, NormalIsInTheAxesOfEachRowsMoment) {
  const std::string turning =
      "position = [0, 0, 6]\nrolling = 1\n"
      "[[camera.key]]\ntime = 0\ndirection = [0, 0, -1]\n"
      "[[camera.key]]\ntime = 1\ndirection = [1, 0, -1]\n";
  const Seen seen(picture(turning, "position = [0, 0, 0]\n"));
  for (const int y : {0, 8, 15}) {
    const double fraction = (y + 0.5) / kHeight;
    const Vec3 last = glm::normalize(Vec3(1, 0, -1));
    const Vec3 back = -glm::normalize(glm::mix(Vec3(0, 0, -1), last, fraction));
    const Vec3 right = glm::normalize(glm::cross(Vec3(0, 1, 0), back));
    const Vec3 expected(right.z, 0, back.z);
    EXPECT_LT(glm::length(seen.normal(12, y) - expected), 1e-6) << y;
  }
}

TEST_F(Apparent, WhereNothingIsSeen) {
  const Seen seen(picture("position = [0, 0, 6]\ndirection = [0, 0, 1]\n", ""));
  EXPECT_EQ(seen.depth[0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(seen.normal(0, 0), Vec3(0));
}

}  // namespace
}  // namespace restframe
