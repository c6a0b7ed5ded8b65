// How samples are spread over a shutter's time, against inverse cumulative distributions by hand.

#include "tracer/shutter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tracer/camera_sampler.h"

namespace restframe {
namespace {

ExposureSettings with(ShutterShape shape, ShutterCurve curve = {}) {
  ExposureSettings settings;
  settings.shutter = 2;
  settings.shape = shape;
  settings.curve = std::move(curve);
  return settings;
}

TEST(Shutter, OfABoxIsEven) {
  const Shutter shutter(with(ShutterShape::box));
  for (double u = 0; u <= 1; u += 0.125) EXPECT_NEAR(shutter.quantile(u), 2 * u, 1e-15);
}

TEST(Shutter, OfATriangleIsATents) {
  const Shutter shutter(with(ShutterShape::triangle));
  for (double u = 0; u <= 1; u += 0.0625) {
    const double x = u < 0.5 ? std::sqrt(u / 2) : 1 - std::sqrt((1 - u) / 2);
    EXPECT_NEAR(shutter.quantile(u), 2 * x, 1e-12) << u;
  }
}

// Integrates the curve up to each quantile, numerically.
TEST(Shutter, OfACurveInvertsItsIntegral) {
  const ShutterCurve curve = {{0.1, 0}, {0.3, 5}, {0.3, 1}, {0.5, 1}, {0.5, 0}, {0.6, 0}, {0.9, 3}};
  const auto openness = [](double x) {
    if (x < 0.1 || x > 0.9) return 0.0;
    if (x < 0.3) return 25 * (x - 0.1);
    if (x < 0.5) return 1.0;
    return x < 0.6 ? 0.0 : 10 * (x - 0.6);
  };
  const Shutter shutter(with(ShutterShape::curve, curve));
  constexpr int steps = 20000;
  constexpr double all = 0.5 + 0.2 + 0.45;
  double passed = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) / steps;
    passed += openness(x) / steps;
    // Where it is closed, no time is the only one.
    if (openness(x) < 0.01) continue;
    EXPECT_NEAR(shutter.quantile(passed / all), 2 * x, 2e-3) << x;
  }
  EXPECT_NEAR(passed, all, 1e-3);
}

TEST(Shutter, WhollyOpenAtOnceOrLate) {
  const Shutter late(with(ShutterShape::curve, {{0.75, 1e300}, {1, 1e300}}));
  EXPECT_NEAR(late.quantile(0), 1.5, 1e-15);
  EXPECT_NEAR(late.quantile(0.5), 1.75, 1e-15);
  EXPECT_NEAR(late.quantile(1), 2, 1e-15);
}

struct Taken {
  Lanes<std::vector<double>> times;
  Lanes<std::vector<std::pair<double, double>>> film;
};

Taken samples_of(const Scene& scene, std::uint32_t exposure) {
  const CameraSampler sampler(scene);
  const auto samples = static_cast<std::uint32_t>(scene.render.samples);
  PixelLanes pixels;
  PacketId id;
  for (int i = 0; i < packet_size; ++i) {
    pixels.x[i] = i % 4;
    pixels.y[i] = i / 4;
    id.pixel[i] = static_cast<std::uint32_t>(i);
  }
  id.sample = exposure * samples;
  CameraSampler::Starts starts;
  sampler.start(id, starts);
  Taken taken;
  for (std::uint32_t index = 0; index < samples; ++index) {
    CameraSample sample;
    sampler.take(pixels, starts, static_cast<int>(index), sample);
    for (int i = 0; i < packet_size; ++i) {
      taken.times[i].push_back(sample.after_opening[i]);
      taken.film[i].emplace_back(sample.film_x[i] - pixels.x[i], sample.film_y[i] - pixels.y[i]);
    }
  }
  return taken;
}

TEST(CameraSampler, StratifiesTimeInEachPixelAndUsesEveryFilmPointOnce) {
  for (const int samples : {1, 2, 7, 16, 60, 64}) {
    Scene scene;
    scene.render.samples = samples;
    scene.exposure.shutter = 3;
    const Taken taken = samples_of(scene, 0);
    for (int lane = 0; lane < packet_size; ++lane) {
      for (int i = 0; i < samples; ++i) {
        const double part = taken.times[lane][static_cast<std::size_t>(i)] / 3 * samples;
        EXPECT_GE(part, i);
        EXPECT_LT(part, i + 1);
      }
      auto film = taken.film[lane];
      std::sort(film.begin(), film.end());
      EXPECT_EQ(std::unique(film.begin(), film.end()) - film.begin(), samples);
    }
  }
}

TEST(CameraSampler, DrawsAnewForEachPixelAndExposure) {
  Scene scene;
  scene.exposure.shutter = 1;
  const Taken first = samples_of(scene, 0);
  const Taken second = samples_of(scene, 1);
  EXPECT_NE(first.times[0], first.times[1]);
  EXPECT_NE(first.times[0], second.times[0]);
}

// Uniform on the disc: mean of r^2 is a^2 / 2, means of x and y are 0.
TEST(CameraSampler, FillsTheLensEvenly) {
  Scene scene;
  scene.render.samples = 256;
  scene.camera.aperture = 0.5;
  const CameraSampler sampler(scene);
  PacketId id;
  for (int i = 0; i < packet_size; ++i) id.pixel[i] = static_cast<std::uint32_t>(7 * i);
  CameraSampler::Starts starts;
  sampler.start(id, starts);
  PixelLanes pixels{};
  double x = 0, y = 0, square = 0, inner = 0;
  for (int index = 0; index < 256; ++index) {
    CameraSample sample;
    sampler.take(pixels, starts, index, sample);
    for (int i = 0; i < packet_size; ++i) {
      const double r2 = sample.lens_x[i] * sample.lens_x[i] + sample.lens_y[i] * sample.lens_y[i];
      ASSERT_LE(r2, 0.25 + 1e-12);
      x += sample.lens_x[i] / 4096;
      y += sample.lens_y[i] / 4096;
      square += r2 / 4096;
      inner += (r2 < 0.0625) / 4096.0;
      EXPECT_EQ(sample.after_opening[i], 0);
    }
  }
  EXPECT_NEAR(x, 0, 0.003);
  EXPECT_NEAR(y, 0, 0.003);
  EXPECT_NEAR(square, 0.125, 0.001);
  EXPECT_NEAR(inner, 0.25, 0.01);
}

}  // namespace
}  // namespace restframe
