// Scattering at one surface: Fresnel's and Snell's closed forms, what choosing at random keeps of the
// light, and that the ways chosen and the fractions for lights tell of the same surface.

#include "tracer/bsdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/bsdf_kinds.h"
#include "support/velocity_grid.h"
#include "tracer/bsdf_albedo.h"

namespace restframe {
namespace {

constexpr double kPi = std::numbers::pi;

// What comes back and what goes through of white light that is scattered, and where to on average.
struct Outcome {
  Vec3 reflected{0}, through{0};  // weights by colour
  Vec3 towards{0};                // mean of reflected weight (red) times direction
  double largest_weight = 0;
};

Outcome sampled(const Bsdf& bsdf, int count) {
  Outcome sum;
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24F; };
  for (int i = 0; i < count; ++i) {
    const float lobe = number(), u = number(), v = number();
    const auto s = scatter(bsdf, lobe, u, v);
    if (!s) continue;
    EXPECT_NEAR(glm::length(s->direction), 1, 1e-5);
    EXPECT_EQ(s->through, glm::dot(s->direction, bsdf.facet) < 0);
    (s->through ? sum.through : sum.reflected) += Vec3(s->weight);
    if (!s->through) sum.towards += static_cast<double>(s->weight.x) * Vec3(s->direction);
    sum.largest_weight = std::max(sum.largest_weight, static_cast<double>(s->weight.x));
  }
  const double n = count;
  return {sum.reflected / n, sum.through / n, sum.towards / n, sum.largest_weight};
}

// The same from scattered_fraction, summed over the hemisphere.
Outcome integrated(const Bsdf& bsdf) {
  constexpr int rings = 160, sectors = 320;
  Outcome sum;
  for (int i = 0; i < rings; ++i) {
    const double theta = 0.5 * kPi * (i + 0.5) / rings;
    const double solid_angle = std::sin(theta) * (0.5 * kPi / rings) * (2 * kPi / sectors);
    for (int j = 0; j < sectors; ++j) {
      const double phi = 2 * kPi * (j + 0.5) / sectors;
      const Vec3 direction(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                           std::cos(theta));
      const Vec3 part = solid_angle * Vec3(scattered_fraction(bsdf, Vec3f(direction)));
      sum.reflected += part;
      sum.towards += part.x * direction;
    }
  }
  return sum;
}

TEST(Fresnel, IsTheTextbooksAtNormalIncidenceBrewstersAngleAndGrazing) {
  for (const double n : {1.1, 1.33, 1.5, 2.4, 1 / 1.33, 1 / 1.5}) {
    const float eta = static_cast<float>(n);
    EXPECT_NEAR(fresnel_dielectric(1, eta), std::pow((n - 1) / (n + 1), 2), 1e-6) << n;
    // Light in the plane of incidence is not reflected at arctan n; of the other half, this is.
    const float brewster = static_cast<float>(std::cos(std::atan(n)));
    const double across = (n * n - 1) / (n * n + 1);
    EXPECT_NEAR(fresnel_dielectric(brewster, eta), 0.5 * across * across, 1e-6) << n;
    EXPECT_NEAR(fresnel_dielectric(0, eta), 1, 1e-6) << n;
  }
  for (const float cosine : {0.01F, 0.3F, 1.0F}) {
    EXPECT_NEAR(fresnel_dielectric(cosine, 1), 0, 1e-6) << cosine;
  }
}

TEST(Fresnel, IsTheSameBothWays) {
  for (const double n : {1.33, 1.5, 2.4}) {
    for (double theta = 0.05; theta < 1.5; theta += 0.1) {
      const double beyond = std::asin(std::sin(theta) / n);
      EXPECT_NEAR(
          fresnel_dielectric(static_cast<float>(std::cos(theta)), static_cast<float>(n)),
          fresnel_dielectric(static_cast<float>(std::cos(beyond)), static_cast<float>(1 / n)), 2e-5)
          << n << ' ' << theta;
    }
  }
}

TEST(Refraction, IsSnellsLaw) {
  for (const double n : {1.0, 1.33, 1.5, 2.4, 1 / 1.33, 1 / 1.5}) {
    for (double theta = 0; theta < 1.56; theta += 0.05) {
      const double sine = std::sin(theta) / n;
      const Bsdf b = surface_seen_at(theta);
      const auto direction = refracted(b.view, b.normal, static_cast<float>(n));
      if (std::abs(sine - 1) < 1e-3) continue;
      ASSERT_EQ(direction.has_value(), sine < 1) << n << ' ' << theta;
      EXPECT_EQ(fresnel_dielectric(b.view.z, static_cast<float>(n)) == 1.0F, sine > 1);
      if (!direction) continue;
      // In the plane of incidence, on the other side of the normal.
      const Vec3 expected(-sine * std::cos(0.4), -sine * std::sin(0.4),
                          -std::sqrt(1 - sine * sine));
      EXPECT_LT(glm::length(Vec3(*direction) - expected), 2e-5) << n << ' ' << theta;
    }
  }
}

// White and without loss: what is met goes on, every bit of it.
TEST(Scattering, WithoutLossKeepsAllLight) {
  for (double theta = 0; theta < 1.5; theta += 0.29) {
    Bsdf metal = surface_seen_at(theta), glass = metal, diffuse = metal;
    metal.metallic = 1;
    glass.layers.transmission = 1;
    metal.alpha = glass.alpha = diffuse.alpha = 0;
    for (const float eta : {1.5F, 1 / 1.5F, 1.0F}) {
      glass.eta = diffuse.eta = metal.eta = eta;
      for (const Bsdf& bsdf : {metal, glass, diffuse}) {
        const Outcome outcome = sampled(bsdf, 1000);
        EXPECT_NEAR(outcome.reflected.x + outcome.through.x, 1, 1e-5) << theta << ' ' << eta;
        EXPECT_NEAR(outcome.largest_weight, 1, 1e-5) << theta << ' ' << eta;
      }
    }
  }
}

// Smooth glass: Fresnel's part comes back along the mirrored ray, the rest goes Snell's way.
TEST(Scattering, SmoothGlassSplitsByFresnel) {
  for (const double theta : {0.0, 0.7, 1.3}) {
    Bsdf glass = surface_seen_at(theta);
    glass.layers.transmission = 1;
    glass.alpha = 0;
    const double reflected = fresnel_dielectric(glass.view.z, glass.eta);
    EXPECT_NEAR(sampled(glass, 100000).reflected.x, reflected, 5e-3);
    EXPECT_LT(glm::length(scatter(glass, 0, 0.3F, 0.6F)->direction -
                          Vec3f(-glass.view.x, -glass.view.y, glass.view.z)),
              1e-6F);
    const auto beyond = refracted(glass.view, glass.normal, glass.eta);
    EXPECT_LT(glm::length(scatter(glass, 0.999F, 0.3F, 0.6F)->direction - *beyond), 1e-6F);
  }
}

// However little the surface as a whole reflects, no path through rough glass counts many times: its
// colour at most, but for what makes up for light that is scattered more than once.
TEST(Scattering, ThroughGlassWeighsLittleMoreThanItsColour) {
  for (const float eta : {1.01F, 1.5F, 1 / 1.01F, 1 / 1.5F}) {
    for (const double theta : {0.0, 0.8, 1.5}) {
      Bsdf glass = surface_seen_at(theta);
      glass.layers.transmission = 1;
      glass.eta = eta;
      const double most = 1 / static_cast<double>(glass_albedo(glass.view.z, glass.alpha, eta));
      EXPECT_LE(sampled(glass, 100000).largest_weight, 1.0001 * most) << eta << ' ' << theta;
      EXPECT_LT(most, 2.5);
    }
  }
}

// The part of the light that is scattered, wherever to.
Estimate light_scattered(const Bsdf& bsdf) {
  Chooser chooser(1);
  Mean mean;
  for (int i = 0; i < 2000; ++i) {
    const auto way = chooser(bsdf);
    mean.add(way ? static_cast<double>(way->weight.x) : 0.0);
  }
  return mean.estimate();
}

TEST(Scattering, NeverGivesMoreThanItGets) {
  for (const BsdfKind& kind : all_kinds()) {
    for (const double roughness : {0.0, 0.1, 0.3, 0.6, 1.0}) {
      for (double theta = 0; theta < 1.57; theta += 0.5) {
        const Estimate sum = light_scattered(kind.seen_at(theta, roughness));
        EXPECT_LE(sum.mean, 1.008 + 5 * sum.deviation)
            << kind.name << " roughness " << roughness << " theta " << theta;
      }
    }
  }
}

// A white furnace: what absorbs nothing is as bright as all around it.
TEST(Scattering, KeepsAllLightWhatIsWhite) {
  for (const BsdfKind& kind : white_kinds()) {
    for (const double roughness : {0.0, 0.05, 0.15, 0.3, 0.6, 1.0}) {
      for (const double theta : {0.0, 0.7, 1.2, 1.45}) {
        const Estimate sum = light_scattered(kind.seen_at(theta, roughness));
        EXPECT_NEAR(sum.mean, 1, 0.01 + 5 * sum.deviation)
            << kind.name << " roughness " << roughness << " theta " << theta;
      }
    }
  }
}

// Ways chosen at random and fractions for lights: the same albedo, the same mean direction.
TEST(Scattering, AgreesWithTheFractionForLights) {
  struct Kind {
    float metallic, transmission, eta;
    Vec3f base;
  };
  const Kind kinds[] = {{1, 0, 1.5F, {0.9F, 0.5F, 0.1F}},  // metal
                        {0, 0, 1.5F, {0, 0, 0}},           // the gloss alone
                        {0, 0, 1, {0.8F, 0.4F, 0.2F}},     // the diffuse part alone
                        {0, 1, 1 / 1.5F, {1, 1, 1}},       // likewise, from inside
                        {0, 1, 1.5F, {1, 1, 1}},           // rough glass
                        {0.3F, 0.4F, 1.5F, {0.7F, 0.5F, 0.3F}}};
  for (const Kind& kind : kinds) {
    for (const float roughness : {0.3F, 0.6F, 1.0F}) {
      for (const double theta : {0.0, 0.6, 1.2}) {
        Bsdf bsdf = surface_seen_at(theta);
        bsdf.metallic = kind.metallic;
        bsdf.layers.transmission = kind.transmission;
        bsdf.eta = kind.eta;
        bsdf.base = kind.base;
        bsdf.alpha = roughness * roughness;
        const Outcome chosen = sampled(bsdf, 60000), summed = integrated(bsdf);
        SCOPED_TRACE(::testing::Message()
                     << "metallic " << kind.metallic << " transmission " << kind.transmission
                     << " eta " << kind.eta << " roughness " << roughness << " theta " << theta);
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(chosen.reflected[c], summed.reflected[c], 0.015 * summed.reflected[c] + 3e-3);
        }
        EXPECT_LT(glm::length(chosen.towards - summed.towards), 0.015 * summed.reflected.x + 4e-3);
      }
    }
  }
}

