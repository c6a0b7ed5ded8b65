#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

// Points in the plane, in the cells of a grid, so that those in a box are found without looking at
// all of them. Points can be taken out again.
class CornerGrid {
 public:
  using Vec2 = glm::dvec2;

  // Holds `which` of `points`: about two a cell.
  void build(const std::vector<Vec2>& points, const std::vector<std::uint32_t>& which) {
    lower_ = Vec2(0);
    Vec2 upper(0);
    if (!which.empty()) lower_ = upper = points[which[0]];
    for (const std::uint32_t i : which) {
      lower_ = glm::min(lower_, points[i]);
      upper = glm::max(upper, points[i]);
    }
    choose_cells(upper - lower_, which.size());
    starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const std::uint32_t i : which) ++starts_[cell_of(points[i]) + 1];
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    ends_.assign(starts_.begin(), starts_.end() - 1);
    points_.resize(which.size());
    for (const std::uint32_t i : which) points_[ends_[cell_of(points[i])]++] = i;
  }

  std::int64_t cells() const { return std::int64_t{columns_} * rows_; }
  std::int64_t cells(const Vec2& lower, const Vec2& upper) const {
    return std::int64_t{column(upper.x) - column(lower.x) + 1} * (row(upper.y) - row(lower.y) + 1);
  }

  // Calls visit(point) for every point that may lie in the box, until it says stop; those of which
  // it says take_out are not met again. Returns the steps that this took.
  enum class Next : std::uint8_t { go_on, take_out, stop };
  template <class Visit>
  std::int64_t search(const Vec2& lower, const Vec2& upper, const Visit& visit) {
    std::int64_t steps = 0;
    const int last_column = column(upper.x), last_row = row(upper.y);
    for (int y = row(lower.y); y <= last_row; ++y) {
      for (int x = column(lower.x); x <= last_column; ++x) {
        const auto cell = static_cast<std::size_t>(y * columns_ + x);
        ++steps;
        for (std::size_t i = starts_[cell]; i < ends_[cell]; ++i, ++steps) {
          const Next next = visit(points_[i]);
          if (next == Next::stop) return steps;
          if (next == Next::take_out) std::swap(points_[i--], points_[--ends_[cell]]);
        }
      }
    }
    return steps;
  }

 private:
  void choose_cells(const Vec2& size, std::size_t count) {
    constexpr double a_cell = 2;
    const double cells = std::max(1.0, static_cast<double>(count) / a_cell);
    const double ratio = size.x > 0 && size.y > 0 ? size.x / size.y : size.x > 0 ? cells : 0;
    const double columns = std::clamp(std::sqrt(cells * ratio), 1.0, cells);
    columns_ = static_cast<int>(columns);
    rows_ = static_cast<int>(std::max(1.0, cells / columns));
    per_length_ = Vec2(size.x > 0 ? columns_ / size.x : 0, size.y > 0 ? rows_ / size.y : 0);
  }

  static int within(double place, int count) {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
  }
  int column(double x) const { return within((x - lower_.x) * per_length_.x, columns_); }
  int row(double y) const { return within((y - lower_.y) * per_length_.y, rows_); }
  std::size_t cell_of(const Vec2& p) const {
    return static_cast<std::size_t>(row(p.y) * columns_ + column(p.x));
  }

  Vec2 lower_{0}, per_length_{0};
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> starts_, ends_;  // of each cell in points_
  std::vector<std::uint32_t> points_;
};

}  // namespace restframe
