#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace restframe {

// Sums over directions that were chosen, for each of equal parts of the sphere.
class SolidAngles {
 public:
  explicit SolidAngles(std::size_t parts) : inverse_(parts), squares_(parts) {}

  void add(std::size_t part, double density) {
    inverse_[part] += 1 / density;
    squares_[part] += 1 / (density * density);
  }

  // Of so many choices, the mean of 1 / density over a part's indicator is the part's solid angle, to so many
  // standard deviations.
  void expect_equal(double choices, double deviations) const {
    const double solid_angle = 4 * std::numbers::pi / static_cast<double>(inverse_.size());
    for (std::size_t part = 0; part < inverse_.size(); ++part) {
      const double mean = inverse_[part] / choices;
      const double error = std::sqrt((squares_[part] / choices - mean * mean) / choices);
      EXPECT_NEAR(mean, solid_angle, deviations * error) << part;
    }
  }

 private:
  std::vector<double> inverse_, squares_;
};

}  // namespace restframe