// Up, or down for glass.
std::vector<Vec3f> one_sided_directions(int count, unsigned seed, float side) {
  std::vector<Vec3f> directions;
  for (const Vec3& d : random_directions(count, seed)) {
    const Vec3f one = Vec3f(d);
    directions.push_back(glm::normalize(Vec3f(one.x, one.y, side * (std::abs(one.z) + 0.05F))));
  }
  return directions;
}

// Helmholtz: gloss, metal and the diffuse part under no gloss send as much either way, but for what
// makes up for light that is scattered more than once, which goes by the view alone (Turquin 2019).
TEST(ScatteredFraction, IsReciprocal) {
  const auto from = one_sided_directions(20, 3, 1), to = one_sided_directions(20, 4, 1);
  for (const float metallic : {0.0F, 1.0F}) {
    for (const float eta : {1.0F, 1.5F}) {
      Bsdf there;
      there.metallic = metallic;
      there.eta = eta;
      there.alpha = 0.25F;
      there.base = metallic == 0 && eta != 1 ? Vec3f(0) : Vec3f(0.8F, 0.5F, 0.2F);
      const Vec3f straight = metallic == 0 ? Vec3f(eta == 1 ? 0.0F : 0.04F) : there.base;
      const auto once = [&](Bsdf bsdf, const Vec3f& view, const Vec3f& light) {
        bsdf.view = view;
        const float albedo = facet_albedo(facet_albedo_table(), view.z, bsdf.alpha).all;
        const Vec3f more = Vec3f(1) + straight * ((1 - albedo) / albedo);
        return scattered_fraction(bsdf, light) / (light.z * more);
      };
      for (std::size_t i = 0; i < from.size(); ++i) {
        const Vec3f one = once(there, from[i], to[i]), other = once(there, to[i], from[i]);
        EXPECT_LT(glm::length(one - other), 1e-4F * glm::length(one)) << metallic << ' ' << eta;
      }
    }
  }
}

