#include <fmt/format.h>

#include <algorithm>

#include "scene/validate_data.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

void check_length(double value, const char* what, Faults& faults) {
  if (value >= 0 && value <= farthest) return;  // false for NaN
  faults.push_back(fmt::format("{} is {}, must be from 0 to 1e100", what, value));
}

}  // namespace

std::optional<std::string> shutter_curve_fault(const ShutterCurve& curve) {
  double last = 0;
  double largest = 0;
  for (const auto& [x, openness] : curve) {
    if (!(x >= last && x <= 1)) {
      return fmt::format("{} is out of place: from 0 to 1, none below the one before", x);
    }
    if (!(openness >= 0 && openness <= farthest)) {
      return fmt::format("openness is {}, must be at least 0 and finite", openness);
    }
    last = x;
    largest = std::max(largest, openness);
  }
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const bool lasts = curve[i + 1].first > curve[i].first;
    if (lasts && std::max(curve[i].second, curve[i + 1].second) > 0) return std::nullopt;
  }
  return "it is never open";
}

void validate_exposure(const ExposureSettings& exposure, Faults& faults) {
  check_length(exposure.shutter, "exposure: shutter", faults);
  if (!(exposure.count >= 1 && exposure.count <= most_exposures)) {
    faults.push_back(
        fmt::format("exposure: count is {}, must be from 1 to {}", exposure.count, most_exposures));
  }
  check_length(exposure.interval, "exposure: interval", faults);
  if (exposure.count > 1 && exposure.interval == 0) {
    faults.push_back("exposure: interval is 0, must be above 0 with several exposures");
  }
  if (exposure.shape != ShutterShape::curve) return;
  const auto fault = shutter_curve_fault(exposure.curve);
  if (fault) faults.push_back("exposure: opening: " + *fault);
}

void validate_lens(const Camera& camera, Faults& faults) {
  check_length(camera.aperture, "camera: aperture", faults);
  check_length(camera.rolling, "camera: rolling", faults);
  if (!(camera.focus > 0 && camera.focus <= farthest)) {
    faults.push_back(
        fmt::format("camera: focus is {}, must be above 0 and at most 1e100", camera.focus));
  }
  if (!camera.stereo) return;
  check_length(camera.stereo->separation, "camera: stereo: separation", faults);
  check_length(camera.stereo->convergence, "camera: stereo: convergence", faults);
}

}  // namespace restframe
