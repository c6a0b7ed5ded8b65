#pragma once

// CIEDE2000 (CIE 142-2001; Sharma, Wu and Dalal 2005) between XYZ under D65, white of luminance 1.

#include <cmath>
#include <numbers>

#include "physics/vectors.h"

namespace restframe::reference {

struct Lab {
  double l = 0, a = 0, b = 0;
};

inline Lab lab_from_xyz(const Vec3& xyz) {
  const auto f = [](double t) {
    return t > 216.0 / 24'389 ? std::cbrt(t) : (24'389.0 / 27 * t + 16) / 116;
  };
  const double x = f(xyz.x / 0.95047), y = f(xyz.y), z = f(xyz.z / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

inline double hue_degrees(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double hue = std::atan2(b, a) * 180 / std::numbers::pi;
  return hue < 0 ? hue + 360 : hue;
}

inline double delta_e_2000(const Lab& one, const Lab& two) {
  const auto degrees = [](double d) { return d * std::numbers::pi / 180; };
  const auto seventh = [](double c) {
    return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25.0, 7)));
  };
  const double mean_c = (std::hypot(one.a, one.b) + std::hypot(two.a, two.b)) / 2;
  const double g = 1 + 0.5 * (1 - seventh(mean_c));
  const double c1 = std::hypot(g * one.a, one.b), c2 = std::hypot(g * two.a, two.b);
  const double h1 = hue_degrees(g * one.a, one.b), h2 = hue_degrees(g * two.a, two.b);
  double dh = c1 * c2 == 0 ? 0 : h2 - h1;
  double h = c1 * c2 == 0 ? h1 + h2 : (h1 + h2) / 2;
  if (std::abs(dh) > 180) {
    h += h1 + h2 < 360 ? 180 : -180;
    dh += dh > 0 ? -360 : 360;
  }
  const double dl = two.l - one.l, dc = c2 - c1;
  const double dhue = 2 * std::sqrt(c1 * c2) * std::sin(degrees(dh / 2));
  const double l = (one.l + two.l) / 2, c = (c1 + c2) / 2;
  const double t = 1 - 0.17 * std::cos(degrees(h - 30)) + 0.24 * std::cos(degrees(2 * h)) +
                   0.32 * std::cos(degrees(3 * h + 6)) - 0.20 * std::cos(degrees(4 * h - 63));
  const double s_l = 1 + 0.015 * (l - 50) * (l - 50) / std::sqrt(20 + (l - 50) * (l - 50));
  const double s_c = 1 + 0.045 * c, s_h = 1 + 0.015 * c * t;
  const double turn = 60 * std::exp(-std::pow((h - 275) / 25, 2));
  const double r = -std::sin(degrees(turn)) * 2 * seventh(c);
  const double x = dl / s_l, y = dc / s_c, z = dhue / s_h;
  return std::sqrt(x * x + y * y + z * z + r * y * z);
}

}  // namespace restframe::reference
