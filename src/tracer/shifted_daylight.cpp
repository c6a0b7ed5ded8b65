#include <algorithm>
#include <cmath>

#include "tracer/emitter_spectrum.h"

namespace restframe {
namespace {

// From D of 1/256 to 256; others are summed when they are met.
constexpr double octaves = 8;
constexpr int steps_an_octave = 96;
// The table of daylight is far from what is visible, and what is there is smooth.
constexpr double far_off = 2;  // octaves
constexpr int size = static_cast<int>(2 * octaves) * steps_an_octave + 1;

}  // namespace

ShiftedDaylight::ShiftedDaylight(const Observer& observer) : observer_(observer) {
  for (int i = 0; i < size; ++i) {
    matrices_.push_back(matrix_at(std::exp2(static_cast<double>(i) / steps_an_octave - octaves)));
  }
}

// Columns: what becomes of red, green and blue.
glm::mat3 ShiftedDaylight::matrix_at(double doppler) const {
  const SpectrumTable& table = SpectrumTable::get();
  const bool is_near = std::abs(std::log2(doppler)) < far_off;
  const auto d = static_cast<float>(doppler);
  glm::mat3 columns(0.0F);
  for (const Observer::Part& part : is_near ? observer_.fine_parts() : observer_.parts()) {
    const Vec4f values = table(part.wavelength * d);
    for (int i = 0; i < 3; ++i) columns[i] += part.rgb * (d * values.w * values[i]);
  }
  return columns;
}

Vec3f ShiftedDaylight::operator()(const Vec3f& color, double doppler) const {
  const double at = (std::log2(doppler) + octaves) * steps_an_octave;
  if (!(at >= 0 && at < size - 1)) return matrix_at(doppler) * color;
  const auto index = static_cast<std::size_t>(at);
  const auto fraction = static_cast<float>(at - static_cast<double>(index));
  return glm::mix(matrices_[index] * color, matrices_[index + 1] * color, fraction);
}

}  // namespace restframe
