#pragma once

#include <span>
#include <string>

namespace restframe {

// The paper's figure 5: the factor alpha of equation 3 (blink_rate_factor) against viewing
// direction, from -90 degrees (approaching) to 90 (receding), a curve for each speed (fractions
// of c). The same bytes for the same speeds.

// A row every `step` degrees, and one at 90: angle_degrees, then a column a speed, called "0.9c".
std::string curves_csv(std::span<const double> speeds, double step);

// A drawing with the factor at -90 degrees, the cross-over angles (where alpha is 1) and the "pure"
// time dilation at 0 degrees marked on every curve.
std::string curves_svg(std::span<const double> speeds);

}  // namespace restframe
