// The tables of what rough surfaces scatter in all, against a closed form and quadrature of their own.

#include "tracer/bsdf_albedo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tracer/bsdf_sheen.h"

namespace restframe {
namespace {

constexpr double kPi = std::numbers::pi;

// Microfacets of roughness 1, seen straight on: the integral of c / (1 + c) over all cosines.
TEST(FacetAlbedo, IsAClosedFormForTheRoughestSeenStraightOn) {
  const FacetAlbedo albedo = facet_albedo(facet_albedo_table(), 1, 1);
  EXPECT_NEAR(albedo.all, 1 - std::log(2.0), 1e-3);
}

TEST(FacetAlbedo, IsAllOfWhatIsSmooth) {
  for (const float cosine : {0.001F, 0.1F, 1.0F}) {
    const FacetAlbedo albedo = facet_albedo(facet_albedo_table(), cosine, 0);
    EXPECT_EQ(albedo.all, 1);
    EXPECT_FLOAT_EQ(albedo.grazing, std::pow(1 - cosine, 5.0F));
  }
}

double lambda(double cosine, double alpha) {
  const double tan2 = 1 / (cosine * cosine) - 1;
  return 0.5 * (std::sqrt(1 + alpha * alpha * tan2) - 1);
}

// Over the microfacets' normals, in coordinates in which the distribution is even but for its tails.
struct Reflected {
  double all = 0, grazing = 0;
};
Reflected summed(double cosine, double alpha) {
  constexpr int rings = 400, sectors = 200;
  const double sine = std::sqrt(1 - cosine * cosine);
  Reflected sum;
  for (int i = 0; i < rings; ++i) {
    const double left = 1 - (i + 0.5) / rings, u = 1 - left * left * left;
    const double tan2 = alpha * alpha * u / (1 - u), z = 1 / std::sqrt(1 + tan2);
    const double x = std::sqrt(tan2) * z;
    for (int j = 0; j < sectors; ++j) {
      const double cos_half = sine * x * std::cos(kPi * (j + 0.5) / sectors) + cosine * z;
      const double cos_light = 2 * cos_half * z - cosine;
      if (cos_half <= 0 || cos_light <= 0) continue;
      // D cos(normal) is what is even; f cos(light) d(light) = D G / (4 cosine) 4 cos_half d(normal).
      const double seen = 1 / (1 + lambda(cosine, alpha) + lambda(cos_light, alpha));
      const double part = 3 * left * left * seen * cos_half / (cosine * z) / (rings * sectors);
      sum.all += part;
      sum.grazing += part * std::pow(1 - cos_half, 5);
    }
  }
  return sum;
}

TEST(FacetAlbedo, IsTheIntegralOverMicrofacets) {
  for (const double roughness : {0.08, 0.2, 0.43, 0.7, 0.9, 1.0}) {
    for (const double cosine : {0.05, 0.13, 0.3, 0.62, 0.95}) {
      const double alpha = roughness * roughness;
      const Reflected expected = summed(cosine, alpha);
      const FacetAlbedo albedo =
          facet_albedo(facet_albedo_table(), static_cast<float>(cosine), static_cast<float>(alpha));
      EXPECT_NEAR(albedo.all, expected.all, 6e-3) << roughness << ' ' << cosine;
      EXPECT_NEAR(albedo.grazing, expected.grazing, 6e-3) << roughness << ' ' << cosine;
    }
  }
}

// What has the index of its surroundings reflects nothing, and lets light through straight on: past
// the microfacets of one side and the other.
TEST(GlassAlbedo, IsAClosedFormWithoutRefraction) {
  for (const double alpha : {0.09, 0.49, 1.0}) {
    for (const double cosine : {0.2, 0.6, 1.0}) {
      const double hidden = lambda(cosine, alpha);
      EXPECT_NEAR(glass_albedo(static_cast<float>(cosine), static_cast<float>(alpha), 1),
                  (1 + hidden) / (1 + 2 * hidden), 8e-3)
          << alpha << ' ' << cosine;
    }
  }
}

TEST(GlassAlbedo, IsBetweenNothingAndAll) {
  for (const float eta : {1e-3F, 0.3F, 1 / 1.5F, 1.5F, 3.0F, 1e6F}) {
    for (const float alpha : {0.0F, 0.01F, 0.3F, 1.0F}) {
      for (const float cosine : {0.0F, 1e-3F, 0.1F, 0.5F, 1.0F}) {
        const float albedo = glass_albedo(cosine, alpha, eta);
        EXPECT_GT(albedo, 0.2F) << eta << ' ' << alpha << ' ' << cosine;
        EXPECT_LE(albedo, 1.0001F) << eta << ' ' << alpha << ' ' << cosine;
      }
    }
  }
}

TEST(FibreAlbedo, IsTheIntegralOverTheHemisphere) {
  constexpr int rings = 300, sectors = 100;
  for (const float alpha : {0.04F, 0.2F, 0.5F, 1.0F}) {
    for (const double cosine : {0.05, 0.2, 0.6, 1.0}) {
      const Fibres fibres{{0, 0, 1},
                          Vec3f(Vec3(std::sqrt(1 - cosine * cosine), 0, cosine)),
                          alpha,
                          static_cast<float>(cosine)};
      double sum = 0;
      for (int i = 0; i < rings; ++i) {
        const double z = (i + 0.5) / rings, sine = std::sqrt(1 - z * z);
        for (int j = 0; j < sectors; ++j) {
          const double phi = kPi * (j + 0.5) / sectors;
          const Vec3 direction(sine * std::cos(phi), sine * std::sin(phi), z);
          sum += static_cast<double>(fibre_fraction(fibres, Vec3f(direction)));
        }
      }
      sum *= 2 * kPi / (rings * sectors);
      EXPECT_NEAR(fibre_albedo(static_cast<float>(cosine), alpha), sum, 0.01)
          << alpha << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace restframe