// Through a boundary, what goes in is eta squared of what comes out: radiance is denser inside.
TEST(ScatteredFraction, IsReciprocalThroughGlass) {
  const auto from = one_sided_directions(200, 3, 1), to = one_sided_directions(200, 4, -1);
  const float eta = 1.5F;
  Bsdf glass;
  glass.layers.transmission = 1;
  glass.alpha = 0.36F;
  glass.base = {0.9F, 0.5F, 0.3F};
  int met = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    Bsdf in = glass, out = glass;
    in.eta = eta;
    in.view = from[i];
    out.eta = 1 / eta;
    out.view = to[i];
    out.normal = out.facet = Vec3f(0, 0, -1);
    const auto once = [](const Bsdf& b, const Vec3f& light) {
      return scattered_fraction(b, light) / std::abs(light.z) *
             glass_albedo(std::abs(b.view.z), b.alpha, b.eta);
    };
    const Vec3f inward = once(in, to[i]), outward = once(out, from[i]);
    if (inward != Vec3f(0)) ++met;
    EXPECT_LT(glm::length(inward - outward * eta * eta), 1e-3F * glm::length(inward) + 2e-5F) << i;
  }
  EXPECT_GT(met, 30);
}

TEST(ScatteredFraction, IsNothingFromBehind) {
  Bsdf bsdf = surface_seen_at(0.5);
  EXPECT_EQ(scattered_fraction(bsdf, Vec3f(0, 0, -1)), Vec3f(0));
  bsdf.facet = glm::normalize(Vec3f(1, 0, 0.1F));
  EXPECT_EQ(scattered_fraction(bsdf, glm::normalize(Vec3f(-1, 0, 0.05F))), Vec3f(0));
}

}  // namespace
}  // namespace restframe
