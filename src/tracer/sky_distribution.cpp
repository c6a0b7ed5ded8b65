#include "tracer/sky_distribution.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/parallel.h"

namespace restframe {
namespace {

constexpr double pi = glm::pi<double>();

double weight(const Vec3f& radiance) {
  return (static_cast<double>(radiance.x) + static_cast<double>(radiance.y) +
          static_cast<double>(radiance.z)) /
         3;
}

// A cell's corners' weights.
struct Corners {
  double upper_left, upper_right, lower_left, lower_right;

  double over_mean(double s, double t) const {
    const double of_cell = mean();
    return of_cell > 0.0 ? at(s, t) / of_cell : 1.0;
  }
  double mean() const { return 0.25 * (upper_left + upper_right + lower_left + lower_right); }
  double at(double s, double t) const {
    const double upper = upper_left + s * (upper_right - upper_left);
    const double lower = lower_left + s * (lower_right - lower_left);
    return upper + t * (lower - upper);
  }
};

Corners weights(const SkyMap& map, int column, int row) {
  const SkyCorners c = corners(map, {column - 1, row - 1});
  return {weight(c.upper_left), weight(c.upper_right), weight(c.lower_left), weight(c.lower_right)};
}

// Distributed over 0..1 with a density that goes from `a` to `b` in a straight line.
double linearly_distributed(double a, double b, double u) {
  if (!(a + b > 0.0)) return u;
  return std::min(1.0, u * (a + b) / (a + std::sqrt(a * a + u * (b * b - a * a))));
}

// Which of the steps of a cumulative distribution holds u, and where in it.
template <class T>
struct Step {
  int index;
  double within;
};
template <class T>
Step<T> find_step(const T* ends, int count, double u) {
  const T* found = std::upper_bound(ends, ends + count, static_cast<T>(u));
  const int index = std::min(static_cast<int>(found - ends), count - 1);
  const double begin = index > 0 ? static_cast<double>(ends[index - 1]) : 0.0;
  const double width = static_cast<double>(ends[index]) - begin;
  return {index, width > 0.0 ? std::clamp((u - begin) / width, 0.0, 1.0) : 0.5};
}

}  // namespace

SkyDistribution::Rows SkyDistribution::rows(int row) const {
  return {std::max(0.0, row - 0.5), std::min(static_cast<double>(map_.height), row + 0.5)};
}

SkyDistribution::SkyDistribution(const SkyMap& map)
    : map_(map),
      row_ends_(static_cast<std::size_t>(map.height) + 1),
      column_ends_((static_cast<std::size_t>(map.height) + 1) *
                   static_cast<std::size_t>(map.width)) {
  const auto width = static_cast<std::size_t>(map.width);
  std::vector<double> row_weights(row_ends_.size());
  parallel_for(row_ends_.size(), [&](std::size_t row) {
    double sum = 0;
    std::vector<double> ends(width);
    for (std::size_t column = 0; column < width; ++column) {
      sum += weights(map_, static_cast<int>(column), static_cast<int>(row)).mean();
      ends[column] = sum;
    }
    for (std::size_t column = 0; column < width; ++column) {
      column_ends_[row * width + column] =
          sum > 0.0 ? static_cast<float>(ends[column] / sum)
                    : static_cast<float>(column + 1) / static_cast<float>(width);
    }
    const Rows r = rows(static_cast<int>(row));
    row_weights[row] =
        sum * (std::cos(pi * r.begin / map_.height) - std::cos(pi * r.end / map_.height));
  });
  for (std::size_t row = 0; row < row_ends_.size(); ++row) {
    total_ += row_weights[row];
    row_ends_[row] = total_;
  }
  for (double& end : row_ends_) end = total_ > 0.0 ? end / total_ : 1.0;
}

double SkyDistribution::cell_chance(int column, int row) const {
  const auto r = static_cast<std::size_t>(row);
  const float* ends = &column_ends_[r * static_cast<std::size_t>(map_.width)];
  const double of_row = row_ends_[r] - (row > 0 ? row_ends_[r - 1] : 0.0);
  const float before = column > 0 ? ends[column - 1] : 0.0F;
  return of_row * static_cast<double>(ends[column] - before);
}

// A pixel's place times its size in angles is sin(from zenith) (2 pi / width) (pi / height) sr.
double SkyDistribution::per_steradian(const CellNumber& cell, double over_cell, double sine) const {
  const Rows r = rows(cell.row);
  const double pixel = sine * (2 * pi / map_.width) * (pi / map_.height);
  return cell_chance(cell.column, cell.row) * over_cell / ((r.end - r.begin) * pixel);
}

SkyDistribution::Chosen SkyDistribution::choose(double u, double v) const {
  const auto in_rows = find_step(row_ends_.data(), map_.height + 1, v);
  const int row = in_rows.index;
  const float* ends =
      &column_ends_[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.width)];
  const auto in_columns = find_step(ends, map_.width, u);
  const int column = in_columns.index;
  const Corners w = weights(map_, column, row);
  const double t = linearly_distributed(w.upper_left + w.upper_right, w.lower_left + w.lower_right,
                                        in_rows.within);
  const double s = linearly_distributed(w.at(0, t), w.at(1, t), in_columns.within);
  const Rows r = rows(row);
  const SkyPlace place{column - 0.5 + s, r.begin + t * (r.end - r.begin)};
  const Vec3 direction = sky_direction(map_, place);
  const double sine = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  return {direction, per_steradian({column, row}, w.over_mean(s, t), sine)};
}

double SkyDistribution::density(const Vec3& direction) const {
  SkyPlace place = sky_place(map_, direction);
  // The last half column is the left half of the first cell.
  if (place.x >= map_.width - 0.5) place.x -= map_.width;
  const int column = std::clamp(static_cast<int>(std::floor(place.x + 0.5)), 0, map_.width - 1);
  const int row = std::clamp(static_cast<int>(std::floor(place.y + 0.5)), 0, map_.height);
  const Rows r = rows(row);
  const double s = place.x - (column - 0.5), t = (place.y - r.begin) / (r.end - r.begin);
  const double sine = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  return per_steradian({column, row}, weights(map_, column, row).over_mean(s, t), sine);
}

}  // namespace restframe
