#include "scene/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace restframe {
namespace {

class Parallel : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_thread_count(GetParam()); }
  void TearDown() override { set_thread_count(0); }
};

// One plain slot an index: a second visit from another thread would be a data race as well.
std::vector<int> visits(std::size_t count) {
  std::vector<int> result(count, 0);
  parallel_for(count, [&](std::size_t i) { ++result[i]; });
  return result;
}

TEST_P(Parallel, SetsTheThreadCount) {
  EXPECT_EQ(thread_count(), GetParam());
}

TEST_P(Parallel, VisitsEveryIndexOnce) {
  for (const std::size_t count : {0UL, 1UL, 2UL, 7UL, 10'000UL}) {
    EXPECT_EQ(visits(count), std::vector<int>(count, 1)) << count << " items";
  }
}

TEST_P(Parallel, WritesAreSeenAfterwards) {
  std::vector<std::size_t> squares(1000);
  parallel_for(squares.size(), [&](std::size_t i) { squares[i] = i * i; });
  for (std::size_t i = 0; i < squares.size(); ++i) EXPECT_EQ(squares[i], i * i);
}

TEST_P(Parallel, RethrowsWhatABodyThrows) {
  const auto fail_at_40 = [](std::size_t i) {
    if (i == 40) throw std::runtime_error("item 40");
  };
  try {
    parallel_for(100, fail_at_40);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), std::string("item 40"));
  }
}

TEST_P(Parallel, SurvivesEveryBodyThrowing) {
  const auto fail = [](std::size_t i) { throw std::out_of_range(std::to_string(i)); };
  EXPECT_THROW(parallel_for(100, fail), std::out_of_range);
  EXPECT_EQ(visits(100), std::vector<int>(100, 1)) << "the next loop";
}

TEST_P(Parallel, FlushesDenormals) {
  std::vector<float> halves(1000);
  const volatile float smallest = std::numeric_limits<float>::min();
  parallel_for(halves.size(), [&](std::size_t i) { halves[i] = smallest * 0.5F; });
  EXPECT_EQ(halves, std::vector<float>(halves.size(), 0.0F));
}

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 5),
                         testing::PrintToStringParamName());

// Two bodies that wait for each other finish only if two threads run them.
TEST(ParallelThreads, RunAtTheSameTime) {
  set_thread_count(2);
  std::atomic<int> arrived{0};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  parallel_for(2, [&](std::size_t) {
    ++arrived;
    while (arrived < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
  });
  set_thread_count(0);
  EXPECT_LT(std::chrono::steady_clock::now(), deadline);
}

TEST(ParallelThreads, DefaultToTheCores) {
  set_thread_count(0);
  EXPECT_EQ(thread_count(), static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace restframe
