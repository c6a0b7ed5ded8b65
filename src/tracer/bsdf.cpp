#include "tracer/bsdf.h"

#include "physics/clones.h"
#include "tracer/bsdf_sample.h"
#include "tracer/bsdf_view.h"

namespace restframe {
namespace {

// A lobe's choice. `exact`: no other lobe leads there, and this is its weight.
struct Way {
  Vec3f direction{0};
  Vec3f weight{0};
  bool exact = false, through = false;
};

Vec3f mirrored_view(const Bsdf& b, const Vec3f& microfacet) {
  return 2.0F * glm::dot(b.view, microfacet) * microfacet - b.view;
}

std::optional<Way> above(const Bsdf& b, const Vec3f& normal, const Way& way) {
  const bool seen =
      glm::dot(way.direction, b.facet) > 0.0F && glm::dot(way.direction, normal) > 0.0F;
  return seen ? std::optional(way) : std::nullopt;
}

std::optional<Way> beyond(const Bsdf& b, const Way& way) {
  const bool there =
      glm::dot(way.direction, b.facet) < 0.0F && glm::dot(way.direction, b.normal) < 0.0F;
  return there ? std::optional(way) : std::nullopt;
}

std::optional<Way> reflect(const Bsdf& b, const ViewLobe& lobe, float u, float v) {
  const Vec3f microfacet = visible_microfacet(b.normal, b.view, b.alpha, u, v);
  const Vec3f reflectance = lobe.straight + lobe.grazing * schlick(lobe.cos_view);
  return above(
      b, b.normal,
      {mirrored_view(b, microfacet), reflectance / lobe.reflects, b.alpha < smallest_alpha, false});
}

std::optional<Way> pass(const Bsdf& b, const Vec3f& microfacet, const Vec3f& weight) {
  const bool exact = passes_exactly(b);
  if (!b.layers.thin) {
    const auto direction = refracted(b.view, exact ? b.normal : microfacet, b.eta);
    return direction ? beyond(b, {*direction, weight, exact, true}) : std::nullopt;
  }
  if (exact) return beyond(b, {-b.view, weight, true, false});
  const Vec3f reflected = mirrored_view(b, microfacet);
  if (glm::dot(reflected, b.normal) <= 0.0F) return std::nullopt;
  return beyond(b, {mirrored(reflected, b.normal), weight, false, false});
}

// The microfacet that is met decides, or light would be made or lost where some reflect all and others
// hardly anything.
std::optional<Way> meet_glass(const Bsdf& b, const ViewLayers& layers, float lobe, float u,
                              float v) {
  const Vec3f microfacet = visible_microfacet(b.normal, b.view, b.alpha, u, v);
  const Vec3f reflectance = glass_reflectance(b, glm::dot(b.view, microfacet));
  const float chance = average(reflectance);
  const float scattered = layers.glass / layers.reaches;
  if (lobe < chance) {
    return above(b, b.normal,
                 {mirrored_view(b, microfacet), reflectance * (scattered / chance),
                  b.alpha < smallest_alpha, false});
  }
  const float passing = (1.0F - largest(reflectance)) / (1.0F - chance);
  return pass(b, microfacet, b.base * (scattered * passing));
}

std::optional<Way> reflect_off_coat(const Bsdf& b, const ViewLayers& layers, float u, float v) {
  const BsdfLayers& l = b.layers;
  const Vec3f microfacet = visible_microfacet(l.coat_normal, b.view, l.coat_alpha, u, v);
  const float reflectance = layers.coat_gain * coat_reflectance(layers.cos_coat);
  return above(b, l.coat_normal,
               {mirrored_view(b, microfacet), Vec3f(reflectance / layers.coat),
                l.coat_alpha < smallest_alpha, false});
}

// What number `at` in [0, 1) falls into, and where in it.
struct Chooser {
  float at;

