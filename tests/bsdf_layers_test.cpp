// What the layers of glTF's materials do, where closed forms tell it: seen straight on, and smooth.

#include <gtest/gtest.h>

#include "support/bsdf_kinds.h"
#include "tracer/bsdf_albedo.h"

namespace restframe {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Seen straight on: black, smooth, and without gloss.
Bsdf black() {
  Bsdf bsdf;
  bsdf.base = Vec3f(0);
  bsdf.alpha = 0;
  bsdf.eta = 1;
  return bsdf;
}

struct Sums {
  Vec3 back{0}, on{0};  // reflected, and passed
};

Sums sums_of(const Bsdf& bsdf, int count = 20000) {
  Sums sums;
  Chooser chooser(5);
  for (int i = 0; i < count; ++i) {
    const auto way = chooser(bsdf);
    if (!way) continue;
    (glm::dot(way->direction, bsdf.facet) > 0 ? sums.back : sums.on) += Vec3(way->weight);
  }
  return {sums.back / Vec3(count), sums.on / Vec3(count)};
}

TEST(Clearcoat, ReflectsFourPercentStraightOn) {
  Bsdf bsdf = black();
  EXPECT_EQ(sums_of(bsdf).back, Vec3(0));
  bsdf.layers.coat = 1;
  EXPECT_NEAR(sums_of(bsdf).back.x, 0.04, 1e-6);
  bsdf.layers.coat = 0.5F;
  EXPECT_NEAR(sums_of(bsdf).back.x, 0.02, 1e-6);
  EXPECT_FLOAT_EQ(coat_reflection(1, 0, 1), 0.04F);
}

TEST(Clearcoat, LeavesTheRestToWhatIsBelow) {
  Bsdf bsdf = black();
  bsdf.base = {1, 0.5F, 0};
  bsdf.layers.coat = 1;
  const Vec3f light = glm::normalize(Vec3f(1, 0, 1));
  const Vec3f expected = 0.96F * bsdf.base / kPi * light.z;
  EXPECT_LT(glm::length(scattered_fraction(bsdf, light) - expected), 1e-6F);
}

// Its mirror image is about its own normal, whatever the base's.
TEST(Clearcoat, HasItsOwnNormal) {
  Bsdf bsdf = black();
  bsdf.layers.coat = 1;
  bsdf.layers.coat_normal = glm::normalize(Vec3f(0.1F, 0, 1));
  bsdf.normal = glm::normalize(Vec3f(0, -0.3F, 1));
  const auto way = scatter(bsdf, 0.5F, 0.3F, 0.3F);
  ASSERT_TRUE(way);
  EXPECT_LT(glm::length(way->direction + bsdf.view -
                        2 * glm::dot(bsdf.view, bsdf.layers.coat_normal) * bsdf.layers.coat_normal),
            1e-6F);
}

TEST(Specular, OfZeroLeavesLambert) {
  for (const float alpha : {0.0F, 0.2F, 1.0F}) {
    Bsdf bsdf = surface_seen_at(1.2);
    bsdf.specular = 0;
    bsdf.alpha = alpha;
    bsdf.base = {0.8F, 0.4F, 0};
    for (const Vec3f& light : {Vec3f(0, 0, 1), glm::normalize(Vec3f(1, -2, 0.3F))}) {
      const Vec3f expected = bsdf.base / kPi * light.z;
      EXPECT_LT(glm::length(scattered_fraction(bsdf, light) - expected), 1e-6F) << alpha;
    }
  }
}

TEST(Specular, ColoursWhatIsReflectedStraightOn) {
  Bsdf bsdf = black();
  bsdf.eta = 1.5F;
  bsdf.specular_color = {1, 0.5F, 100};  // at most all is reflected
  EXPECT_LT(glm::length(sums_of(bsdf).back - Vec3(0.04, 0.02, 1)), 1e-6);
  bsdf.specular = 0.5F;
  EXPECT_LT(glm::length(sums_of(bsdf).back - Vec3(0.02, 0.01, 0.5)), 1e-6);
}

// Its factor does, its colour does not.
TEST(Specular, ChangesReflectionAtGrazingAngles) {
  Bsdf bsdf = surface_seen_at(1.5705);
  bsdf.base = Vec3f(0);
  bsdf.alpha = 0;
  bsdf.specular_color = Vec3f(0);
  EXPECT_NEAR(sums_of(bsdf).back.x, 1, 2e-3);
  bsdf.specular = 0.25F;
  EXPECT_NEAR(sums_of(bsdf).back.x, 0.25, 1e-3);
}

TEST(Specular, DoesNothingToMetals) {
  Bsdf bsdf = surface_seen_at(0.4);
  bsdf.metallic = 1;
  bsdf.alpha = 0.2F;
  const Vec3f light = glm::normalize(Vec3f(-0.3F, 0.2F, 1));
  const Vec3f as_it_is = scattered_fraction(bsdf, light);
  bsdf.specular = 0;
  bsdf.specular_color = {1, 0, 3};
  EXPECT_EQ(scattered_fraction(bsdf, light), as_it_is);
}

TEST(Reflection, GoesByTheIndexOfRefraction) {
  for (const double ior : {1.0, 1.33, 1.5, 2.4}) {
    Bsdf bsdf = black();
    bsdf.eta = static_cast<float>(ior);
    EXPECT_NEAR(sums_of(bsdf).back.x, std::pow((ior - 1) / (ior + 1), 2), 1e-6) << ior;
  }
}

// What has the index of its surroundings is not seen, at any angle.
TEST(Reflection, IsNoneWhereIndicesAreEqual) {
  Bsdf bsdf = surface_seen_at(1.55);
  bsdf.base = Vec3f(0);
  bsdf.eta = 1;
  for (const float alpha : {0.0F, 0.3F}) {
    bsdf.alpha = alpha;
    EXPECT_EQ(sums_of(bsdf, 1000).back, Vec3(0));
  }
}

TEST(Sheet, LetsLightPassStraightOn) {
  for (const double theta : {0.0, 0.7, 1.3}) {
    Bsdf sheet = surface_seen_at(theta);
    sheet.alpha = 0;
    sheet.base = {0.5F, 1, 0.25F};
    sheet.layers.transmission = 1;
    sheet.layers.thin = true;
    const auto reflected = static_cast<double>(fresnel_dielectric(sheet.view.z, 1.5F));
    const Sums sums = sums_of(sheet);
    EXPECT_NEAR(sums.back.y, reflected, 5e-3);
    EXPECT_LT(glm::length(sums.on - Vec3(sheet.base) * (1 - reflected)), 5e-3);
    const auto way = scatter(sheet, 0.999F, 0.2F, 0.6F);
    ASSERT_TRUE(way);
    EXPECT_EQ(way->direction, -sheet.view);
    EXPECT_FALSE(way->through);  // nothing is entered
  }
}

// A rough one blurs what is behind it as a mirror blurs what is before it.
TEST(Sheet, BlursAsAMirror) {
  Bsdf sheet = surface_seen_at(0.6);
  sheet.alpha = 0.2F;
  sheet.layers.transmission = 1;
  sheet.layers.thin = true;
  for (const Vec3& d : {Vec3(0.1, 0.2, 1), Vec3(-0.7, 0.1, 0.6), Vec3(-0.5, -0.5, 0.3)}) {
    const Vec3f above = glm::normalize(Vec3f(d)), below(above.x, above.y, -above.z);
    const float cos_half = glm::dot(sheet.view, glm::normalize(sheet.view + above));
    const float reflected = fresnel_dielectric(cos_half, 1.5F);
    EXPECT_NEAR(scattered_fraction(sheet, above).x * (1 - reflected),
                scattered_fraction(sheet, below).x * reflected, 1e-6F);
  }
}

TEST(Transmission, DividesWhatIsNotReflected) {
  Bsdf bsdf;
  bsdf.alpha = 0;
  bsdf.layers.transmission = 0.25F;
  const Sums sums = sums_of(bsdf, 200000);
  EXPECT_NEAR(sums.on.x, 0.96 * 0.25, 4e-3);
  EXPECT_NEAR(sums.back.x, 0.04 + 0.96 * 0.75, 4e-3);
  bsdf.metallic = 1;  // lets nothing through
  EXPECT_EQ(sums_of(bsdf).on, Vec3(0));
}

// Their distribution has none whose normal is the surface's own.
TEST(Sheen, IsDarkWhereMirrorsWouldShine) {
  Bsdf bsdf = black();
  bsdf.layers.sheen = Vec3f(1);
  bsdf.layers.sheen_alpha = 0.25F;
  EXPECT_EQ(scattered_fraction(bsdf, Vec3f(0, 0, 1)), Vec3f(0));
  bsdf.view = glm::normalize(Vec3f(1, 0, 1));
  EXPECT_LT(scattered_fraction(bsdf, glm::normalize(Vec3f(-1, 0, 1))).x, 1e-6F);
  EXPECT_GT(scattered_fraction(bsdf, bsdf.view).x, 0.01F);
}

TEST(Sheen, IsColouredAndTakesFromTheBase) {
  Bsdf bsdf = surface_seen_at(1.0);
  bsdf.eta = 1;
  bsdf.layers.sheen = {0.8F, 0.4F, 0};
  bsdf.layers.sheen_alpha = 0.5F;
  const double albedo = static_cast<double>(fibre_albedo(bsdf.view.z, 0.5F));
  const Vec3 back = sums_of(bsdf, 200000).back;
  for (int c = 0; c < 3; ++c) {
    const double own = static_cast<double>(bsdf.layers.sheen[c]) * albedo;
    EXPECT_NEAR(back[c], own + 1 - 0.8 * albedo, 6e-3);
  }
}

TEST(Sheen, IsBelowTheCoat) {
  Bsdf bsdf = black();
  bsdf.view = glm::normalize(Vec3f(1, 0, 1));
  bsdf.layers.sheen = Vec3f(1);
  bsdf.layers.sheen_alpha = 0.25F;
  const Vec3f light = glm::normalize(Vec3f(1, 0.5F, 0.5F));
  const float bare = scattered_fraction(bsdf, light).x;
  bsdf.layers.coat = 1;
  const float left = 1 - coat_reflection(1, 0, bsdf.view.z);
  EXPECT_NEAR(scattered_fraction(bsdf, light).x, bare * left, 1e-5F * bare);
}

}  // namespace
}  // namespace restframe
