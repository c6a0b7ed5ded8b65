#include "tracer/bsdf_layers.h"

#include "tracer/bsdf_albedo.h"
#include "tracer/bsdf_sheen.h"

namespace restframe {
namespace {

struct Passing {
  float fraction = 0;  // but for the reflectance, and colour
  float density = 0;
  float cos_half = 0;  // of view and microfacet
};

// Through a sheet: mirrored at a microfacet, then at the sheet.
Passing pass_sheet(const Bsdf& b, const ViewLobe& lobe, const Vec3f& direction) {
  const Vec3f above = mirrored(direction, b.normal);
  const Mirroring facets = mirroring(b.view, b.normal, b.alpha, lobe.cos_view, lobe.lambda_view,
                                     glm::dot(b.normal, above), above);
  return {facets.fraction, facets.density, facets.cos_half};
}

// Refracted by a microfacet (Walter and others 2007, equations 16 to 21).
Passing pass_boundary(const Bsdf& b, const ViewLobe& lobe, const Vec3f& direction) {
  const Vec3f sum = b.view + b.eta * direction;
  const float length2 = std::max(1e-20F, glm::dot(sum, sum));
  const float side = glm::dot(sum, b.normal) < 0.0F ? -1.0F : 1.0F;
  const Vec3f microfacet = sum * (side / std::sqrt(length2));
  const float cos_half = glm::dot(b.view, microfacet);
  const float cos_beyond = glm::dot(direction, microfacet);
  if (cos_half <= 0.0F || cos_beyond >= 0.0F) return {};
  const float lambda =
      smith_lambda(std::max(least_cosine, -glm::dot(b.normal, direction)), b.alpha);
  const float jacobian = squared(b.eta) * -cos_beyond / length2;
  const float facets =
      ggx_density(b.normal, microfacet, b.alpha) * cos_half * jacobian / lobe.cos_view;
  return {facets / (1.0F + lobe.lambda_view + lambda), facets / (1.0F + lobe.lambda_view),
          cos_half};
}

Fraction behind(const Bsdf& b, const ViewLobe& lobe, const ViewLayers& layers,
                const Vec3f& direction) {
  if (layers.reaches == 0.0F || passes_exactly(b)) return {};
  const Passing way =
      b.layers.thin ? pass_sheet(b, lobe, direction) : pass_boundary(b, lobe, direction);
  const Vec3f reflectance = glass_reflectance(b, way.cos_half);
  const float strength = layers.glass * (1.0F - largest(reflectance));
  return {b.base * (strength * way.fraction),
          layers.reaches * (1.0F - average(reflectance)) * way.density};
}

Fraction off_glass(const Bsdf& b, const ViewLobe& lobe, const ViewLayers& layers,
                   const Vec3f& direction) {
  if (layers.reaches == 0.0F || b.alpha < smallest_alpha) return {};
  const Mirroring facets = mirroring(b.view, b.normal, b.alpha, lobe.cos_view, lobe.lambda_view,
                                     glm::dot(b.normal, direction), direction);
  const Vec3f reflectance = glass_reflectance(b, facets.cos_half);
  return {reflectance * (layers.glass * facets.fraction),
          layers.reaches * average(reflectance) * facets.density};
}

Fraction off_coat(const Bsdf& b, const ViewLayers& layers, const Vec3f& direction) {
  const BsdfLayers& l = b.layers;
  const float cos_light = glm::dot(l.coat_normal, direction);
  if (layers.coat == 0.0F || l.coat_alpha < smallest_alpha || cos_light <= 0.0F) return {};
  const Mirroring facets = mirroring(b.view, l.coat_normal, l.coat_alpha, layers.cos_coat,
                                     layers.lambda_coat, cos_light, direction);
  return {Vec3f(layers.coat_gain * coat_reflectance(facets.cos_half) * facets.fraction),
          layers.coat * facets.density};
}

void add(Fraction& sum, const Fraction& more) {
  sum.fraction += more.fraction;
  sum.density += more.density;
}

// What makes up for light that microfacets scatter more than once. Where a dielectric reflects less
// than its index says, nothing is made up, lest there be too much.
float glass_gain(const Bsdf& b, float cos_view) {
  if (passes_exactly(b)) return 1.0F;
  const float albedo = b.layers.thin ? facet_albedo(facet_albedo_table(), cos_view, b.alpha).all
                                     : glass_albedo(cos_view, b.alpha, b.eta);
  return glm::mix(1.0F, 1.0F / albedo, b.layers.thin ? 1.0F : b.specular);
}

// Of a coat of mirrors that lose nothing, the part that its microfacets do reflect.
float coat_share(const FacetAlbedo& albedo) {
  return coat_straight * albedo.all + (1.0F - coat_straight) * albedo.grazing;
}

float coat_gain(float coat, const FacetAlbedo& albedo) {
  return coat * (1.0F + coat_straight * (1.0F - albedo.all) / albedo.all);
}

ViewLayers coated(const Bsdf& b) {
  const BsdfLayers& l = b.layers;
  ViewLayers layers;
  if (l.coat <= 0.0F) return layers;
  layers.cos_coat = std::max(least_cosine, glm::dot(l.coat_normal, b.view));
  layers.lambda_coat = smith_lambda(layers.cos_coat, l.coat_alpha);
  const FacetAlbedo albedo = facet_albedo(facet_albedo_table(), layers.cos_coat, l.coat_alpha);
  layers.coat_gain = coat_gain(l.coat, albedo);
  layers.coat = layers.coat_gain * coat_share(albedo);
  layers.below_coat = std::max(0.0F, 1.0F - layers.coat);
  return layers;
}

}  // namespace

Vec3f glass_reflectance(const Bsdf& b, float cos_half) {
  const float white = reflected_fraction(std::max(0.0F, cos_half), b.eta);
  if (white >= 1.0F) return Vec3f(1);
  const float straight = straight_reflectance(b.eta);
  const float left = glm::clamp((1.0F - white) / std::max(1e-6F, 1.0F - straight), 0.0F, 1.0F);
  return glm::clamp(b.specular * white + (straight_reflectance(b) - b.specular * straight) * left,
                    Vec3f(0), Vec3f(1));
}

float coat_reflection(float coat, float coat_alpha, float cos_view) {
  const FacetAlbedo albedo = facet_albedo(facet_albedo_table(), cos_view, coat_alpha);
  return coat_gain(coat, albedo) * coat_share(albedo);
}

Fraction off_fibres(const Bsdf& b, const ViewLobe& lobe, const ViewLayers& layers,
                    const Vec3f& direction) {
  if (layers.fibres == 0.0F) return {};
  const float scattered =
      fibre_fraction({b.normal, b.view, b.layers.sheen_alpha, lobe.cos_view}, direction);
  return {b.layers.sheen * (layers.fibre_gain * scattered), layers.fibres / (2.0F * pi)};
}

ViewLayers view_layers(const Bsdf& b, ViewLobe& lobe) {
  const BsdfLayers& l = b.layers;
  ViewLayers layers = coated(b);
  const float albedo = l.sheen == Vec3f(0) ? 0.0F : fibre_albedo(lobe.cos_view, l.sheen_alpha);
  const float fibres = std::min(1.0F, albedo);  // sleek ones would shine too much at grazing angles
  layers.fibre_gain = layers.below_coat / std::max(1.0F, albedo);
  layers.fibres = average(l.sheen) * fibres * layers.below_coat;
  layers.below = layers.below_coat * std::max(0.0F, 1.0F - largest(l.sheen) * fibres);
  for (Vec3f* light : {&lobe.diffuse, &lobe.straight, &lobe.grazing}) *light *= layers.below;
  lobe.diffuses *= layers.below;
  lobe.reflects *= layers.below;
  layers.reaches = (1.0F - b.metallic) * l.transmission * layers.below;
  layers.glass = layers.reaches * glass_gain(b, lobe.cos_view);
  const float sum = lobe.diffuses + lobe.reflects + layers.reaches + layers.coat + layers.fibres;
  const float share = sum > 0.0F ? 1.0F / sum : 0.0F;
  for (float* chance :
       {&lobe.diffuses, &lobe.reflects, &layers.reaches, &layers.coat, &layers.fibres}) {
    *chance *= share;
  }
  return layers;
}

Fraction layers_fraction(const Bsdf& b, const ViewLobe& lobe, const ViewLayers& layers,
                         const Vec3f& direction) {
  const float to_facet = glm::dot(b.facet, direction);
  const float cos_light = glm::dot(b.normal, direction);
  Fraction sum;
  if (to_facet < 0.0F && cos_light < 0.0F) return behind(b, lobe, layers, direction);
  if (to_facet <= 0.0F) return sum;
  if (cos_light > 0.0F) {
    sum = off_glass(b, lobe, layers, direction);
    add(sum, off_fibres(b, lobe, layers, direction));
  }
  add(sum, off_coat(b, layers, direction));
  return sum;
}

}  // namespace restframe
