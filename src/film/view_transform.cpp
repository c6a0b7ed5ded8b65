#include "film/view_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace restframe {
namespace {

constexpr float stops_to_half_white = 12;

// From 0 to 1; Narkowicz's rational function reaches 1 at about 7.
float film_curve(float x) {
  // Its numbers are large where x is: past this all is white.
  const float in = 0.6F * std::min(x, 1e6F);
  return std::min(1.0F, in * (2.51F * in + 0.03F) / (in * (2.43F * in + 0.59F) + 0.14F));
}

float finite(float value) {
  constexpr float largest = std::numeric_limits<float>::max();
  return std::isnan(value) ? largest : std::clamp(value, 0.0F, largest);
}

Vec3f filmic(const Vec3f& light) {
  const Vec3f rgb(finite(light.x), finite(light.y), finite(light.z));
  const float brightest = std::max({rgb.x, rgb.y, rgb.z});
  if (brightest == 0.0F) return Vec3f(0);
  const float stops = std::max(0.0F, std::log2(brightest));
  const float white = stops / (stops + stops_to_half_white);
  return film_curve(brightest) * glm::mix(rgb / brightest, Vec3f(1), white);
}

}  // namespace

Vec3f developed(const Vec3f& linear, const Development& development) {
  const Vec3f light = linear * development.gain;
  return development.view == ViewTransform::filmic ? filmic(light) : light;
}

}  // namespace restframe
