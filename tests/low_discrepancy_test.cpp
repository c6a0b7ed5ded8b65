// Points of the samples of one pixel and of its neighbours: each elementary interval holds its number
// of them, exactly; uses of random numbers do not know of each other.

#include "tracer/low_discrepancy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tracer/random.h"

namespace restframe {
namespace {

struct Point {
  double u, v;
};

PacketId packet(std::uint32_t sample_bits, std::uint64_t seed = 3) {
  PacketId id;
  id.seed = seed;
  id.picture = 2;
  id.sample_bits = sample_bits;
  for (int i = 0; i < packet_size; ++i) id.pixel[i] = 4096U + static_cast<std::uint32_t>(i);
  return id;
}

Point point_of(PacketId& id, int lane, std::uint32_t sample, std::uint32_t index = 0) {
  id.sample = sample;
  return {static_cast<double>(random_unit(id, lane, Dimension::direction_u, index)),
          static_cast<double>(random_unit(id, lane, Dimension::direction_v, index))};
}

// Whether each of the 2^k rectangles of every shape 2^-i by 2^(i - k) holds one of the 2^k points.
bool is_net(const std::vector<Point>& points) {
  const int k = bits_for(static_cast<int>(points.size()));
  for (int i = 0; i <= k; ++i) {
    std::vector<int> held(points.size());
    for (const Point& p : points) {
      const auto column = static_cast<std::size_t>(std::ldexp(p.u, i));
      const auto row = static_cast<std::size_t>(std::ldexp(p.v, k - i));
      ++held[(column << (k - i)) | row];
    }
    if (std::any_of(held.begin(), held.end(), [](int n) { return n != 1; })) return false;
  }
  return true;
}

std::vector<Point> run_of(PacketId id, int lane, std::uint32_t first, std::uint32_t count,
                          std::uint32_t index) {
  std::vector<Point> points;
  for (std::uint32_t s = first; s < first + count; ++s) {
    points.push_back(point_of(id, lane, s, index));
  }
  return points;
}

TEST(LowDiscrepancy, EveryAlignedRunOfAPixelsSamplesIsANet) {
  for (const std::uint32_t bits : {10U, 16U, 32U}) {
    for (std::uint32_t index = 0; index < 6; ++index) {
      for (std::uint32_t count = 1; count <= 1024; count *= 2) {
        for (const std::uint32_t first : {0U, count, 1024U - count}) {
          const auto points =
              run_of(packet(bits, index), static_cast<int>(index), first, count, index);
          EXPECT_TRUE(is_net(points)) << bits << ' ' << index << ' ' << first << ' ' << count;
        }
      }
    }
  }
}

// Whether each box of every shape with sides of powers of 1/2, of which 2^(k - t) fill the cube, holds 2^t
// of the first 2^k points of a set of dimensions: a (t, k, s)-net.
class CubePoints {
 public:
  CubePoints(PacketId id, int lane, std::uint32_t index, Dimension first, int k)
      : k_(k), dimensions_(static_cast<int>(size_of_set(first))) {
    for (id.sample = 0; id.sample < (1U << k); ++id.sample) {
      std::array<double, 4> point{};
      for (int d = 0; d < dimensions_; ++d) {
        const auto dimension = static_cast<Dimension>(static_cast<int>(first) + d);
        point[static_cast<std::size_t>(d)] =
            static_cast<double>(random_unit(id, lane, dimension, index));
      }
      points_.push_back(point);
    }
  }

  bool are_net(int t) const { return are_net(t, 0, k_ - t, {}); }

 private:
  // Halvings are left to be spread over the dimensions from `d` on.
  bool are_net(int t, int d, int left, std::array<int, 4> halvings) const {
    if (d + 1 == dimensions_) {
      halvings[static_cast<std::size_t>(d)] = left;
      return holds_alike(1 << t, halvings);
    }
    bool all = true;
    for (int here = 0; here <= left; ++here) {
      halvings[static_cast<std::size_t>(d)] = here;
      all = all && are_net(t, d + 1, left - here, halvings);
    }
    return all;
  }

