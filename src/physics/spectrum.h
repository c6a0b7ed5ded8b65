#pragma once

// Light by wavelength: what eyes make of it, what lamps send, what coloured surfaces reflect.
// Wavelengths are those in vacuum, in nanometres. Spectra are per nanometre, in a unit in which a
// watt of 555 nm has luminance 1: the unit of linear Rec. 709, whose white has luminance 1.

#include <functional>

#include "physics/vectors.h"

namespace restframe {

// What eyes see lies in between.
inline constexpr double visible_from = 360, visible_to = 830;

// The CIE 1931 2-degree observer: x, y, z of one watt; 0 where nothing is visible. CIE 15's table
// of 5 nm, Lagrange's cubic to 1 nm as recommended there, straight lines in between.
Vec3 color_matching(double wavelength);

// Linear Rec. 709 with D65 as white: (1, 1, 1) is D65 light of luminance 1.
Vec3 linear_from_xyz(const Vec3& xyz);

// The same of one watt of a single wavelength.
inline Vec3 rgb_matching(double wavelength) {
  return linear_from_xyz(color_matching(wavelength));
}

// Illuminant D65 of luminance 1. CIE's table from 360 to 830 nm; beyond, tails of a blackbody of
// D65's correlated colour temperature that meet the table: smooth, so that something is there to be
// shifted into sight, and without the ultraviolet's lines of absorption, which are the atmosphere's.
double daylight(double wavelength);
inline constexpr double daylight_kelvin = 6504;

// Planck's law: spectral radiance of a blackbody, W/(m^2 sr nm). 0 for temperatures not above 0.
double planck(double wavelength, double kelvin);

// What blackbodies may be asked for: colder ones have no luminance to speak of.
inline constexpr double coldest_kelvin = 500, hottest_kelvin = 1e8;

// A blackbody of luminance 1. Temperatures outside of the range are taken to its ends.
class Blackbody {
 public:
  explicit Blackbody(double kelvin);
  double operator()(double wavelength) const;

 private:
  double inverse_wavelength_;  // 1 / (wavelength at which h nu = k T)
  double scale_;
};

// How much of each wavelength a red, a green and a blue surface (Rec. 709 primaries) reflect: three
// functions in 0..1 that sum to 1 everywhere, as smooth as can be (Mallett and Yuksel 2019), so that
// r R + g G + b B is seen under D65 as (r, g, b). The table ends with what is visible. Within an
// octave from there all three go smoothly to a third, and stay: what is far off in the infrared or
// ultraviolet has no colour, only a brightness, white remains white, and nothing turns black.
Vec3 reflectance_basis(double wavelength);

// The integral over what is visible; exact where `spectrum` is a product of two of the above.
Vec3 visible_integral(const std::function<Vec3(double)>& spectrum);

}  // namespace restframe
