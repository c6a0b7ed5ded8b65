// What a spectrum looks like, by chosen wavelengths, by sums, and for one line; in any band.

#include "physics/observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/spectrum.h"

namespace restframe {
namespace {

using Spectrum = double (*)(double);

Vec3 by_samples(const Observer& observer, Spectrum spectrum, int count) {
  Vec3 sum(0);
  for (int i = 0; i < count; ++i) {
    const Observer::Part part =
        observer.sample((static_cast<float>(i) + 0.5F) / static_cast<float>(count));
    sum += Vec3(part.rgb) * spectrum(static_cast<double>(part.wavelength));
  }
  return sum / static_cast<double>(count);
}

Vec3 by_parts(const Observer& observer, Spectrum spectrum) {
  Vec3 sum(0);
  for (const Observer::Part& part : observer.parts()) {
    sum += Vec3(part.rgb) * spectrum(static_cast<double>(part.wavelength));
  }
  return sum;
}

Vec3 by_lines(const Observer& observer, Spectrum spectrum, double from, double to) {
  constexpr int steps = 50'000;
  const double width = (to - from) / steps;
  Vec3 sum(0);
  for (int i = 0; i < steps; ++i) {
    const double w = from + (i + 0.5) * width;
    sum += observer.response(w) * spectrum(w);
  }
  return sum * width;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

const Spectrum kSpectra[] = {
    [](double w) { return daylight(w); },
    [](double) { return 0.005; },
    [](double w) { return 0.02 * planck(w, 3000) / planck(560, 3000); },
    [](double w) { return daylight(w) * reflectance_basis(w).x; },
};

TEST(Observer, SeesTheSameByAllWays) {
  const Observer eye(std::nullopt);
  for (const Spectrum& spectrum : kSpectra) {
    const Vec3 right = by_lines(eye, spectrum, visible_from, visible_to);
    expect_near(by_samples(eye, spectrum, 100'000), right, 3e-4);
    expect_near(by_parts(eye, spectrum), right, 5e-4);
  }
}

TEST(Observer, SeesBandsByAllWays) {
  for (const WavelengthBand& band : {WavelengthBand{2000, 4000}, {100, 300}, {8000, 14'000}}) {
    const Observer camera(band);
    for (const Spectrum& spectrum : kSpectra) {
      const Vec3 right = by_lines(camera, spectrum, band.from, band.to);
      const double size = std::max({right.x, right.y, right.z});
      expect_near(by_samples(camera, spectrum, 30'000) / size, right / size, 1e-3);
      expect_near(by_parts(camera, spectrum) / size, right / size, 1e-3);
    }
  }
}

TEST(Observer, HasDaylightAsWhiteInAnyBand) {
  expect_near(by_samples(Observer(std::nullopt), kSpectra[0], 100'000), Vec3(1), 2e-4);
  for (const WavelengthBand& band :
       {WavelengthBand{2000, 4000}, {200, 400}, {400, 700}, {10'000, 100'000}}) {
    expect_near(by_samples(Observer(band), kSpectra[0], 30'000), Vec3(1), 1e-3);
  }
}

// Three evenly spaced wavelengths are one of each third, the longest red.
TEST(Observer, ShowsThirdsAsRedGreenAndBlue) {
  const Observer camera(WavelengthBand{1000, 8000});
  for (const float u : {0.0F, 0.1F, 0.333F}) {
    for (int third = 0; third < 3; ++third) {
      const Observer::Part part = camera.sample(u + static_cast<float>(third) / 3);
      EXPECT_LE(part.wavelength, 8000 / std::pow(2.0F, static_cast<float>(third)) * 1.0001F);
      EXPECT_GE(part.wavelength, 4000 / std::pow(2.0F, static_cast<float>(third)) * 0.9999F);
      for (int i = 0; i < 3; ++i) EXPECT_EQ(part.rgb[i] > 0, i == third);
    }
  }
  EXPECT_GT(camera.response(7999).x, 0);
  EXPECT_GT(camera.response(3000).y, 0);
  EXPECT_GT(camera.response(1001).z, 0);
  EXPECT_EQ(camera.response(999), Vec3(0));
  EXPECT_EQ(camera.response(8001), Vec3(0));
}

// Where daylight has next to nothing, a billionth of its best is white.
TEST(Observer, StaysFiniteInTheFarUltraviolet) {
  const Observer camera(WavelengthBand{10, 40});
  const Vec3 seen = by_samples(
      camera, [](double) { return 1e-9; }, 3000);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], 1 / daylight(560), 0.01 / daylight(560));
}

// Few wavelengths, turned by any amount, see a smooth spectrum with little noise.
TEST(Observer, NeedsFewWavelengths) {
  const Observer eye(std::nullopt);
  constexpr int samples = 16;
  double worst = 0;
  for (int turn = 0; turn < 50; ++turn) {
    Vec3 sum(0);
    for (int i = 0; i < 3 * samples; ++i) {
      const Observer::Part part =
          eye.sample((static_cast<float>(i) + static_cast<float>(turn) / 50) / (3 * samples));
      sum += Vec3(part.rgb) * daylight(static_cast<double>(part.wavelength));
    }
    sum /= 3.0 * samples;
    for (int i = 0; i < 3; ++i) worst = std::max(worst, std::abs(sum[i] - 1));
  }
  EXPECT_LT(worst, 0.05);
}

}  // namespace
}  // namespace restframe
