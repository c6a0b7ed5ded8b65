#pragma once

#include <cmath>

#include "physics/vectors.h"
#include "scene/settings.h"

namespace restframe {

// How scene-linear light becomes what a screen shows.
struct Development {
  float gain = 1;
  ViewTransform view = ViewTransform::srgb;
};
inline Development development(const OutputSettings& settings) {
  return {static_cast<float>(std::exp2(settings.exposure)), settings.view};
}

// From linear Rec. 709 of any brightness, times the gain, to that of a screen, of which white is 1.
//
// `srgb` is the light itself; what is brighter than white is left to be cut off.
//
// `filmic` lays the curve of a film over the brightest component and scales the others along, so that
// hues stay: laid over each component, it would turn a bright red yellow. The curve is Narkowicz's fit
// to ACES's reference and output transforms for screens (2015, "ACES Filmic Tone Mapping Curve", with
// his factor 0.6 of exposure). Beyond white all would have the same brightness, and D^4 = 39,600 comes
// easily: there, light pales with its logarithm instead, and is half white 12 stops above white. So a
// red that beams stays apart from white, and from the same red at rest.
Vec3f developed(const Vec3f& linear, const Development& development);

}  // namespace restframe
