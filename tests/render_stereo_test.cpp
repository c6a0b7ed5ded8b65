// Two eyes: where each sees what, against closed forms, at rest and at speed.

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/direct_render.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

constexpr int kWidth = 24, kHeight = 16;
constexpr double kHalfHeight = 0.57735026918962576;  // of a field of view of 60 degrees
constexpr double kSeparation = 0.4, kWall = 8;

class Stereo : public SceneReading {
 protected:
  Stereo() {
    folder.write("wall.obj", "v -90 -90 0\nv 90 -90 0\nv 90 90 0\nv -90 90 0\nf 1 2 3 4\n");
  }

  std::vector<Picture> views(const std::string& text) {
    const Scene scene = read(text);
    const FrameSet frames(scene, thread_count());
    const Integrator integrator = make_integrator(scene, frames);
    EvaluatorPool evaluators(scene.functions);
    std::vector<Picture> pictures = blank_views(scene);
    render_views({scene, integrator, evaluators, {}}, 0, pictures);
    return pictures;
  }

  // Of a wall across the view, 8 ahead at world time 0.
  std::vector<Picture> wall(const std::string& camera, const std::string& stereo,
                            const std::string& velocity) {
    return views("[camera]\nposition = [0, 0, 0]\n" + camera +
                 "[camera.stereo]\nseparation = 0.4\n" + stereo +
                 "[render]\nresolution = [24, 16]\nsamples = 1\n"
                 "[output]\nlayers = [\"P\", \"Z\"]\n"
                 "[[object]]\nasset = \"wall.obj\"\nposition = [0, 0, -8]\n" +
                 velocity);
  }
};

// Tangents, to the right and up, through a pixel's centre of a film that is not shifted.
double tan_x(int x) {
  return kHalfHeight * ((2 * x + 1.0) / kHeight - 1.0 * kWidth / kHeight);
}
double tan_y(int y) {
  return kHalfHeight * (1 - (2 * y + 1.0) / kHeight);
}

// The wall's own x that the left eye (side -1) or the right one (1) sees: `seen` tells it from the
// eye's x, and the direction, the camera's.
template <class Seen>
void expect_seen(const std::vector<Picture>& views, double convergence, const Seen& seen) {
  ASSERT_EQ(views.size(), 2U);
  for (const int side : {-1, 1}) {
    const double eye = 0.5 * side * kSeparation;
    const double shift = convergence > 0 ? -eye / convergence : 0.0;
    const auto x_of = channel_of(views[side < 0 ? 0 : 1], "P.X");
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Vec3 d = glm::normalize(Vec3(tan_x(x) + shift, tan_y(y), -1));
        const double expected = seen(eye, d);
        EXPECT_NEAR(x_of[static_cast<std::size_t>(y * kWidth + x)], expected,
                    2e-5 * (1 + std::abs(expected)))
            << side << " at " << x << " " << y;
      }
    }
  }
}

TEST_F(Stereo, EyesAtRest) {
  const auto seen = [](double eye, const Vec3& d) { return eye + kWall * d.x / -d.z; };
  expect_seen(wall("", "", ""), 0, seen);
  expect_seen(wall("", "convergence = 5\n", ""), 5, seen);
}

// At the distance of convergence both see the same at the same place of their films; elsewhere what is
// seen lies separation (1 / distance - 1 / convergence) apart, left eye's minus right eye's.
TEST_F(Stereo, ParallaxIsZeroWhereTheyConverge) {
  const auto same = wall("", "convergence = 8\n", "");
  const auto left = channel_of(same[0], "P.X"), right = channel_of(same[1], "P.X");
  for (std::size_t i = 0; i < left.size(); ++i) EXPECT_NEAR(left[i], right[i], 1e-5);
  for (const double convergence : {5.0, 20.0}) {
    const auto apart = wall("", "convergence = " + std::to_string(convergence) + "\n", "");
    const double pixel = 2 * kHalfHeight / kHeight * kWall;  // on the wall
    const double disparity =
        (channel_of(apart[1], "P.X")[100] - channel_of(apart[0], "P.X")[100]) / pixel;
    const double tangents = kSeparation * (1 / kWall - 1 / convergence);
    EXPECT_NEAR(disparity, tangents * kHeight / (2 * kHalfHeight), 1e-4) << convergence;
  }
}

// A wall that moves to the right at beta is seen a distance r away as it was r ago, in coordinates that
// are longer by gamma: x = gamma (x_seen + beta r).
TEST_F(Stereo, EyesBeforeAWallThatMovesAcross) {
  const double beta = 0.8, gamma = 1 / 0.6;
  expect_seen(wall("", "convergence = 5\n", "velocity = [0.8, 0, 0]\n"), 5,
              [&](double eye, const Vec3& d) {
                const double r = kWall / -d.z;
                return gamma * (eye + r * d.x + beta * r);
              });
}

