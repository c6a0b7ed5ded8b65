#pragma once

// A square far off on the camera's axis that fills the picture and moves along the axis, and what it
// should look like.

#include "physics/spectrum.h"
#include "support/path_scene.h"

namespace restframe {

// nu_observed / nu_emitted of what comes towards the camera at `beta`.
inline double head_on_doppler(double beta) {
  return std::sqrt((1 + beta) / (1 - beta));
}

inline const AssetFile kSquare = {"square.obj", quad_obj({0, 0, 0}, {1, 0, 0}, {0, 1, 0})};

// [camera], [render] and [output] of a camera at the origin that looks along -z.
inline std::string axis_camera(const std::string& render_keys, int size = 16) {
  return fmt::format(
      "[camera]\nposition = [0, 0, 0]\nfov = 0.08\n[render]\nresolution = [{0}, {0}]\n{1}\n"
      "[output]\npreview = false\nlayers = [\"beauty\"]\n",
      size, render_keys);
}

// Seen at z = -1000 when the camera's clock shows 0.
inline std::string square_object(double beta, const std::string& name = "patch") {
  return fmt::format(
      "[[object]]\nname = \"{0}\"\nasset = \"square.obj\"\nposition = [0, 0, -1000]\ntime = -1000\n"
      "velocity = [0, 0, {1:.17g}]\nmaterial = \"{0}\"\n",
      name, beta);
}

// Where its light has W/m^2 `irradiance` on the square.
inline std::string moving_sun(double beta, double irradiance, const std::string& keys = "") {
  return fmt::format(
      "[[light]]\ntype = \"sun\"\ndirection = [0, 0, -1]\nvelocity = [0, 0, {:.17g}]\nintensity = "
      "{:.17g}\n{}\n",
      beta, irradiance, keys);
}

// The mean of each channel, and its standard error from how pixels differ.
struct PictureMean {
  Vec3 rgb{0}, error{0};
};

inline PictureMean mean_of(const ExrPicture& picture) {
  PictureMean mean;
  const char* const names[] = {"R", "G", "B"};
  for (int i = 0; i < 3; ++i) {
    const auto& values = picture.channel(names[i]);
    double sum = 0, squares = 0;
    for (const float v : values) sum += static_cast<double>(v);
    const auto n = static_cast<double>(values.size());
    mean.rgb[i] = sum / n;
    for (const float v : values) squares += std::pow(static_cast<double>(v) - mean.rgb[i], 2);
    mean.error[i] = std::sqrt(squares / (n * (n - 1)));
  }
  return mean;
}

// A spectrum as it is seen by D, as XYZ: the middle of many equal steps over what is visible.
template <class Spectrum>
Vec3 shifted_xyz(double doppler, const Spectrum& emitted) {
  constexpr int steps = 9400;
  const double width = (visible_to - visible_from) / steps;
  Vec3 sum(0);
  for (int i = 0; i < steps; ++i) {
    const double w = visible_from + (i + 0.5) * width;
    sum += color_matching(w) * (doppler * emitted(w * doppler) * width);
  }
  return sum;
}

// Vec3 rgb of a square's material, as a scene file has it.
inline std::string rgb_text(const Vec3& rgb) {
  return fmt::format("[{}, {}, {}]", rgb.x, rgb.y, rgb.z);
}

inline std::string diffuse_patch(const Vec3& rgb) {
  return fmt::format(
      "[[material]]\nname = \"patch\"\nbase_color = {}\nmetallic = 0\nroughness = 1\nior = 1\n",
      rgb_text(rgb));
}

inline double reflected(const Vec3& rgb, double wavelength) {
  return glm::dot(rgb, reflectance_basis(wavelength));
}

}  // namespace restframe