  bool takes(float chance) {
    if (at < chance) {
      at = std::min(at / chance, 1.0F - 0x1p-24F);
      return true;
    }
    at -= chance;
    return false;
  }
};

std::optional<Way> choose(const Bsdf& b, const ViewLobe& lobe, const ViewLayers& layers,
                          const Vec3f& numbers) {
  const float u = numbers.y, v = numbers.z;
  Chooser chooser{numbers.x};
  if (chooser.takes(lobe.diffuses)) {
    return above(b, b.normal, {cosine_distributed(b.normal, u, v), {}, false, false});
  }
  if (chooser.takes(lobe.reflects)) return reflect(b, lobe, u, v);
  if (chooser.takes(layers.reaches)) return meet_glass(b, layers, chooser.at, u, v);
  if (chooser.takes(layers.coat)) return reflect_off_coat(b, layers, u, v);
  if (chooser.takes(layers.fibres)) {
    return above(b, b.normal, {evenly_distributed(b.normal, u, v), {}, false, false});
  }
  return std::nullopt;
}

// What all lobes send there, over the chance that any of them leads there.
std::optional<Scattered> weighed(const Way& way, const Fraction& there) {
  if (way.exact) return Scattered{way.direction, way.weight, 0.0F, way.through};
  if (there.fraction == Vec3f(0) || !(there.density > 0.0F)) return std::nullopt;
  return Scattered{way.direction, there.fraction / there.density, there.density, way.through};
}

}  // namespace

std::optional<Vec3f> refracted(const Vec3f& view, const Vec3f& normal, float eta) {
  const float cos_theta = glm::dot(view, normal);
  const float sin2_beyond = (1.0F - squared(cos_theta)) / squared(eta);
  if (sin2_beyond >= 1.0F) return std::nullopt;
  return (cos_theta / eta - std::sqrt(1.0F - sin2_beyond)) * normal - view / eta;
}

std::optional<Scattered> scatter(const Bsdf& b, float lobe, float u, float v) {
  ViewLayers layers;
  const ViewLobe lobes = view_lobe(b, facet_albedo_table(), layers);
  const std::optional<Way> way = choose(b, lobes, layers, {lobe, u, v});
  if (!way) return std::nullopt;
  return weighed(*way, whole_fraction(b, lobes, layers, way->direction));
}

void scatter(const BsdfLanes& bsdf, const ViewLobeLanes& lobes, const Lanes<std::int32_t>& active,
             const Vec3fLanes& numbers, ScatteredLanes& scattered) {
  Lanes<Way> ways;
  scattered.active.fill(0);
  for (int i = 0; i < packet_size; ++i) {
    const ViewLayers layers = bsdf.layered ? lobes.layers[i] : ViewLayers{};
    const auto way =
        active[i] != 0 ? choose(bsdf.at(i), lobes.at(i), layers, numbers.at(i)) : std::nullopt;
    scattered.active[i] = way ? -1 : 0;
    if (way) ways[i] = *way;
    scattered.direction.set(i, ways[i].direction);
  }
  Vec3fLanes fraction;
  Lanes<float> density;
  scattered_fraction(bsdf, lobes, scattered.direction, fraction, density);
  for (int i = 0; i < packet_size; ++i) {
    if (scattered.active[i] == 0) continue;
    const auto result = weighed(ways[i], {fraction.at(i), density[i]});
    scattered.active[i] = result ? -1 : 0;
    if (!result) continue;
    scattered.weight.set(i, result->weight);
    scattered.density[i] = result->density;
    scattered.through[i] = result->through ? -1 : 0;
  }
}

void BsdfLayersLanes::set(int i, const BsdfLayers& of_lane) {
  transmission[i] = of_lane.transmission;
  thin[i] = of_lane.thin ? 1 : 0;
  coat[i] = of_lane.coat;
  coat_alpha[i] = of_lane.coat_alpha;
  coat_normal.set(i, of_lane.coat_normal);
  sheen.set(i, of_lane.sheen);
  sheen_alpha[i] = of_lane.sheen_alpha;
}

void BsdfLanes::set_layers(int lane, const BsdfLayers& of_lane) {
  for (int i = 0; !layered && i < packet_size; ++i) layers.set(i, {});
  layered = true;
  layers.set(lane, of_lane);
}

}  // namespace restframe
