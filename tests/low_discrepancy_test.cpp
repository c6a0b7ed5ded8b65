// Points of the samples of one pixel and of its neighbours: each elementary interval holds its number
// of them, exactly.

#include "tracer/low_discrepancy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/sample_points.h"

namespace restframe {
namespace {

// Whether each of the 2^k rectangles of every shape 2^-i by 2^(i - k) holds one of the 2^k points.
bool is_net(const std::vector<SamplePoint>& points) {
  const int k = bits_for(static_cast<int>(points.size()));
  for (int i = 0; i <= k; ++i) {
    std::vector<int> held(points.size());
    for (const SamplePoint& p : points) {
      const auto column = static_cast<std::size_t>(std::ldexp(p.u, i));
      const auto row = static_cast<std::size_t>(std::ldexp(p.v, k - i));
      ++held[(column << (k - i)) | row];
    }
    if (std::any_of(held.begin(), held.end(), [](int n) { return n != 1; })) return false;
  }
  return true;
}

std::vector<SamplePoint> run_of(PacketId id, int lane, std::uint32_t first, std::uint32_t count,
                                std::uint32_t index) {
  std::vector<SamplePoint> points;
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
  std::vector<SamplePoint> points = run_of(packet(8), 0, 0, 64, 0);
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
        std::vector<SamplePoint> points;
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

}  // namespace
}  // namespace restframe