  bool holds_alike(int expected, const std::array<int, 4>& halvings) const {
    std::vector<int> held(points_.size() / static_cast<std::size_t>(expected));
    for (const auto& p : points_) {
      std::size_t box = 0;
      for (std::size_t d = 0; d < 4; ++d) {
        box = (box << halvings[d]) | static_cast<std::size_t>(std::ldexp(p[d], halvings[d]));
      }
      ++held[box];
    }
    return std::all_of(held.begin(), held.end(), [&](int n) { return n == expected; });
  }

  int k_, dimensions_;
  std::vector<std::array<double, 4>> points_;
};

TEST(LowDiscrepancy, SetsOfDimensionsAreNets) {
  for (const std::uint32_t bits : {11U, 32U}) {
    for (int k = 3; k <= 11; ++k) {
      const PacketId id = packet(bits, 40 + static_cast<std::uint64_t>(k));
      EXPECT_TRUE(CubePoints(id, 3, 1, Dimension::film_u, k).are_net(0)) << bits << ' ' << k;
      EXPECT_TRUE(CubePoints(id, 3, 1, Dimension::direction_u, k).are_net(1)) << bits << ' ' << k;
      EXPECT_TRUE(CubePoints(id, 3, 1, Dimension::emitter_u, k).are_net(3)) << bits << ' ' << k;
    }
  }
  EXPECT_EQ(size_of_set(Dimension::emitter_u), 4U);
  EXPECT_EQ(size_of_set(Dimension::direction_u), 3U);
  EXPECT_EQ(size_of_set(Dimension::survival), 1U);
}

// A test that no set of points fails tells nothing.
TEST(LowDiscrepancy, OtherPointsAreNoNet) {
  std::vector<Point> points = run_of(packet(8), 0, 0, 64, 0);
  points[5].u = points[6].u;
  EXPECT_FALSE(is_net(points));
}

TEST(LowDiscrepancy, NumbersWithoutAPairAreStratified) {
  PacketId id = packet(12);
  for (const Dimension dimension : {Dimension::opacity, Dimension::survival, Dimension::time}) {
    for (std::uint32_t count = 1; count <= 4096; count *= 4) {
      std::vector<int> held(count);
      for (id.sample = 0; id.sample < count; ++id.sample) {
        const float u = random_unit(id, 7, dimension, 5);
        ++held[static_cast<std::size_t>(u * static_cast<float>(count))];
      }
      EXPECT_EQ(std::count(held.begin(), held.end(), 1), count);
    }
  }
}

// A square of pixels together has the points of one long sequence.
TEST(LowDiscrepancy, AllSamplesOfASquareOfPixelsAreANet) {
  for (const std::uint32_t bits : {0U, 1U, 4U}) {
    for (std::uint32_t index = 0; index < 8; ++index) {
      for (const int pixels : {4, 16}) {
        std::vector<Point> points;
        for (int lane = 0; lane < pixels; ++lane) {
          const auto own = run_of(packet(bits), lane, 0, 1U << bits, index);
          points.insert(points.end(), own.begin(), own.end());
        }
        EXPECT_TRUE(is_net(points)) << bits << ' ' << index << ' ' << pixels;
      }
    }
  }
}

TEST(LowDiscrepancy, MortonPlacesKeepSquaresTogether) {
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) {
      std::uint32_t expected = 0;
      for (std::uint32_t bit = 0; bit < 6; ++bit) {
        expected |= ((x >> bit) & 1U) << (2 * bit) | ((y >> bit) & 1U) << (2 * bit + 1);
      }
      EXPECT_EQ(morton_place(x, y), expected);
    }
  }
  EXPECT_EQ(morton_place(0xffff, 0xffff), 0xffffffffU);
}

