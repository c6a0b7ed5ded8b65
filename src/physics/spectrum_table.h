#pragma once

#include <array>
#include <cstddef>

#include "physics/vectors.h"

namespace restframe {

// reflectance_basis (x, y, z) and daylight (w) for loops over rays: straight lines between values
// every 2.5 nm over the visible and an octave beyond, which is where the basis has a colour. Farther
// off, daylight is computed.
class SpectrumTable {
 public:
  SpectrumTable();

  Vec4f operator()(float wavelength) const {
    const float at = (wavelength - first) * (1.0F / step);
    if (!(at >= 0.0F && at < static_cast<float>(size - 1))) return far_off(wavelength);
    const auto index = static_cast<std::size_t>(at);
    const float fraction = at - static_cast<float>(index);
    return values_[index] + fraction * (values_[index + 1] - values_[index]);
  }

  // Made once, at the first call; to be fetched outside of loops.
  static const SpectrumTable& get();

 private:
  static constexpr float first = 180, step = 2.5F;
  static constexpr int size = 593;  // to 1660 nm
  static Vec4f far_off(float wavelength);
  std::array<Vec4f, size> values_;
};

}  // namespace restframe
