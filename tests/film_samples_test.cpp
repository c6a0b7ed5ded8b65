// Where a film's samples are, and what their sums keep.

#include "tracer/film_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "film/sample_sum.h"

namespace restframe {
namespace {

TEST(FilmOffsets, BeginAtThePixelsCentre) {
  for (const int samples : {1, 2, 16, 1000}) {
    const std::vector<Vec2f> offsets = film_offsets(samples);
    ASSERT_EQ(offsets.size(), static_cast<std::size_t>(samples));
    EXPECT_EQ(offsets[0], Vec2f(0));
  }
}

TEST(FilmOffsets, AreDistributedAsATentOfRadiusOne) {
  constexpr int count = 4096;
  const std::vector<Vec2f> offsets = film_offsets(count);
  Vec2f sum(0), squares(0);
  float mixed = 0;
  int inner = 0;
  for (const Vec2f& o : offsets) {
    EXPECT_LT(std::max(std::abs(o.x), std::abs(o.y)), 1.0F);
    sum += o;
    squares += o * o;
    mixed += o.x * o.y;
    if (std::abs(o.x) < 0.5F) ++inner;
  }
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(sum[axis] / count, 0, 2e-3);
    EXPECT_NEAR(squares[axis] / count, 1.0 / 6, 2e-3);
  }
  EXPECT_NEAR(mixed / count, 0, 2e-3);
  // The integral of 1 - |x| from -1/2 to 1/2.
  EXPECT_NEAR(double(inner) / count, 0.75, 2e-3);
}

TEST(FilmOffsets, NoTwoAreTheSame) {
  std::set<std::pair<float, float>> seen;
  for (const Vec2f& o : film_offsets(10'000)) seen.emplace(o.x, o.y);
  EXPECT_EQ(seen.size(), 10'000U);
}

// Added one by one, so many floats would be off by 6e-4.
TEST(SampleSum, KeepsDigitsOfManySamples) {
  constexpr int samples = 65'536;
  SampleSum subtotals;
  RadianceLanes sum;
  sum.fill(Vec4f(0));
  for (int i = 0; i < samples; ++i) {
    for (Vec4f& lane : sum.lane) lane += Vec4f(0.1F, 0.7F, 1e-3F, 1);
    subtotals.take_subtotal(i, sum);
  }
  subtotals.complete(sum);
  const double expected[4] = {0.1, 0.7, 1e-3, 1};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(static_cast<double>(sum[5][i]) / samples / expected[i], 1, 1e-6) << i;
  }
}

}  // namespace
}  // namespace restframe
