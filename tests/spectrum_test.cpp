// Light by wavelength: the observer, daylight, Planck's law, and reflectances for colours.

#include "physics/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "physics/spectrum_table.h"

namespace restframe {
namespace {

// The middle of many equal steps: not how the program integrates.
template <class Spectrum>
Vec3 integral(double from, double to, const Spectrum& spectrum) {
  constexpr int steps = 20'000;
  const double width = (to - from) / steps;
  Vec3 sum(0);
  for (int i = 0; i < steps; ++i) sum += spectrum(from + (i + 0.5) * width);
  return sum * width;
}

template <class Spectrum>
Vec3 xyz_of(const Spectrum& spectrum) {
  return integral(visible_from, visible_to,
                  [&](double w) { return color_matching(w) * spectrum(w); });
}

void expect_chromaticity(const Vec3& xyz, double x, double y) {
  const double sum = xyz.x + xyz.y + xyz.z;
  EXPECT_NEAR(xyz.x / sum, x, 1.5e-4);
  EXPECT_NEAR(xyz.y / sum, y, 1.5e-4);
}

// CIE 15: of the equal-energy spectrum, D65 and, as a blackbody of 2855.5 K, A.
TEST(Observer1931, HasTheChromaticitiesOfCie15) {
  expect_chromaticity(xyz_of([](double) { return 1.0; }), 1.0 / 3, 1.0 / 3);
  expect_chromaticity(xyz_of([](double w) { return daylight(w); }), 0.31272, 0.32903);
  expect_chromaticity(xyz_of([](double w) { return planck(w, 2855.5); }), 0.44758, 0.40745);
}

// Values of the CIE's table of every nanometre, which the one of 5 nm is taken from.
TEST(Observer1931, IsSmoothBetweenTheTable) {
  EXPECT_NEAR(color_matching(555).y, 1, 1e-6);
  EXPECT_NEAR(color_matching(442).x, 0.350147, 2e-4);
  EXPECT_NEAR(color_matching(507).y, 0.4441, 5e-4);
  EXPECT_EQ(color_matching(359.9), Vec3(0));
  EXPECT_EQ(color_matching(830.1), Vec3(0));
}

TEST(Rec709, HasDaylightAsWhite) {
  const Vec3 white = linear_from_xyz(xyz_of([](double w) { return daylight(w); }));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1, 1e-6);
  EXPECT_NEAR(xyz_of([](double w) { return daylight(w); }).y, 1, 1e-6);
}

// IEC 61966-2-1's matrix has the same primaries, and a white of four digits.
TEST(Rec709, HasThePrimariesOfTheStandard) {
  const Vec3 columns[] = {
      {3.2406, -0.9689, 0.0557}, {-1.5372, 1.8758, -0.2040}, {-0.4986, 0.0415, 1.0570}};
  for (int i = 0; i < 3; ++i) {
    Vec3 xyz(0);
    xyz[i] = 1;
    const Vec3 rgb = linear_from_xyz(xyz);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(rgb[j], columns[i][j], 2e-3);
  }
}

TEST(Planck, KeepsStefanAndBoltzmannsLaw) {
  constexpr double sigma = 5.670374419e-8;  // W / (m^2 K^4)
  for (const double kelvin : {3.0, 300.0, 5800.0, 1e6}) {
    // Of the logarithm of wavelength, where the spectrum is as wide for any temperature.
    const double peak = std::log(2.9e6 / kelvin);
    const Vec3 sum = integral(peak - 4, peak + 14, [&](double x) {
      return Vec3(planck(std::exp(x), kelvin) * std::exp(x));
    });
    const double right = sigma * std::pow(kelvin, 4) / std::numbers::pi;
    EXPECT_NEAR(sum.x / right, 1, 1e-6) << kelvin;
  }
}

TEST(Planck, KeepsWiensLaw) {
  for (const double kelvin : {10.0, 3000.0, 1e5}) {
    const double peak = 2.897771955e6 / kelvin;
    const double there = planck(peak, kelvin);
    for (const double aside : {0.99, 1.01}) EXPECT_LT(planck(peak * aside, kelvin), there);
    const double slope = planck(peak * 1.0001, kelvin) - planck(peak * 0.9999, kelvin);
    EXPECT_LT(std::abs(slope), 1e-7 * there);
  }
}

TEST(Planck, IsFiniteForAll) {
  for (double w = 1e-3; w < 1e12; w *= 10) {
    for (double kelvin = 1e-3; kelvin < 1e15; kelvin *= 10) {
      const double value = planck(w, kelvin);
      EXPECT_TRUE(std::isfinite(value) && value >= 0) << w << ' ' << kelvin;
      // Rayleigh and Jeans: 2 c k T / wavelength^4
      const double long_waves = 2 * 2.99792458e8 * 1.380649e-23 * kelvin * 1e27 / std::pow(w, 4);
      if (w * kelvin > 1e13) {
        EXPECT_NEAR(value / long_waves, 1, 1e-5);
      }
    }
  }
  EXPECT_EQ(planck(500, 0), 0);
  EXPECT_EQ(planck(500, -5), 0);
}

// Closed form 12: L_lambda(lambda) = D^5 B(lambda D, T) is a blackbody of D T.
TEST(Planck, ShiftedIsThatOfAnotherTemperature) {
  for (const double d : {0.1, 0.5, 2.0, 14.1067}) {
    for (const double w : {100.0, 555.0, 12'000.0}) {
      EXPECT_NEAR(std::pow(d, 5) * planck(w * d, 4000) / planck(w, d * 4000), 1, 1e-12);
    }
  }
}

TEST(Blackbody, HasLuminance1) {
  for (const double kelvin : {500.0, 777.0, 1500.0, 5800.0, 33'000.0, 1e8}) {
    const Blackbody body(kelvin);
    EXPECT_NEAR(xyz_of([&](double w) { return body(w); }).y, 1, 1e-4) << kelvin;
    EXPECT_NEAR(body(400) / body(700), planck(400, kelvin) / planck(700, kelvin),
                1e-9 * body(400) / body(700));
  }
}

TEST(Blackbody, TakesAnyTemperature) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double kelvin : {-inf, -1.0, 0.0, 1.0, 1e9, inf, std::nan("")}) {
    const Blackbody body(kelvin);
    for (const double w : {10.0, 500.0, 1e5}) EXPECT_TRUE(std::isfinite(body(w))) << kelvin;
  }
}

TEST(Daylight, GoesOnSmoothlyBeyondItsTable) {
  for (const double end : {visible_from, visible_to}) {
    EXPECT_NEAR(daylight(end - 1e-6) / daylight(end + 1e-6), 1, 1e-5);
  }
  EXPECT_NEAR(daylight(2000) / daylight(20'000), planck(2000, 6504) / planck(20'000, 6504), 1e-2);
  EXPECT_NEAR(daylight(300) / daylight(200), planck(300, 6504) / planck(200, 6504), 1e-9);
  for (double w = 10; w <= 1e5; w *= 1.1) EXPECT_GT(daylight(w), 0);
}

// Every colour within 0..1 comes back, and every reflectance is one.
TEST(ReflectanceBasis, GivesBackColors) {
  Vec3 seen[3];
  for (int i = 0; i < 3; ++i) {
    seen[i] =
        linear_from_xyz(xyz_of([&](double w) { return daylight(w) * reflectance_basis(w)[i]; }));
  }
  for (int n = 0; n < 11 * 11 * 11; ++n) {
    const Vec3 color = Vec3(n % 11, n / 11 % 11, n / 121) * 0.1;
    const Vec3 back = color.x * seen[0] + color.y * seen[1] + color.z * seen[2];
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], color[i], 1e-4);
  }
}

TEST(ReflectanceBasis, IsAPartitionOfOne) {
  Vec3 before = reflectance_basis(5);
  for (double w = 5; w < 3e5; w *= 1.002) {
    const Vec3 basis = reflectance_basis(w);
    EXPECT_NEAR(basis.x + basis.y + basis.z, 1, 1e-8);  // nine digits
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(basis[i], 0);
      EXPECT_LE(basis[i], 1);
      EXPECT_NEAR(basis[i], before[i], 0.04) << w;  // smooth
    }
    before = basis;
  }
  for (const double w : {10.0, 179.9, 1660.1, 1e5}) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(reflectance_basis(w)[i], 1.0 / 3, 1e-12);
  }
}

TEST(SpectrumTable, HoldsBasisAndDaylight) {
  const SpectrumTable& table = SpectrumTable::get();
  for (double w = 40; w < 1e5; w *= 1.0037) {  // before, less than floats hold
    const Vec4f values = table(static_cast<float>(w));
    const Vec3 basis = reflectance_basis(w);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(static_cast<double>(values[i]), basis[i], 2e-3) << w;
    EXPECT_NEAR(static_cast<double>(values.w) / daylight(w), 1, 2e-3) << w;
  }
}

}  // namespace
}  // namespace restframe
