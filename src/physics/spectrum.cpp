#include "physics/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace restframe {
namespace {

#include "physics/cie_tables.inc"
#include "physics/reflectance_table.inc"

constexpr double table_step = 5;
constexpr int table_size = 95;
static_assert(std::size(d65) == table_size && std::size(reflectances) == table_size);

// 2018 CODATA, exact: h c / k in nm K, and 2 h c^2 in W nm^4 / m^2 (a radiance per nm).
constexpr double second_radiation = 1.4387768775039338e7;
constexpr double first_radiation = 1.1910429723971884e20;

struct TablePlace {
  int index;
  double fraction;
};

TablePlace place_in(double wavelength, double step, int size) {
  const double at = (wavelength - visible_from) / step;
  const int index = std::clamp(static_cast<int>(at), 0, size - 2);
  return {index, at - index};
}

double matching_at(const double* table, int index) {
  return index < 0 || index >= table_size ? 0.0 : table[index];
}

// Lagrange's polynomial through four neighbours; the observer's functions are 0 beyond their ends.
double cubic(const double* table, const TablePlace& p) {
  const double f = p.fraction;
  const double sum = -f * (f - 1) * (f - 2) / 6 * matching_at(table, p.index - 1) +
                     (f + 1) * (f - 1) * (f - 2) / 2 * matching_at(table, p.index) -
                     (f + 1) * f * (f - 2) / 2 * matching_at(table, p.index + 1) +
                     (f + 1) * f * (f - 1) / 6 * matching_at(table, p.index + 2);
  return std::max(0.0, sum);
}

constexpr int fine_size = 471;  // every nanometre
using FineTable = std::array<Vec3, fine_size>;

FineTable make_matching_table() {
  FineTable table;
  for (int i = 0; i < fine_size; ++i) {
    const TablePlace p = place_in(visible_from + i, table_step, table_size);
    table[static_cast<std::size_t>(i)] = {cubic(matching_x, p), cubic(matching_y, p),
                                          cubic(matching_z, p)};
  }
  return table;
}

double daylight_table(double wavelength) {
  const TablePlace p = place_in(wavelength, table_step, table_size);
  return d65[p.index] + p.fraction * (d65[p.index + 1] - d65[p.index]);
}

// The columns of the result: XYZ of red, green and blue, whose sum is `white`.
Mat3 xyz_from_linear(const Vec3& white) {
  const auto primary = [](double x, double y) { return Vec3(x / y, 1, (1 - x - y) / y); };
  // Rec. ITU-R BT.709, item 1.2
  const Mat3 primaries(primary(0.64, 0.33), primary(0.30, 0.60), primary(0.15, 0.06));
  const Vec3 luminances = glm::inverse(primaries) * white;
  return {primaries[0] * luminances.x, primaries[1] * luminances.y, primaries[2] * luminances.z};
}

struct Daylight {
  double scale;  // of the table, to luminance 1
  Mat3 linear_from_xyz;
};

const Daylight& daylight_constants() {
  static const Daylight constants = [] {
    const Vec3 xyz =
        visible_integral([](double w) { return daylight_table(w) * color_matching(w); });
    return Daylight{1 / xyz.y, glm::inverse(xyz_from_linear(xyz / xyz.y))};
  }();
  return constants;
}

// (1 / wavelength)^5 / (exp(x) - 1), in units of 1 / nm^5; x = h nu / k T.
double planck_shape(double wavelength, double x) {
  const double w = 1 / wavelength;
  if (x > 700) return 0;  // less than the least number
  return w * w * w * w * w / std::expm1(x);
}

// Luminance of planck_shape by temperature. Its logarithm, less that of 600 nm alone, hardly bends
// over the logarithm of temperature.
class LuminanceTable {
 public:
  LuminanceTable() {
    for (int i = 0; i < size; ++i) {
      const double kelvin = coldest_kelvin * std::exp(i * step());
      double luminance = 0;
      for (double w = visible_from; w <= visible_to; w += 2) {
        luminance += 2 * color_matching(w).y * planck_shape(w, second_radiation / (w * kelvin));
      }
      logs_[static_cast<std::size_t>(i)] = std::log(luminance / typical(kelvin));
    }
  }
  double operator()(double kelvin) const {
    const double at = std::log(kelvin / coldest_kelvin) / step();
    const int index = std::clamp(static_cast<int>(at), 0, size - 2);
    const auto i = static_cast<std::size_t>(index);
    return typical(kelvin) * std::exp(logs_[i] + (at - index) * (logs_[i + 1] - logs_[i]));
  }

 private:
  static constexpr int size = 1024;
  static double step() { return std::log(hottest_kelvin / coldest_kelvin) / (size - 1); }
  static double typical(double kelvin) {
    return planck_shape(600, second_radiation / (600 * kelvin));
  }
  std::array<double, size> logs_{};
};

double smooth_step(double x) {
  return x * x * (3 - 2 * x);
}

}  // namespace

Vec3 color_matching(double wavelength) {
  static const FineTable table = make_matching_table();
  if (!(wavelength >= visible_from && wavelength <= visible_to)) return Vec3(0);
  const TablePlace p = place_in(wavelength, 1, fine_size);
  const auto i = static_cast<std::size_t>(p.index);
  return table[i] + p.fraction * (table[i + 1] - table[i]);
}

Vec3 linear_from_xyz(const Vec3& xyz) {
  return daylight_constants().linear_from_xyz * xyz;
}

double daylight(double wavelength) {
  const double scale = daylight_constants().scale;
  const auto tail = [&](double end) {
    return daylight_table(end) * planck(wavelength, daylight_kelvin) / planck(end, daylight_kelvin);
  };
  if (wavelength < visible_from) return scale * tail(visible_from);
  return scale * (wavelength > visible_to ? tail(visible_to) : daylight_table(wavelength));
}

double planck(double wavelength, double kelvin) {
  if (!(kelvin > 0 && wavelength > 0)) return 0;
  return first_radiation * planck_shape(wavelength, second_radiation / (wavelength * kelvin));
}

Blackbody::Blackbody(double kelvin) {
  static const LuminanceTable luminance;
  // A temperature that is not a number counts as the coldest.
  const double t = kelvin > coldest_kelvin ? std::min(kelvin, hottest_kelvin) : coldest_kelvin;
  inverse_wavelength_ = second_radiation / t;
  scale_ = 1 / luminance(t);
}

double Blackbody::operator()(double wavelength) const {
  return scale_ * planck_shape(wavelength, inverse_wavelength_ / wavelength);
}

Vec3 reflectance_basis(double wavelength) {
  const double within = std::clamp(wavelength, visible_from, visible_to);
  const TablePlace p = place_in(within, table_step, table_size);
  const auto at = [](int i) {
    return Vec3(reflectances[i][0], reflectances[i][1], reflectances[i][2]);
  };
  const Vec3 table = at(p.index) + p.fraction * (at(p.index + 1) - at(p.index));
  const double octaves = std::abs(std::log2(wavelength / within));
  return glm::mix(table, Vec3(1.0 / 3), smooth_step(std::min(octaves, 1.0)));
}

// Simpson's rule in every nanometre.
Vec3 visible_integral(const std::function<Vec3(double)>& spectrum) {
  Vec3 sum(0);
  for (double w = visible_from; w < visible_to; ++w) {
    sum += (spectrum(w) + 4.0 * spectrum(w + 0.5) + spectrum(w + 1)) / 6.0;
  }
  return sum;
}

}  // namespace restframe
