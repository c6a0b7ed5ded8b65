// Ways on from layered surfaces: one lobe is chosen, and it chooses the direction.

#include "tracer/bsdf_layers.h"
#include "tracer/bsdf_sample.h"

namespace restframe {
namespace {

Way above(const Bsdf& b, const Vec3f& normal, Way way) {
  way.there = glm::dot(way.direction, b.facet) > 0.0F && glm::dot(way.direction, normal) > 0.0F;
  return way;
}

Way beyond(const Bsdf& b, Way way) {
  way.there = glm::dot(way.direction, b.facet) < 0.0F && glm::dot(way.direction, b.normal) < 0.0F;
  return way;
}

Vec3f microfacet_of(const Vec3f& normal, const Vec3f& view, float alpha, const Vec3f& numbers) {
  return visible_microfacet(basis_around(normal), view, alpha,
                            disc_distributed(numbers.y, numbers.z));
}

Way pass(const Bsdf& b, const Vec3f& microfacet, const Vec3f& weight) {
  const bool exact = passes_exactly(b);
  if (!b.layers.thin) {
    const auto direction = refracted(b.view, exact ? b.normal : microfacet, b.eta);
    return direction ? beyond(b, {*direction, weight, true, exact, true}) : Way{};
  }
  if (exact) return beyond(b, {-b.view, weight, true, true, false});
  const Vec3f reflected = mirrored_view(b.view, microfacet);
  if (glm::dot(reflected, b.normal) <= 0.0F) return {};
  return beyond(b, {mirrored(reflected, b.normal), weight, true, false, false});
}

// The microfacet that is met decides, or light would be made or lost where some reflect all and others
// hardly anything.
Way meet_glass(const Bsdf& b, const ViewLayers& layers, const Vec3f& numbers) {
  const Vec3f microfacet = microfacet_of(b.normal, b.view, b.alpha, numbers);
  const Vec3f reflectance = glass_reflectance(b, glm::dot(b.view, microfacet));
  const float chance = average(reflectance);
  const float scattered = layers.glass / layers.reaches;
  if (numbers.x < chance) {
    return above(b, b.normal,
                 {mirrored_view(b.view, microfacet), reflectance * (scattered / chance), true,
                  b.alpha < smallest_alpha, false});
  }
  const float passing = (1.0F - largest(reflectance)) / (1.0F - chance);
  return pass(b, microfacet, b.base * (scattered * passing));
}

Way reflect_off_coat(const Bsdf& b, const ViewLayers& layers, const Vec3f& numbers) {
  const BsdfLayers& l = b.layers;
  const Vec3f microfacet = microfacet_of(l.coat_normal, b.view, l.coat_alpha, numbers);
  const float reflectance = layers.coat_gain * coat_reflectance(layers.cos_coat);
  return above(b, l.coat_normal,
               {mirrored_view(b.view, microfacet), Vec3f(reflectance / layers.coat), true,
                l.coat_alpha < smallest_alpha, false});
}

// What a number in [0, 1) falls into, and where in it.
class Choice {
 public:
  explicit Choice(float number) : at_(number) {}

  bool falls_into(float chance) {
    if (at_ < chance) {
      at_ = std::min(at_ / chance, 1.0F - 0x1p-24F);
      return true;
    }
    at_ -= chance;
    return false;
  }
  float at() const { return at_; }

 private:
  float at_;
};

}  // namespace

Way layered_way(const Bsdf& b, const ViewLobe& lobe, const ViewLayers& layers,
                const Vec3f& numbers) {
  const float below = lobe.diffuses + lobe.reflects;
  if (numbers.x < below) return plain_way(b, lobe, numbers);
  Choice choice(numbers.x - below);
  if (choice.falls_into(layers.reaches)) {
    return meet_glass(b, layers, {choice.at(), numbers.y, numbers.z});
  }
  if (choice.falls_into(layers.coat)) return reflect_off_coat(b, layers, numbers);
  if (choice.falls_into(layers.fibres)) {
    const Vec3f direction = evenly_distributed(b.normal, numbers.y, numbers.z);
    return above(b, b.normal, {direction, {}, true, false, false});
  }
  return {};
}

}  // namespace restframe
