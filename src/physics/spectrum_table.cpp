#include "physics/spectrum_table.h"

#include "physics/spectrum.h"

namespace restframe {

SpectrumTable::SpectrumTable() {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double wavelength = static_cast<double>(first + step * static_cast<float>(i));
    values_[i] = Vec4f(Vec3f(reflectance_basis(wavelength)), daylight(wavelength));
  }
}

Vec4f SpectrumTable::far_off(float wavelength) {
  return {Vec3f(1.0F / 3.0F), daylight(static_cast<double>(wavelength))};
}

const SpectrumTable& SpectrumTable::get() {
  static const SpectrumTable table;
  return table;
}

}  // namespace restframe
