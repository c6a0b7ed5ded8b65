#include "importers/vertex_colors.h"

#include <algorithm>
#include <cmath>

#include "scene/color.h"

namespace restframe {
namespace {

bool is_beyond(float x) {
  return x > 1 && std::isfinite(x);
}

float within_unit(float x) {
  return std::isnan(x) ? 0.0F : std::clamp(x, 0.0F, 1.0F);
}

}  // namespace

bool make_linear(std::vector<Vec4f>& colors, bool rgb_may_be_bytes, bool alpha_may_be_bytes) {
  bool rgb_bytes = false, alpha_bytes = false;
  for (const Vec4f& c : colors) {
    rgb_bytes = rgb_bytes || is_beyond(c.r) || is_beyond(c.g) || is_beyond(c.b);
    alpha_bytes = alpha_bytes || is_beyond(c.a);
  }
  rgb_bytes = rgb_bytes && rgb_may_be_bytes;
  alpha_bytes = alpha_bytes && alpha_may_be_bytes;
  const float rgb_scale = rgb_bytes ? 1 / 255.0F : 1, alpha_scale = alpha_bytes ? 1 / 255.0F : 1;
  for (Vec4f& c : colors) {
    const Vec3f srgb(within_unit(rgb_scale * c.r), within_unit(rgb_scale * c.g),
                     within_unit(rgb_scale * c.b));
    c = Vec4f(linear_from_srgb(srgb), within_unit(alpha_scale * c.a));
  }
  return rgb_bytes || alpha_bytes;
}

bool mend_alpha(std::vector<Vec4f>& colors) {
  const bool unseen = !colors.empty() && std::all_of(colors.begin(), colors.end(),
                                                     [](const Vec4f& c) { return c.a == 0; });
  if (unseen) {
    for (Vec4f& c : colors) c.a = 1;
  }
  return unseen;
}

}  // namespace restframe
