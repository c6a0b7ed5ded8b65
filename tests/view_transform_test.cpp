// What previews make of light of any brightness.

#include "film/view_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/expect_near.h"

namespace restframe {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

Development filmic(float gain = 1) {
  return {gain, ViewTransform::filmic};
}

TEST(ViewTransform, PlainLightIsLeftAsItIs) {
  for (const Vec3f& light : {Vec3f(0), Vec3f(0.1F, 0.7F, 1), Vec3f(-1, 3, 39600)}) {
    EXPECT_EQ(developed(light, {}), light);
    EXPECT_EQ(developed(light, {4, ViewTransform::srgb}), 4.0F * light);
  }
}

TEST(ViewTransform, ExposureIsInStops) {
  OutputSettings settings;
  EXPECT_EQ(development(settings).gain, 1.0F);
  settings.exposure = 3;
  EXPECT_EQ(development(settings).gain, 8.0F);
  settings.exposure = -1;
  settings.view = ViewTransform::filmic;
  EXPECT_EQ(development(settings).gain, 0.5F);
  EXPECT_EQ(developed(Vec3f(0.3F, 0.2F, 0.1F), development(settings)),
            developed(Vec3f(0.15F, 0.1F, 0.05F), filmic()));
}

// Values of Narkowicz's curve at 0.6 x, worked out by hand: (2.51 y + 0.03) y / ((2.43 y + 0.59) y +
// 0.14) is, at y = 0.6, 0.9216 / 1.3688; at y = 0.108, 0.03251664 / 0.23206352.
TEST(ViewTransform, GreysFollowThePublishedCurve) {
  expect_near(developed(Vec3f(1), filmic()), Vec3f(0.673290F), 1e-5F);
  expect_near(developed(Vec3f(0.18F), filmic()), Vec3f(0.140119F), 1e-5F);
  EXPECT_EQ(developed(Vec3f(0), filmic()), Vec3f(0));
  EXPECT_EQ(developed(Vec3f(1000), filmic()), Vec3f(1));
}

TEST(ViewTransform, BrighterLightIsNeverDarker) {
  const Vec3f red(1, 0.2F, 0.05F);
  Vec3f before(0);
  for (int step = -400; step <= 700; ++step) {
    const Vec3f now = developed(std::exp2(0.025F * static_cast<float>(step)) * red, filmic());
    for (int i = 0; i < 3; ++i) EXPECT_GE(now[i], before[i]) << step;
    EXPECT_LE(now.x, 1.0F);
    before = now;
  }
}

// The hue is where the middle component lies between the others.
float hue(const Vec3f& rgb) {
  return (rgb.y - rgb.z) / (rgb.x - rgb.z);
}

TEST(ViewTransform, HuesStay) {
  const Vec3f orange(1, 0.4F, 0.1F);
  for (const float brightness : {0.01F, 0.5F, 1.0F, 30.0F, 39600.0F}) {
    EXPECT_NEAR(hue(developed(brightness * orange, filmic())), hue(orange), 1e-4F) << brightness;
  }
}

// D^4 of 0.99c ahead.
TEST(ViewTransform, ARedThatBeamsIsNeitherWhiteNorTheRedAtRest) {
  const Vec3f red(1, 0, 0);
  const Vec3f beaming = developed(39600.0F * red, filmic());
  EXPECT_EQ(beaming.x, 1.0F);
  EXPECT_EQ(beaming.y, beaming.z);
  EXPECT_GT(beaming.y, 0.3F);
  EXPECT_LT(beaming.y, 0.7F);
  EXPECT_EQ(developed(red, filmic()).y, 0.0F);  // at white or below, nothing pales
}

TEST(ViewTransform, WhatIsNoNumberIsShownAllTheSame) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vec3f& light : {Vec3f(inf), Vec3f(nan), Vec3f(inf, 0, -inf), Vec3f(-1, nan, 2),
                             Vec3f(std::numeric_limits<float>::max()), Vec3f(-5)}) {
    for (const float gain : {1.0F, 1e19F}) {
      const Vec3f shown = developed(light, filmic(gain));
      for (int i = 0; i < 3; ++i) EXPECT_TRUE(shown[i] >= 0 && shown[i] <= 1) << shown[i];
    }
  }
}

}  // namespace
}  // namespace restframe
