#include "support/picture_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/direct_render.h"

namespace restframe {
namespace {

// Sums over pictures.
struct Sums {
  std::vector<double> first, second;

  void add(const std::vector<double>& values) {
    first.resize(values.size());
    second.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      first[i] += values[i];
      second[i] += values[i] * values[i];
    }
  }

  PixelMeans means(int pictures) const {
    PixelMeans means;
    means.pictures = pictures;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const double mean = first[i] / pictures;
      const double variance = std::max(0.0, second[i] / pictures - mean * mean) / (pictures - 1);
      means.mean.push_back(mean);
      means.error.push_back(std::sqrt(variance));
    }
    return means;
  }
};

template <class Reduce>
PixelMeans means_of(Scene& scene, int pictures, LightSearch search, const Reduce& reduce) {
  const FrameSet frames(scene, thread_count());
  const Integrator integrator(std::in_place_type<PathTracer>, scene, frames, search);
  EvaluatorPool evaluators(scene.functions);
  Sums sums;
  for (int seed = 1; seed <= pictures; ++seed) {
    scene.render.seed = static_cast<std::uint64_t>(seed);
    Picture picture = blank_picture(scene);
    render_picture({scene, integrator, evaluators, {}}, 0, picture);
    sums.add(reduce(picture));
  }
  return sums.means(pictures);
}

// From a few pictures the error is not well known: Student's t as a normal deviate of about the same
// probability (Wallace 1959).
double z_of_t(double t, int degrees) {
  const double n = degrees;
  const double z = (8 * n + 1) / (8 * n + 3) * std::sqrt(n * std::log1p(t * t / n));
  return std::copysign(z, t);
}

double deviation(double difference, double error, int degrees) {
  if (difference == 0) return 0;
  return error > 0 ? z_of_t(difference / error, degrees) : INFINITY;
}

}  // namespace

PixelMeans pixel_means(Scene scene, int pictures, LightSearch search, const std::string& channels) {
  return means_of(scene, pictures, search, [&](const Picture& picture) {
    std::vector<double> values;
    for (const Vec4f& pixel : picture.rgba()) {
      for (const char channel : channels) {
        values.push_back(
            static_cast<double>(pixel[static_cast<int>(std::string("RGB").find(channel))]));
      }
    }
    return values;
  });
}

PixelMeans block_means(Scene scene, int pictures, int block, LightSearch search) {
  const int columns = scene.render.width / block, rows = scene.render.height / block;
  return means_of(scene, pictures, search, [&](const Picture& picture) {
    std::vector<double> values(static_cast<std::size_t>(columns * rows));
    for (int y = 0; y < rows * block; ++y) {
      for (int x = 0; x < columns * block; ++x) {
        const Vec4f& pixel = picture.rgba()[static_cast<std::size_t>(y * scene.render.width + x)];
        values[static_cast<std::size_t>(y / block * columns + x / block)] +=
            static_cast<double>(pixel.y) / (block * block);
      }
    }
    return values;
  });
}

double sidak_bound(std::size_t count, double chance) {
  const double one = -std::expm1(std::log1p(-chance) / static_cast<double>(count));
  double low = 0, high = 40;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::sqrt(2.0)) > one ? low : high) = middle;
  }
  return high;
}

void expect_means(const PixelMeans& measured, const std::vector<double>& expected,
                  double relative) {
  ASSERT_EQ(measured.mean.size(), expected.size());
  const double bound = sidak_bound(expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double tolerated = relative * std::abs(expected[i]) + 1e-6 * std::abs(expected[i]);
    const double off = measured.mean[i] - expected[i];
    const double difference = std::copysign(std::max(0.0, std::abs(off) - tolerated), off);
    const double z = deviation(difference, measured.error[i], measured.pictures - 1);
    EXPECT_LT(std::abs(z), bound) << "value " << i << ": " << measured.mean[i] << " +- "
                                  << measured.error[i] << ", not " << expected[i];
    if (::testing::Test::HasFailure()) return;
  }
}

void expect_mean(const PixelMeans& measured, double expected, double relative) {
  expect_means(measured, std::vector<double>(measured.mean.size(), expected), relative);
}

void expect_equal_means(const PixelMeans& a, const PixelMeans& b) {
  ASSERT_EQ(a.mean.size(), b.mean.size());
  const double bound = sidak_bound(a.mean.size());
  for (std::size_t i = 0; i < a.mean.size(); ++i) {
    const double error = std::hypot(a.error[i], b.error[i]);
    const double off = a.mean[i] - b.mean[i];
    const double tolerated = 1e-6 * std::abs(a.mean[i]);
    const double difference = std::abs(off) < tolerated ? 0.0 : off;
    const double z = deviation(difference, error, std::min(a.pictures, b.pictures) - 1);
    EXPECT_LT(std::abs(z), bound) << "value " << i << ": " << a.mean[i] << " +- " << a.error[i]
                                  << " and " << b.mean[i] << " +- " << b.error[i];
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace restframe
