#pragma once

#include <gtest/gtest.h>

#include "physics/vectors.h"

namespace restframe {

inline void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(glm::length(a - b), 0, 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

inline void expect_near(const Vec3f& a, const Vec3f& b, float tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

}  // namespace restframe
