#pragma once

#include <vector>

#include "frames/packet.h"
#include "scene/settings.h"

namespace restframe {

// When a shutter lets light through. Samples are spread over its time by the inverse of the
// cumulative distribution of its openness w over the time x in units of the shutter's: on a piece
// that begins with w and has the slope m, the light that passed within dx is w dx + m dx^2 / 2.
class Shutter {
 public:
  explicit Shutter(const ExposureSettings& settings);

  bool is_instant() const { return duration_ == 0.0; }

  // Seconds from the opening until the fraction u (from 0 to 1) of all light has passed.
  double quantile(double u) const;

  // The same for 16 at once, in place.
  void quantiles(Lanes<double>& u) const;

 private:
  struct Piece {
    double begin, width;     // fractions of the shutter's time
    double openness, slope;  // at its begin
    double passed_before;
  };

  double duration_ = 0;
  double all_ = 1;  // the light that passes in all
  std::vector<Piece> pieces_;
  bool is_even_ = true;  // as open all the time
};

}  // namespace restframe