// The eyes of a camera that moves to the right at beta open at the same time of its own: at x' in its
// frame, r ago, is x = gamma (x' - beta r) in the world's, where the wall rests.
TEST_F(Stereo, EyesThatMoveAcross) {
  const double beta = 0.8, gamma = 1 / 0.6;
  expect_seen(wall("velocity = [0.8, 0, 0]\n", "convergence = 5\n", ""), 5,
              [&](double eye, const Vec3& d) {
                const double r = kWall / -d.z;
                return gamma * (eye + r * d.x - beta * r);
              });
}

// Of what comes at beta, and would be 8 ahead when its light arrives, the distance r has
// r (-d_z - beta) = 8.
TEST_F(Stereo, EyesBeforeAWallThatComes) {
  expect_seen(wall("", "convergence = 5\n", "velocity = [0, 0, 0.6]\n"), 5,
              [](double eye, const Vec3& d) { return eye + kWall / (-d.z - 0.6) * d.x; });
}

TEST_F(Stereo, EyesOfEveryKindOfCameraStandApartAcrossItsView) {
  const std::string rest =
      "[camera.stereo]\nseparation = 0.5\n[[object]]\nname = \"ship\"\nsphere = {}\n"
      "position = [3, 0, -9]\nvelocity = [0.3, 0.1, 0.6]\nrotation = [0, 30, 0]\n";
  for (const std::string camera :
       {"position = [1, 2, 3]\nlook_at = [4, 4, 4]\n",
        "position = [1, 2, 3]\nvelocity = [0.5, 0, 0.5]\ntrack = \"ship\"\n",
        "on = \"ship\"\nposition = [0, 2, 0]\ndirection = [1, 0, -1]\n",
        "look_at = [0, 0, 0]\n[[camera.key]]\ntime = 0\nposition = [0, 0, 12]\n"
        "[[camera.key]]\ntime = 3\nposition = [0, 1, 3]\n",
        "position = [0, 0, 2]\n[[camera.leg]]\nduration = 1\nacceleration = [0, 0, 1]\n"}) {
    SCOPED_TRACE(camera);
    const Scene scene = read("[camera]\n" + camera + rest);
    const CameraPose centre = pose_at(scene.camera, 0.7),
                     left = pose_at(scene.camera, 0.7, Eye::left),
                     right = pose_at(scene.camera, 0.7, Eye::right);
    const Displacement<in::Camera> apart =
        centre.world_from_camera.inverse()(right.event - left.event);
    EXPECT_NEAR(apart.t, 0, 1e-12);
    EXPECT_LT(glm::length(apart.x - 0.5 * centre.axes[0]), 1e-12);
    const Displacement<in::Camera> to_left =
        centre.world_from_camera.inverse()(left.event - centre.event);
    EXPECT_LT(glm::length(to_left.x + 0.25 * centre.axes[0]), 1e-12);
    EXPECT_EQ(right.axes, centre.axes);
    EXPECT_EQ(right.film_shift, 0);
  }
}

TEST_F(Stereo, LensesFocusForBothEyes) {
  // What is sharp stays so under any aperture: the wall's edge between two objects.
  const std::string text =
      "[camera]\nposition = [0, 0, 0]\nAPERTURE[camera.stereo]\nseparation = 0.4\nconvergence = 5\n"
      "[render]\nresolution = [24, 16]\nsamples = 4\n[output]\nlayers = [\"beauty\"]\n"
      "[[object]]\nasset = \"wall.obj\"\nposition = [91, 0, -8]\nmaterial = \"red\"\n"
      "[[object]]\nasset = \"wall.obj\"\nposition = [-89, 0, -8]\nmaterial = \"blue\"\n"
      "[[material]]\nname = \"red\"\nunlit = true\nbase_color = \"red\"\n"
      "[[material]]\nname = \"blue\"\nunlit = true\nbase_color = \"blue\"\n";
  const auto with = [&](const std::string& aperture) {
    std::string changed = text;
    return views(changed.replace(changed.find("APERTURE"), 8, aperture));
  };
  const auto sharp = with(""), open = with("aperture = 0.3\nfocus = 8\n");
  for (std::size_t eye = 0; eye < 2; ++eye) {
    for (std::size_t i = 0; i < sharp[eye].rgba().size(); ++i) {
      EXPECT_NEAR(sharp[eye].rgba()[i].x, open[eye].rgba()[i].x, 1e-5) << eye << " " << i;
    }
  }
}

TEST_F(Stereo, FaultsAreTold) {
  using testing::ElementsAre;
  using testing::HasSubstr;
  const auto with = [&](const std::string& stereo) {
    return faults("[camera]\nposition = [0, 0, 5]\n[camera.stereo]\n" + stereo +
                  "\n[[object]]\nsphere = {}\n");
  };
  EXPECT_THAT(with(""), ElementsAre(HasSubstr("separation is missing")));
  EXPECT_THAT(with("separation = -1"), ElementsAre(HasSubstr("4:14: camera: stereo: separation")));
  EXPECT_THAT(with("separation = 1\nconvergence = -5"),
              ElementsAre(HasSubstr("convergence is -5")));
  EXPECT_THAT(with("separation = 1\nconvergance = 5"), ElementsAre(HasSubstr("\"convergence\"")));
  EXPECT_THAT(with("separation = 1"), ElementsAre());
}

}  // namespace
}  // namespace restframe
