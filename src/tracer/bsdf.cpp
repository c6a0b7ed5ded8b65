#include "tracer/bsdf.h"

#include "physics/clones.h"
#include "tracer/bsdf_sample.h"
#include "tracer/bsdf_view.h"

namespace restframe {
namespace {

struct WayLanes {
  Vec3fLanes weight;
  Lanes<std::int32_t> there, exact, through;

  void set(int i, const Way& way) {
    weight.set(i, way.weight);
    there[i] = way.there ? -1 : 0;
    exact[i] = way.exact ? -1 : 0;
    through[i] = way.through ? -1 : 0;
  }
};

void choose_ways(const BsdfLanes& bsdf, const ViewLobeLanes& lobes, const Vec3fLanes& numbers,
                 WayLanes& ways, Vec3fLanes& direction) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Way way = plain_way(bsdf.plain_at(i), lobes.at(i), numbers.at(i));
    ways.set(i, way);
    direction.set(i, way.direction);
  }
  for (int i = 0; bsdf.layered && i < packet_size; ++i) {
    if (!bsdf.layers.any(i)) continue;
    const Way way = layered_way(bsdf.at(i), lobes.at(i), lobes.layers[i], numbers.at(i));
    ways.set(i, way);
    direction.set(i, way.direction);
  }
}

// Their fraction over their density is the same in all directions but for rounding.
void scatter_off_matte(const BsdfLanes& bsdf, const ViewLobeLanes& lobes,
                       const Lanes<std::int32_t>& active, const Vec3fLanes& numbers,
                       ScatteredLanes& scattered) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3f normal = bsdf.normal.at(i), facet = bsdf.facet.at(i);
    const float diffuses = lobes.diffuses[i];
    const Way way = matte_way(normal, facet, diffuses, numbers.y[i], numbers.z[i]);
    const Fraction there =
        matte_fraction(normal, facet, lobes.diffuse.at(i), diffuses, way.direction);
    const bool goes = way.there & (there.density > 0.0F);
    scattered.direction.set(i, way.direction);
    scattered.weight.set(i, there.fraction / (goes ? there.density : 1.0F));
    scattered.density[i] = there.density;
    scattered.through[i] = 0;
    scattered.active[i] = goes ? active[i] : 0;
  }
}

}  // namespace

std::optional<Vec3f> refracted(const Vec3f& view, const Vec3f& normal, float eta) {
  const float cos_theta = glm::dot(view, normal);
  const float sin2_beyond = (1.0F - squared(cos_theta)) / squared(eta);
  if (sin2_beyond >= 1.0F) return std::nullopt;
  return (cos_theta / eta - std::sqrt(1.0F - sin2_beyond)) * normal - view / eta;
}

// Weights are what all lobes send there, over the chance that any of them leads there.
std::optional<Scattered> scatter(const Bsdf& b, float lobe, float u, float v) {
  ViewLayers layers;
  const ViewLobe lobes = view_lobe(b, facet_albedo_table(), layers);
  const Way way = layered_way(b, lobes, layers, {lobe, u, v});
  if (!way.there) return std::nullopt;
  if (way.exact) return Scattered{way.direction, way.weight, 0.0F, way.through};
  const Fraction there = whole_fraction(b, lobes, layers, way.direction);
  if (there.fraction == Vec3f(0) || !(there.density > 0.0F)) return std::nullopt;
  return Scattered{way.direction, there.fraction / there.density, there.density, way.through};
}

RESTFRAME_CLONES void scatter(const BsdfLanes& bsdf, const ViewLobeLanes& lobes,
                              const Lanes<std::int32_t>& active, const Vec3fLanes& numbers,
                              ScatteredLanes& scattered) {
  if (bsdf.matte) return scatter_off_matte(bsdf, lobes, active, numbers, scattered);
  WayLanes ways;
  Vec3fLanes fraction;
  Lanes<float> density;
  choose_ways(bsdf, lobes, numbers, ways, scattered.direction);
  scattered_fraction(bsdf, lobes, scattered.direction, fraction, density);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const bool exact = ways.exact[i] != 0;
    const bool likely = density[i] > 0.0F;
    const Vec3f over_density = fraction.at(i) / (likely ? density[i] : 1.0F);
    const Vec3f weight = choose(exact, ways.weight.at(i), over_density);
    const bool lit = (weight.x != 0.0F) | (weight.y != 0.0F) | (weight.z != 0.0F);
    scattered.weight.set(i, weight);
    scattered.density[i] = exact ? 0.0F : density[i];
    scattered.through[i] = ways.through[i];
    scattered.active[i] = lit & (exact | likely) ? active[i] & ways.there[i] : 0;
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
