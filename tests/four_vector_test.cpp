#include <gtest/gtest.h>

#include "physics/lorentz.h"

namespace restframe {
TEST(WaveVector, LooksAgainstTheLight) {
  EXPECT_EQ(sight_direction(looking_along<in::World>({0, 1, 0})), Vec3(0, 1, 0));
}
}  // namespace restframe
