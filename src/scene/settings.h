#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "physics/observer.h"
#include "scene/pixel_window.h"

namespace restframe {

struct AnimationSettings {
  double rate = 10;  // pictures a second of the camera's own time
  double start = 0;
  int pictures = 1;
};

// How open a shutter is over the time that it takes.
enum class ShutterShape : std::uint8_t { box, triangle, curve };

// (Fraction of the shutter's time, openness >= 0), piecewise linear; closed before the first and
// after the last. Fractions from 0 to 1 in order (two may be equal: a jump), open at some time.
using ShutterCurve = std::vector<std::pair<double, double>>;

// Why `curve` breaks these rules, or nothing.
std::optional<std::string> shutter_curve_fault(const ShutterCurve& curve);

inline constexpr int most_exposures = 65'536;  // of one picture

// How the exposures of one picture go together.
enum class Combine : std::uint8_t { sum, mean, max };

// `count` exposures, `interval` seconds from opening to opening, each `shutter` seconds long; the
// first one opens at the picture's time. All in the camera's own time.
struct ExposureSettings {
  double shutter = 0;  // 0: an instant
  ShutterShape shape = ShutterShape::box;
  ShutterCurve curve;  // of the shape `curve`
  int count = 1;
  double interval = 0.5;
  Combine combine = Combine::sum;  // alpha: 1 - product of (1 - alpha)
};

// Their spread says how sure a pixel is.
inline constexpr int least_measured_samples = 4;

enum class IntegratorKind : std::uint8_t {
  preview,  // base colour times |cos| plus emission; no lights
  path,     // light transport
};

struct RenderSettings {
  int width = 1280, height = 720;  // of the display: what the field of view fills
  int overscan = 0;                // pixels around the display that are rendered, too
  // Only these pixels; of the display and what is around it.
  std::optional<PixelWindow> crop;
  int samples = 16;  // a pixel, for each exposure; the most, if noise is above 0
  // The relative standard error of pixels' luminance at which a block of them is done (see
  // Replicates::noise); 0: never.
  double noise = 0;
  IntegratorKind integrator = IntegratorKind::preview;
  int depth = 8;         // the most surfaces that scatter a path
  bool doppler = false;  // wavelengths shift, and light is followed by wavelength
  bool beaming = false;
  // The band that is seen, in false colours, instead of what is visible; with doppler.
  std::optional<WavelengthBand> observe;
  std::uint64_t seed = 0;
};

inline constexpr int most_pixels_a_side = 32'768, most_overscan = 4'096;

inline PixelWindow display_window(const RenderSettings& render) {
  return {0, 0, render.width, render.height};
}

// The display and what is around it. Which part of it is rendered changes no pixel.
inline PixelWindow whole_window(const RenderSettings& render) {
  const int around = render.overscan;
  return {-around, -around, render.width + 2 * around, render.height + 2 * around};
}

// What pictures hold.
inline PixelWindow picture_window(const RenderSettings& render) {
  return render.crop.value_or(whole_window(render));
}

// Layers of an EXR by the names of the scene file (design, section 7).
enum class Layer : std::uint8_t {
  beauty,
  z,
  time,
  doppler,
  normal,
  position,
  uv,
  id,
  variance,
  samples,
  depth,
  apparent_normal,
  crypto_object,
  crypto_material,
  crypto_asset,
  emission,
  direct,
  indirect,
  reflection,
  transmission,
  lights,
  albedo,
  motion,
};

enum class Compression : std::uint8_t { none, rle, zips, zip, piz, pxr24, dwaa, dwab, b44, b44a };

inline constexpr double most_compression_level =
    10'000;  // of DWAA and DWAB; OpenEXR's default is 45

inline bool is_matte(Layer layer) {
  return layer == Layer::crypto_object || layer == Layer::crypto_material ||
         layer == Layer::crypto_asset;
}

// Half would lose what these layers are for.
inline bool needs_float(Layer layer) {
  return layer == Layer::time || layer == Layer::id || layer == Layer::variance ||
         layer == Layer::samples || is_matte(layer);
}

// How a preview shows linear light: as it is up to white, or along a film's curve.
enum class ViewTransform : std::uint8_t { srgb, filmic };

inline constexpr double most_stops = 64;  // of exposure, either way

inline bool has_layer(std::span<const Layer> layers, Layer layer) {
  return std::find(layers.begin(), layers.end(), layer) != layers.end();
}

// Whether what these layers hold is of all samples of a pixel, not of the one at its centre.
bool takes_all_samples(const std::vector<Layer>& layers);

struct OutputSettings {
  std::string path = "out/picture.####.exr";  // # stand for digits of the picture number
  std::vector<Layer> layers = {Layer::beauty, Layer::z};
  Compression compression = Compression::zip;
  double compression_level = 45;  // of DWAA and DWAB: 0 loses least
  // Layers that are stored in 16 and in 32 bits; the others as is usual for them.
  std::vector<Layer> half_layers, float_layers;
  bool split = false;   // a file for each layer
  bool preview = true;  // a PNG beside each EXR
  double exposure = 0;  // of the preview: stops by which it is brightened
  ViewTransform view = ViewTransform::srgb;
};

}  // namespace restframe
