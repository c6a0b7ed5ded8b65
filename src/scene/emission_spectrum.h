#pragma once

#include <string>
#include <vector>

#include "physics/observer.h"
#include "scene/temporal_function.h"

namespace restframe {

// A line of a spectrum: a Gaussian.
struct EmissionLine {
  float wavelength = 0;  // nm
  float power = 0;       // watts where the emitter's strength is 1: of 555 nm, one has luminance 1
  float width = 1;       // nm, full at half maximum
};

// A measured spectrum: straight lines between its points, nothing beyond. Two points of one
// wavelength make a jump.
struct SpectrumPoint {
  float wavelength = 0;  // nm
  float value = 0;       // per nm, in any unit
};

// What something emits beside, or in place of, light of a colour or a temperature.
struct EmissionSpectrum {
  // Made to have luminance 1 where the strength is 1; or energy 1, if none of it is visible.
  std::vector<SpectrumPoint> points;
  std::vector<EmissionLine> lines;

  bool empty() const { return points.empty() && lines.empty(); }
};

inline constexpr std::size_t most_points = 10'000, most_lines = 256;  // of one spectrum

// A blackbody's, a measured one or lines, in place of D65 light of a colour.
inline bool has_own_spectrum(const TemporalNumber& temperature, const EmissionSpectrum& spectrum) {
  const bool is_hot = temperature.value > 0.0F || temperature.function != no_function;
  return is_hot || !spectrum.empty();
}

// Every reason why they can not be used together, in words.
std::vector<std::string> spectrum_faults(const TemporalNumber& temperature,
                                         const EmissionSpectrum& spectrum);
std::vector<std::string> band_faults(const WavelengthBand& band);

}  // namespace restframe
