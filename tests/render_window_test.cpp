// Crops and overscan: which part of a picture is rendered changes none of its pixels.

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

#include "support/direct_render.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

constexpr int kWidth = 22, kHeight = 18;  // no multiples of a block

class Window : public SceneReading {
 protected:
  Scene scene(const std::string& render) {
    return read(R"(
[camera]
position = [0, 0, 4]
velocity = [0.1, 0, -0.3]
direction = [0, 0, -1]
[render]
resolution = [22, 18]
samples = 6
)" + render + R"(
[exposure]
shutter = 0.2
[output]
layers = ["beauty", "Z", "depth", "N", "normal", "P", "time", "doppler", "id", "samples"]
[[object]]
sphere = {radius = 1.2, fineness = 2}
velocity = [0.5, 0, 0]
material = "paint"
[[object]]
sphere = {radius = 9, fineness = 1}
position = [0, -10, 0]
[[material]]
name = "paint"
base_color = "red"
opacity = 0.6
[[light]]
type = "point"
position = [2, 5, 3]
intensity = 60
)");
  }
};

// Of the bits of everything in `part`, which `whole` has, too.
void expect_same(const Picture& part, const Picture& whole) {
  ASSERT_TRUE(contains(whole.window(), part.window()));
  ASSERT_EQ(part.planes().size(), whole.planes().size());
  const auto at = [](const Picture& picture, int x, int y) {
    return static_cast<std::size_t>((y - picture.window().top) * picture.width() + x -
                                    picture.window().left);
  };
  int different = 0;
  for (int y = part.window().top; y < part.window().bottom(); ++y) {
    for (int x = part.window().left; x < part.window().right(); ++x) {
      const std::size_t i = at(part, x, y), j = at(whole, x, y);
      different += part.rgba()[i] != whole.rgba()[j];
      for (std::size_t p = 0; p < part.planes().size(); ++p) {
        const Plane &a = part.planes()[p], &b = whole.planes()[p];
        different += a.times.empty() ? std::memcmp(&a.values[i], &b.values[j], sizeof(float)) != 0
                                     : std::memcmp(&a.times[i], &b.times[j], sizeof(double)) != 0;
      }
    }
  }
  EXPECT_EQ(different, 0);
}

using Change = void (*)(RenderSettings&);

TEST_F(Window, ChangesNoPixel) {
  for (const Change change : {Change([](RenderSettings&) {}), Change([](RenderSettings& r) {
                                r.integrator = IntegratorKind::path;
                              }),
                              Change([](RenderSettings& r) { r.noise = 0.02, r.samples = 40; }),
                              Change([](RenderSettings& r) {
                                r.integrator = IntegratorKind::path, r.noise = 0.2, r.samples = 40;
                              }),
                              Change([](RenderSettings& r) {
                                r.integrator = IntegratorKind::path, r.doppler = r.beaming = true;
                              })}) {
    const auto with = [&](const std::string& window) {
      Scene changed = scene(window);
      change(changed.render);
      return first_picture(changed);
    };
    const Picture whole = with("");
    const Picture around = with("overscan = 7\n");
    EXPECT_EQ(whole.window(), (PixelWindow{0, 0, kWidth, kHeight}));
    EXPECT_EQ(around.window(), (PixelWindow{-7, -7, kWidth + 14, kHeight + 14}));
    expect_same(whole, around);
    const Picture crop = with("crop = [5, 3, 9, 10]\n");
    EXPECT_EQ(crop.window(), (PixelWindow{5, 3, 9, 10}));
    expect_same(crop, whole);
    expect_same(with("crop = [21, 17, 1, 1]\n"), whole);
    expect_same(with("overscan = 7\ncrop = [-6, 13, 12, 12]\n"), around);
  }
}

TEST_F(Window, HoldsWhatLiesBeside) {
  Scene wide = scene("overscan = 4\n");
  for (Material& material : wide.materials) material.alpha_mode = AlphaMode::opaque;
  const Picture around = first_picture(wide);
  // A display as large as the overscan's, behind which the field of view is as much larger.
  Scene larger = wide;
  larger.render.overscan = 0;
  larger.render.width = kWidth + 8;
  larger.render.height = kHeight + 8;
  larger.camera.vertical_fov =
      2 * std::atan(std::tan(0.5 * wide.camera.vertical_fov) * (kHeight + 8) / kHeight);
  const Picture same_view = first_picture(larger);
  const auto a = channel_of(around, "id_object.V"), b = channel_of(same_view, "id_object.V");
  int different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
  EXPECT_LE(different, 2);  // along edges, by rounding
}

TEST_F(Window, FaultsAreTold) {
  using testing::ElementsAre;
  using testing::HasSubstr;
  const auto with = [&](const std::string& line) {
    return faults("[render]\nresolution = [20, 10]\n" + line + "\n[[object]]\nsphere = {}\n");
  };
  EXPECT_THAT(with("crop = [0, 0, 21, 10]"), ElementsAre(HasSubstr("3:8: render: crop reaches")));
  EXPECT_THAT(with("crop = [0, 0, 10]"), ElementsAre(HasSubstr("[left, top, width, height]")));
  EXPECT_THAT(with("crop = [0, 0, 0, 10]"), ElementsAre(HasSubstr("crop's width is 0")));
  EXPECT_THAT(with("crop = [-1, 0, 5, 5]"), ElementsAre(HasSubstr("within (0, 0) and (20, 10)")));
  EXPECT_THAT(with("overscan = -1"), ElementsAre(HasSubstr("overscan is -1")));
  EXPECT_THAT(with("overscan = 1\ncrop = [-1, -1, 22, 12]"), ElementsAre());
}

}  // namespace
}  // namespace restframe
