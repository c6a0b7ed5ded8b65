#include "scene/emission_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/spectrum.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

bool is_wavelength(double x) {
  return x >= shortest_wavelength && x <= longest_wavelength;
}

std::string wavelength_fault(const std::string& what, double wavelength) {
  return fmt::format("{} is at {} nm, must be from {} to {}", what, wavelength, shortest_wavelength,
                     longest_wavelength);
}

void check_points(const std::vector<SpectrumPoint>& points, Faults& faults) {
  if (points.empty()) return;
  if (points.size() > most_points) {
    faults.push_back(
        fmt::format("the spectrum has {} points, must be at most {}", points.size(), most_points));
  }
  bool shines = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [wavelength, value] = points[i];
    const std::string what = fmt::format("point {} of the spectrum", i);
    if (!is_wavelength(static_cast<double>(wavelength))) {
      faults.push_back(wavelength_fault(what, static_cast<double>(wavelength)));
    }
    if (!(value >= 0.0F && std::isfinite(value))) {
      faults.push_back(fmt::format("{} is {}, must be at least 0 and finite", what, value));
    }
    if (i > 0 && wavelength < points[i - 1].wavelength) {
      faults.push_back(what + " is at a shorter wavelength than the one before");
    }
    const bool has_width = i > 0 && wavelength > points[i - 1].wavelength;
    shines = shines || (has_width && (value > 0.0F || points[i - 1].value > 0.0F));
  }
  if (!shines && faults.empty()) faults.emplace_back("the spectrum is 0 everywhere");
}

void check_lines(const std::vector<EmissionLine>& lines, Faults& faults) {
  if (lines.size() > most_lines) {
    faults.push_back(
        fmt::format("there are {} lines, must be at most {}", lines.size(), most_lines));
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const EmissionLine& line = lines[i];
    const std::string what = fmt::format("line {}", i);
    const auto wavelength = static_cast<double>(line.wavelength);
    if (!is_wavelength(wavelength)) faults.push_back(wavelength_fault(what, wavelength));
    if (!(line.power >= 0.0F && std::isfinite(line.power))) {
      faults.push_back(
          fmt::format("the power of {} is {}, must be at least 0 and finite", what, line.power));
    }
    if (!(line.width > 0.0F && line.width <= line.wavelength)) {
      faults.push_back(
          fmt::format("the width of {} is {} nm, must be above 0 and at most its wavelength", what,
                      line.width));
    }
  }
}

}  // namespace

std::vector<std::string> spectrum_faults(const TemporalNumber& temperature,
                                         const EmissionSpectrum& spectrum) {
  Faults faults;
  const auto kelvin = static_cast<double>(temperature.value);
  if (kelvin > 0 && kelvin < coldest_kelvin) {
    faults.push_back(fmt::format("the temperature is {}, must be {} or more, or 0 for none", kelvin,
                                 coldest_kelvin));
  }
  const bool is_hot = kelvin > 0 || temperature.function != no_function;
  if (is_hot && !spectrum.points.empty()) {
    faults.emplace_back("a temperature and a measured spectrum exclude each other");
  }
  check_points(spectrum.points, faults);
  check_lines(spectrum.lines, faults);
  return faults;
}

std::vector<std::string> band_faults(const WavelengthBand& band) {
  const auto& [from, to] = band;
  Faults faults;
  if (!is_wavelength(from)) faults.push_back(wavelength_fault("from", from));
  if (!is_wavelength(to)) faults.push_back(wavelength_fault("to", to));
  if (faults.empty() && !(to >= from * 1.001)) {
    faults.push_back(
        fmt::format("from {} to {} nm: to must be above from, by a thousandth at least", from, to));
  }
  return faults;
}

}  // namespace restframe