TEST(LowDiscrepancy, DrawnForAllLanesTheNumbersAreTheSame) {
  for (const std::uint32_t bits : {0U, 5U, 27U, 32U}) {
    PacketId id = packet(bits);
    id.sample = bits == 0 ? 0 : 13;
    id.replicate = bits;
    PacketRandom random(id);
    for (const std::uint32_t index : {0U, 3U, 0U}) {
      for (std::uint32_t d = 0; d < static_cast<std::uint32_t>(Dimension::count); ++d) {
        const auto dimension = static_cast<Dimension>(d);
        for (int lane = 0; lane < packet_size; ++lane) {
          EXPECT_EQ(random(lane, dimension, index), random_unit(id, lane, dimension, index));
        }
      }
    }
  }
}

// Whether each node of the binary tree over a coordinate flips is, over seeds, a fair coin of its own:
// what Owen's scrambling asks for. 63 nodes, 1,953 pairs; beyond 5 deviations by chance once in 1,000.
TEST(LowDiscrepancy, ScramblingFlipsEachNodeOfTheTreeIndependently) {
  constexpr int depth = 6, seeds = 20'000;
  std::vector<std::vector<int>> flips;  // 1 or -1, a node and seed each
  for (std::uint32_t level = 0; level < depth; ++level) {
    for (std::uint32_t node = 0; node < (1U << level); ++node) {
      flips.emplace_back();
      for (std::uint64_t s = 0; s < seeds; ++s) {
        const auto seed = static_cast<std::uint32_t>(mixed(s + 1));
        flips.back().push_back((scrambled_upwards(node, seed) >> level & 1U) != 0 ? 1 : -1);
      }
    }
  }
  const double deviation = std::sqrt(seeds);
  for (std::size_t i = 0; i < flips.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (std::size_t s = 0; s < seeds; ++s) sum += flips[i][s] * (i == j ? 1 : flips[j][s]);
      EXPECT_LT(std::abs(sum / deviation), 5) << i << ' ' << j;
    }
  }
}

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

// The mean of f over the samples of a pixel is as good as it should be: for an edge across the square
// the squared error falls with the 3/2 power of their number, for independent samples with the first.
double edge_error(std::uint32_t samples, bool sequence) {
  double sum = 0;
  constexpr std::uint32_t pixels = 500;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    PacketId id = packet(8, pixel);
    double inside = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
      if (!sequence) id.replicate = s;
      const Point p = point_of(id, 0, sequence ? s : 0);
      if (std::hypot(p.u, p.v) < 0.8) inside += 1.0 / samples;
    }
    const double error = inside - 0.16 * std::acos(-1.0);
    sum += error * error / pixels;
  }
  return sum;
}

TEST(LowDiscrepancy, ErrorsFallFasterThanWithIndependentNumbers) {
  EXPECT_NEAR(edge_error(64, false) * 64, 0.2500, 0.06);  // p (1 - p), p = 0.5027
  EXPECT_LT(edge_error(64, true), 0.15 * edge_error(64, false));
  EXPECT_LT(edge_error(256, true), 0.2 * edge_error(64, true));
}

// A choice by chance between two things to integrate: the lobe is no stranger to the direction.
double choice_error(std::uint32_t samples, bool sequence) {
  double sum = 0;
  constexpr std::uint32_t pixels = 500;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    PacketId id = packet(8, pixel);
    double mean = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
      if (!sequence) id.replicate = s;
      const Point p = point_of(id, 0, sequence ? s : 0);
      const bool edge = random_unit(id, 0, Dimension::lobe, 0) < 0.3F;
      const double smooth = 4 * p.u * p.v;
      mean += (edge ? (std::hypot(p.u, p.v) < 0.8 ? 1.0 : 0.0) : smooth) / samples;
    }
    const double error = mean - (0.3 * 0.16 * std::acos(-1.0) + 0.7);
    sum += error * error / pixels;
  }
  return sum;
}

TEST(LowDiscrepancy, SoDoThoseOfAChoiceBetweenLobes) {
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
        const Point p = point_of(id, 0, s);
        mean += std::hypot(p.u, p.v) < 0.8 ? std::ldexp(1.0, -static_cast<int>(bits)) : 0.0;
      }
      picture.error.push_back(mean - 0.16 * std::acos(-1.0));
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

TEST(LowDiscrepancy, ErrorsOfNeighboursMakeUpForEachOther) {
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
