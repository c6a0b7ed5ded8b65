#pragma once

#include <optional>
#include <vector>

#include "scene/sky_map.h"

namespace restframe {

// Directions in proportion to a map's radiance, as it is looked up between its pixels. The sky is
// divided into cells between four pixels' centres (half cells at the poles); within a cell the
// radiance is bilinear, and so is the density, over the map's plane. Weights are the means of red,
// green and blue.
class SkyDistribution {
 public:
  // `map` must outlive the distribution.
  explicit SkyDistribution(const SkyMap& map);

  // All is dark: there is nothing to choose.
  bool empty() const { return !(total_ > 0.0); }

  struct Chosen {
    Vec3 direction{0};   // unit, the map's axes
    double density = 0;  // per steradian
  };
  // Two numbers in [0, 1) choose.
  Chosen choose(double u, double v) const;

  // Per steradian, with which choose() takes that direction.
  double density(const Vec3& direction) const;

 private:
  struct Rows {
    double begin = 0, end = 0;  // in pixels from the top
  };
  struct CellNumber {
    int column = 0, row = 0;
  };
  Rows rows(int row) const;
  double cell_chance(int column, int row) const;
  // over_cell: of the density there, over its mean in the cell; sine: of the angle from the zenith.
  double per_steradian(const CellNumber& cell, double over_cell, double sine) const;

  const SkyMap& map_;
  double total_ = 0;
  std::vector<double> row_ends_;  // cumulative chances of the rows of cells, one more than pixels'
  std::vector<float> column_ends_;  // of each row, its cells' within it
};

}  // namespace restframe
