#include "tracer/shutter.h"

#include <algorithm>
#include <cmath>

namespace restframe {
namespace {

using Curve = std::vector<std::pair<double, double>>;

Curve curve_of(const ExposureSettings& settings) {
  switch (settings.shape) {
    case ShutterShape::box:
      break;
    case ShutterShape::triangle:
      return {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}};
    case ShutterShape::curve:
      return settings.curve;
  }
  return {{0.0, 1.0}, {1.0, 1.0}};
}

double largest_openness(const Curve& curve) {
  double largest = 0.0;
  for (const auto& [x, openness] : curve) largest = std::max(largest, openness);
  return largest;
}

}  // namespace

Shutter::Shutter(const ExposureSettings& settings)
    : duration_(settings.shutter), is_even_(settings.shape == ShutterShape::box) {
  const Curve curve = curve_of(settings);
  const double largest = largest_openness(curve);
  double passed = 0.0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const double width = curve[i + 1].first - curve[i].first;
    const double from = curve[i].second / largest;
    const double to = curve[i + 1].second / largest;
    const double passes = 0.5 * (from + to) * width;
    if (!(passes > 0.0)) continue;
    pieces_.push_back({curve[i].first, width, from, (to - from) / width, passed});
    passed += passes;
  }
  all_ = passed;
}

double Shutter::quantile(double u) const {
  const double passed = u * all_;
  std::size_t i = pieces_.size() - 1;
  while (i > 0 && pieces_[i].passed_before > passed) --i;
  const Piece& piece = pieces_[i];
  const double here = passed - piece.passed_before;
  // The root of w dx + m dx^2 / 2 = here that is free of differences.
  const double w = piece.openness;
  const double sum = w + std::sqrt(std::max(0.0, w * w + 2.0 * piece.slope * here));
  const double dx = here > 0.0 ? std::min(piece.width, 2.0 * here / sum) : 0.0;
  return duration_ * (piece.begin + dx);
}

void Shutter::quantiles(Lanes<double>& u) const {
  if (is_even_) {
    for (int i = 0; i < packet_size; ++i) u[i] *= duration_;
    return;
  }
  for (int i = 0; i < packet_size; ++i) u[i] = quantile(u[i]);
}

}  // namespace restframe
