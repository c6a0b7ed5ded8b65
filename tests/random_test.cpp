// The counter-based random numbers: uniform, and independent of each other in every counter.

#include "tracer/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace restframe {
namespace {

// What a stream is counted along; the other counters stay.
struct Counter {
  const char* name;
  std::function<void(PacketId&, std::uint32_t)> set;
};

PacketId packet(std::uint64_t seed) {
  PacketId id;
  id.seed = seed;
  id.picture = 3;
  id.sample = 5;
  for (std::uint32_t i = 0; i < packet_size; ++i) id.pixel[static_cast<int>(i)] = 1000 + i;
  return id;
}

const std::array counters = {
    Counter{"picture", [](PacketId& id, std::uint32_t n) { id.picture = n; }},
    Counter{"pixel", [](PacketId& id, std::uint32_t n) { id.pixel[0] = n; }},
    Counter{"replicate", [](PacketId& id, std::uint32_t n) { id.replicate = n; }},
    Counter{"seed", [](PacketId& id, std::uint32_t n) { id.seed = n; }},
};

std::vector<double> stream(const Counter& counter, std::uint64_t seed, int count) {
  PacketId id = packet(seed);
  std::vector<double> values;
  for (int n = 0; n < count; ++n) {
    counter.set(id, static_cast<std::uint32_t>(n));
    values.push_back(static_cast<double>(random_unit(id, 0, Dimension::opacity, 0)));
  }
  return values;
}

std::vector<double> stream_of_indices(std::uint64_t seed, int count) {
  const PacketId id = packet(seed);
  std::vector<double> values;
  for (int n = 0; n < count; ++n) {
    values.push_back(
        static_cast<double>(random_unit(id, 0, Dimension::opacity, static_cast<std::uint32_t>(n))));
  }
  return values;
}

// Sum of squared deviations from equal counts in 100 bins, over the expected count: 99 degrees of
// freedom, so beyond 160 with a probability of 1e-4 and below 55 of 1e-4.
double chi_squared(const std::vector<double>& values) {
  std::array<double, 100> bins{};
  for (const double v : values) bins[static_cast<std::size_t>(100 * v)] += 1;
  const double expected = static_cast<double>(values.size()) / 100;
  double sum = 0;
  for (const double b : bins) sum += (b - expected) * (b - expected) / expected;
  return sum;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
  return 12 * sum / static_cast<double>(a.size());
}

void expect_uniform(const std::vector<double>& values, const char* what) {
  for (const double v : values) {
    ASSERT_GE(v, 0.0) << what;
    ASSERT_LT(v, 1.0) << what;
  }
  EXPECT_LT(chi_squared(values), 160) << what;
  EXPECT_GT(chi_squared(values), 55) << what;
}

TEST(Random, IsUniformAlongEveryCounter) {
  for (const Counter& counter : counters)
    expect_uniform(stream(counter, 17, 100'000), counter.name);
  expect_uniform(stream_of_indices(17, 100'000), "index");
}

TEST(Random, NeighboursAreNotCorrelated) {
  constexpr int count = 100'000;
  const double tolerance = 5 / std::sqrt(count);
  for (const Counter& counter : counters) {
    const std::vector<double> values = stream(counter, 17, count);
    std::vector<double> next(values.begin() + 1, values.end());
    next.push_back(values.front());
    EXPECT_NEAR(correlation(values, next), 0, tolerance) << counter.name;
  }
}

TEST(Random, SeedsGiveIndependentStreams) {
  constexpr int count = 100'000;
  const double tolerance = 5 / std::sqrt(count);
  const std::vector<double> zero = stream(counters[1], 0, count);
  for (const std::uint64_t seed : {1ULL, 2ULL, 1ULL << 32, 1ULL << 63, ~0ULL}) {
    EXPECT_NEAR(correlation(zero, stream(counters[1], seed, count)), 0, tolerance) << seed;
  }
}

TEST(Random, NoTwoCountersGiveTheSameStream) {
  // The first four numbers of a stream together have 96 bits: equal ones would be no chance.
  std::set<std::vector<double>> streams;
  std::size_t count = 0;
  for (std::uint64_t seed : {0ULL, 1ULL}) {
    PacketId id = packet(seed);
    for (id.picture = 0; id.picture < 8; ++id.picture) {
      for (id.sample = 0; id.sample < 16; ++id.sample) {
        for (int lane = 0; lane < packet_size; ++lane) {
          std::vector<double> first;
          for (std::uint32_t index = 0; index < 4; ++index) {
            first.push_back(static_cast<double>(random_unit(id, lane, Dimension::opacity, index)));
          }
          streams.insert(first);
          ++count;
        }
      }
    }
  }
  EXPECT_EQ(streams.size(), count);
}

// In whatever order a set's numbers are asked for.
TEST(Random, OfPacketsIsThatOfEachLane) {
  PacketId id = packet(4);
  for (int i = 0; i < packet_size; ++i) id.pixel[i] = static_cast<std::uint32_t>(1000 * i + 7);
  const auto count = static_cast<std::uint32_t>(Dimension::count);
  PacketRandom upwards(id), downwards(id);
  for (std::uint32_t index = 0; index < 2; ++index) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto up = static_cast<Dimension>(i), down = static_cast<Dimension>(count - 1 - i);
      for (int lane = 0; lane < packet_size; lane += 5) {
        EXPECT_EQ(upwards(lane, up, index), random_unit(id, lane, up, index));
        EXPECT_EQ(downwards(lane, down, index), random_unit(id, lane, down, index));
      }
    }
  }
}

TEST(Random, DependsOnWhichPixelNotOnWhichLane) {
  PacketId id = packet(4);
  id.pixel[0] = id.pixel[7] = 12345;
  EXPECT_EQ(random_unit(id, 0, Dimension::opacity, 2), random_unit(id, 7, Dimension::opacity, 2));
}

}  // namespace
}  // namespace restframe
