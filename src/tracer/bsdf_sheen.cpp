#include "tracer/bsdf_sheen.h"

namespace restframe {
namespace {

// The paper's fit, between fibres that diverge as much as they can and not at all.
float fitted(float cosine, float alpha) {
  const float upright = squared(1.0F - alpha);
  const float a = glm::mix(21.5473F, 25.3245F, upright);
  const float b = glm::mix(3.82987F, 3.32435F, upright);
  const float c = glm::mix(0.19823F, 0.16801F, upright);
  const float d = glm::mix(-1.97760F, -1.27393F, upright);
  const float e = glm::mix(-4.32054F, -4.85967F, upright);
  return a / (1.0F + b * std::pow(cosine, c)) + d * cosine + e;
}

// Hidden over visible area.
float lambda(float cosine, float alpha) {
  if (cosine < 0.5F) return std::exp(fitted(cosine, alpha));
  return std::exp(2.0F * fitted(0.5F, alpha) - fitted(1.0F - cosine, alpha));
}

}  // namespace

float fibre_fraction(const Fibres& f, const Vec3f& direction) {
  const float alpha = std::max(smallest_fibre_alpha, f.alpha);
  const Vec3f between = f.view + direction;
  const Vec3f across = glm::cross(f.normal, between);
  const float sine2 = glm::dot(across, across) / std::max(1e-20F, glm::dot(between, between));
  const float distribution =
      (2.0F + 1.0F / alpha) * std::pow(std::min(1.0F, sine2), 0.5F / alpha) / (2.0F * pi);
  const float cos_light = std::max(0.0F, glm::dot(f.normal, direction));
  return distribution /
         ((1.0F + lambda(f.cos_view, alpha) + lambda(cos_light, alpha)) * 4.0F * f.cos_view);
}

}  // namespace restframe
