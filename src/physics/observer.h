#pragma once

// Who looks at a spectrum, and as what colour it is shown.

#include <optional>
#include <span>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

// Wavelengths in nanometres, the shorter one first.
struct WavelengthBand {
  double from = 0, to = 0;
};

// How far bands, lines and tables may reach.
inline constexpr double shortest_wavelength = 10, longest_wavelength = 100'000;

// The eye (CIE 1931), or a camera for another band in false colours: its thirds, of equal ratios of
// wavelengths, are shown as red (the longest), green and blue, each as the energy in it over that of
// D65 light of luminance 1. So white is white in any band; where D65 has less than a billionth of what
// it has at 560 nm (below 60 nm), that billionth counts as white.
class Observer {
 public:
  explicit Observer(const std::optional<WavelengthBand>& band);

  // The colour of light that has spectral radiance 1 per nanometre in a part of what is seen.
  struct Part {
    float wavelength = 0;
    Vec3f rgb{0};
  };

  // For u in [0, 1): a wavelength chosen with about the density with which it matters, and the
  // response there over that density. The mean over u of rgb times spectral radiance is the colour.
  Part sample(float u) const {
    const float at = u * static_cast<float>(pieces_.size());
    const auto index = static_cast<std::size_t>(at);
    const Piece& piece = pieces_[index < pieces_.size() ? index : pieces_.size() - 1];
    return {piece.begin + (at - static_cast<float>(index)) * piece.width, piece.rgb};
  }

  // To be summed over, where there is no chance: some nanometres each.
  std::span<const Part> parts() const { return parts_; }
  // Likewise, and fine enough for spectra as jagged as daylight's.
  std::span<const Part> fine_parts() const { return fine_parts_; }

  // The colour of one watt of a single wavelength.
  Vec3 response(double wavelength) const;

 private:
  struct Piece {
    float begin = 0, width = 0;
    Vec3f rgb{0};
  };
  void look_at_visible();
  void look_at(const WavelengthBand& band);
  Vec3 mean_response(double from, double to) const;

  std::optional<WavelengthBand> band_;
  Vec3 white_{1};  // energy in each third; of a band
  std::vector<Piece> pieces_;
  std::vector<Part> parts_, fine_parts_;
};

}  // namespace restframe
