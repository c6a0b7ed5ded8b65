// [exposure], and [camera]'s lens and rolling rows: what they mean and what is refused.

#include <gmock/gmock.h>

#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

const std::string ball = "[[object]]\nsphere = {}\n";
std::string in_exposure(const std::string& lines) {
  return "[exposure]\n" + lines + "\n" + ball;
}
std::string in_camera(const std::string& lines) {
  return "[camera]\nposition = [0, 0, 4]\n" + lines + "\n" + ball;
}

class ExposureKeys : public SceneReading {
 protected:
  void refuses(const std::string& text, const std::string& where, const std::string& words) {
    const std::vector<std::string> lines = faults(text);
    EXPECT_THAT(lines, SizeIs(1)) << text;
    if (lines.empty()) return;
    EXPECT_THAT(lines[0], StartsWith(where));
    EXPECT_THAT(lines[0], HasSubstr(words));
  }
};

TEST_F(ExposureKeys, AreOneInstantByDefault) {
  const ExposureSettings settings = read(ball).exposure;
  EXPECT_EQ(settings.shutter, 0);
  EXPECT_EQ(settings.count, 1);
  EXPECT_EQ(settings.combine, Combine::sum);
}

TEST_F(ExposureKeys, AreRead) {
  const ExposureSettings settings =
      read(in_exposure("shutter = 9\nopening = \"triangle\"\ncount = 7\ninterval = 0.25\n"
                       "combine = \"max\""))
          .exposure;
  EXPECT_EQ(settings.shutter, 9);  // longer than the interval and than a picture's: allowed
  EXPECT_EQ(settings.shape, ShutterShape::triangle);
  EXPECT_EQ(settings.count, 7);
  EXPECT_EQ(settings.interval, 0.25);
  EXPECT_EQ(settings.combine, Combine::max);
}

TEST_F(ExposureKeys, TakeCurves) {
  const ExposureSettings settings =
      read(in_exposure("opening = [[0, 0.0], [0.3, 1], [0.3, 2], [1.0, 0]]")).exposure;
  EXPECT_EQ(settings.shape, ShutterShape::curve);
  EXPECT_EQ(settings.curve, (ShutterCurve{{0, 0}, {0.3, 1}, {0.3, 2}, {1, 0}}));
}

TEST_F(ExposureKeys, RefuseWhatMeansNothing) {
  refuses(in_exposure("shutter = -1"), "2:11: ", "shutter is -1, must be at least 0");
  refuses(in_exposure("shutter = nan"), "2:11: ", "finite");
  refuses(in_exposure("count = 0"), "2:9: ", "count is 0, must be from 1 to 65536");
  refuses(in_exposure("count = 65537"), "2:9: ", "must be from 1 to 65536");
  refuses(in_exposure("interval = -0.5"), "2:12: ", "interval is -0.5, must be at least 0");
  refuses(in_exposure("count = 2\ninterval = 0"), "3:12: ", "must be above 0 with count = 2");
  refuses(in_exposure("combine = \"add\""), "2:11: ", "nearest");
  refuses(in_exposure("opening = \"boxy\""), "2:11: ", "\"box\"");
  refuses(in_exposure("opening = 3"), "2:11: ", "\"triangle\"");
  refuses(in_exposure("shuter = 1"), "2:1: ", "\"shutter\"");
}

TEST_F(ExposureKeys, RefuseBrokenCurves) {
  refuses(in_exposure("opening = []"), "2:11: ", "never open");
  refuses(in_exposure("opening = [[0, 1]]"), "2:11: ", "never open");
  refuses(in_exposure("opening = [[0, 0], [1, 0]]"), "2:11: ", "never open");
  refuses(in_exposure("opening = [[0, 1], [0.5]]"), "2:20: ", "[fraction");
  refuses(in_exposure("opening = [[0, 1], 2]"), "2:20: ", "[fraction");
  refuses(in_exposure("opening = [[0, 1], [1.5, 1]]"), "2:21: ", "is 1.5, must be from 0 to 1");
  refuses(in_exposure("opening = [[0, 1], [1, -1]]"), "2:24: ", "openness is -1");
  refuses(in_exposure("opening = [[0.5, 1], [0.25, 1]]"), "2:11: ", "0.25 is out of place");
}

TEST_F(ExposureKeys, OfTheLensAreLengthsOfTheScene) {
  const Camera camera =
      read("[scene]\nlight_speed = 2\n" + in_camera("aperture = 0.5\nfocus = 3\nrolling = 0.02"))
          .camera;
  EXPECT_EQ(camera.aperture, 0.25);
  EXPECT_EQ(camera.focus, 1.5);
  EXPECT_EQ(camera.rolling, 0.02);
  EXPECT_EQ(read(in_camera("focus = 3")).camera.aperture, 0);
}

TEST_F(ExposureKeys, RefuseLensesThatAreNone) {
  refuses(in_camera("aperture = -1"), "3:12: ", "aperture is -1, must be at least 0");
  refuses(in_camera("aperture = 1"), "3:12: ", "aperture needs focus");
  refuses(in_camera("aperture = 1\nfocus = 0"), "4:9: ", "focus is 0, must be above 0");
  refuses(in_camera("rolling = -0.1"), "3:11: ", "rolling is -0.1, must be at least 0");
}

}  // namespace
}  // namespace restframe
