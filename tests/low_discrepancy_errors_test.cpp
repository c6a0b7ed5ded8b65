// What the points of samples are for: uses of random numbers do not know of each other, and means over
// samples and over neighbours are better than those of independent numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/sample_points.h"
#include "tracer/low_discrepancy.h"

namespace restframe {
namespace {

// Counts of two dimensions' numbers in 8 x 8 cells, over the samples of many pixels that are strangers
// to each other. Rows and columns hold equally many by stratification, which leaves 49 degrees of
// freedom; dimensions that know of each other would give many times more than that.
double chi_squared_of(Dimension a, std::uint32_t index_a, Dimension b, std::uint32_t index_b) {
  constexpr int cells = 8;
  constexpr std::uint32_t samples = 64, pixels = 400;
  std::vector<double> held(static_cast<std::size_t>(cells * cells));
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    PacketId id = packet(6, pixel);
    for (id.sample = 0; id.sample < samples; ++id.sample) {
      const int x = static_cast<int>(cells * random_unit(id, 2, a, index_a));
      const int y = static_cast<int>(cells * random_unit(id, 2, b, index_b));
      held[static_cast<std::size_t>(cells * y + x)] += 1;
    }
  }
  constexpr double expected = double{samples} * pixels / (cells * cells);
  double sum = 0;
  for (const double n : held) sum += (n - expected) * (n - expected) / expected;
  return sum;
}

TEST(LowDiscrepancy, UsesAreIndependentOfEachOther) {
  // 49 degrees of freedom: beyond 100 with a probability of 2e-5.
  EXPECT_LT(chi_squared_of(Dimension::lobe, 0, Dimension::survival, 0), 100);
  EXPECT_LT(chi_squared_of(Dimension::opacity, 0, Dimension::direction_u, 0), 100);
  EXPECT_LT(chi_squared_of(Dimension::survival, 1, Dimension::direction_v, 1), 100);
  EXPECT_LT(chi_squared_of(Dimension::direction_u, 0, Dimension::direction_u, 1), 100);
  EXPECT_LT(chi_squared_of(Dimension::direction_v, 0, Dimension::direction_v, 1), 100);
  EXPECT_LT(chi_squared_of(Dimension::direction_u, 3, Dimension::direction_v, 7), 100);
  EXPECT_GT(chi_squared_of(Dimension::lobe, 4, Dimension::lobe, 4), 1000);
}

// The mean square, over many pixels, of what the mean of `value` over a pixel's samples is off by: of a
// sequence, or of samples that are independent of each other.
template <class Value>
double squared_error(std::uint32_t samples, bool sequence, double expected, const Value& value) {
  double sum = 0;
  constexpr std::uint32_t pixels = 500;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    PacketId id = packet(8, pixel);
    double mean = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
      if (!sequence) id.replicate = s;
      const SamplePoint p = point_of(id, 0, sequence ? s : 0);
      mean += value(id, p) / samples;
    }
    sum += (mean - expected) * (mean - expected) / pixels;
  }
  return sum;
}

// A quarter of a disk, and how much of the square it covers.
constexpr double kDisk = 0.16 * std::numbers::pi;

double in_disk(const SamplePoint& p) {
  return std::hypot(p.u, p.v) < 0.8 ? 1 : 0;
}

// For an edge across the square the squared error falls with the 3/2 power of the samples' number, for
// independent ones with the first.
double edge_error(std::uint32_t samples, bool sequence) {
  return squared_error(samples, sequence, kDisk,
                       [](const PacketId&, const SamplePoint& p) { return in_disk(p); });
}

TEST(LowDiscrepancyErrors, FallFasterThanWithIndependentNumbers) {
  EXPECT_NEAR(edge_error(64, false) * 64, 0.2500, 0.06);  // p (1 - p), p = 0.5027
  EXPECT_LT(edge_error(64, true), 0.15 * edge_error(64, false));
  EXPECT_LT(edge_error(256, true), 0.2 * edge_error(64, true));
}

// A choice by chance between two things to integrate: the lobe is no stranger to the direction.
double choice_error(std::uint32_t samples, bool sequence) {
  const auto chosen = [](const PacketId& id, const SamplePoint& p) {
    const bool edge = random_unit(id, 0, Dimension::lobe, 0) < 0.3F;
    return edge ? in_disk(p) : 4 * p.u * p.v;
  };
  return squared_error(samples, sequence, 0.3 * kDisk + 0.7, chosen);
}

TEST(LowDiscrepancyErrors, OfAChoiceBetweenLobesFallFasterToo) {
  EXPECT_LT(choice_error(64, true), 0.15 * choice_error(64, false));
  EXPECT_LT(choice_error(256, true), 0.2 * choice_error(64, true));
}

// Errors of pixels side by side make up for each other: what is left after a blur is a fraction of what
// errors would leave that are strangers to each other.
struct ErrorPicture {
  static constexpr int size = 64;
  std::vector<double> error;

  double at(int x, int y) const { return error[static_cast<std::size_t>(y * size + x)]; }
};

ErrorPicture error_picture(std::uint32_t bits, bool along_curve) {
  ErrorPicture picture;
  PacketId id;
  id.seed = 9;
  id.sample_bits = along_curve ? bits : 32;
  for (std::uint32_t y = 0; y < ErrorPicture::size; ++y) {
    for (std::uint32_t x = 0; x < ErrorPicture::size; ++x) {
      id.pixel[0] = morton_place(x, y);
      double mean = 0;
      for (std::uint32_t s = 0; s < (1U << bits); ++s) {
        const SamplePoint p = point_of(id, 0, s);
        mean += std::ldexp(in_disk(p), -static_cast<int>(bits));
      }
      picture.error.push_back(mean - kDisk);
    }
  }
  return picture;
}

// The power that a Gaussian of this standard deviation leaves, over what it leaves of white noise of the
// same power: 1 for white noise.
double coarse_power(const ErrorPicture& picture, double sigma) {
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  const auto weight = [&](int d) { return std::exp(-0.5 * d * d / (sigma * sigma)); };
  double squares = 0, weights = 0, white = 0, all = 0, pixels = 0;
  for (int a = -reach; a <= reach; ++a) {
    weights += weight(a);
    squares += weight(a) * weight(a);
  }
  for (const double e : picture.error) all += e * e / static_cast<double>(picture.error.size());
  white = all * std::pow(squares / (weights * weights), 2);
  double power = 0;
  for (int y = reach; y < ErrorPicture::size - reach; ++y) {
    for (int x = reach; x < ErrorPicture::size - reach; ++x) {
      double sum = 0;
      for (int b = -reach; b <= reach; ++b) {
        for (int a = -reach; a <= reach; ++a)
          sum += weight(a) * weight(b) * picture.at(x + a, y + b);
      }
      power += std::pow(sum / (weights * weights), 2);
      ++pixels;
    }
  }
  return power / pixels / white;
}

TEST(LowDiscrepancyErrors, OfNeighboursMakeUpForEachOther) {
  for (const std::uint32_t bits : {0U, 2U, 4U}) {
    const double fine = coarse_power(error_picture(bits, true), 2.0);
    const double white = coarse_power(error_picture(bits, false), 2.0);
    EXPECT_LT(fine, 0.35) << bits;
    EXPECT_GT(white, 0.6) << bits;
    RecordProperty("coarse_power_" + std::to_string(1 << bits), std::to_string(fine));
  }
}

}  // namespace
}  // namespace restframe
