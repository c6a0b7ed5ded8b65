// What a surface scatters of light from a given direction, and how likely paths go there: sums over
// lobes.

#include "physics/clones.h"
#include "tracer/bsdf.h"
#include "tracer/bsdf_view.h"

namespace restframe {
namespace {

void store(ViewLobeLanes& lobes, int i, const ViewLobe& lobe) {
  lobes.diffuse.set(i, lobe.diffuse);
  lobes.straight.set(i, lobe.straight);
  lobes.grazing.set(i, lobe.grazing);
  lobes.cos_view[i] = lobe.cos_view;
  lobes.lambda_view[i] = lobe.lambda_view;
  lobes.diffuses[i] = lobe.diffuses;
  lobes.reflects[i] = lobe.reflects;
}

Fraction whole(const Bsdf& b, const Vec3f& direction) {
  ViewLayers layers;
  const ViewLobe lobe = view_lobe(b, facet_albedo_table(), layers);
  return whole_fraction(b, lobe, layers, direction);
}

}  // namespace

float fresnel_dielectric(float cos_theta, float eta) {
  return reflected_fraction(cos_theta, eta);
}

Vec3f scattered_fraction(const Bsdf& bsdf, const Vec3f& direction) {
  return whole(bsdf, direction).fraction;
}

float scattering_density(const Bsdf& bsdf, const Vec3f& direction) {
  return whole(bsdf, direction).density;
}

RESTFRAME_CLONES void view_lobes(const BsdfLanes& bsdf, ViewLobeLanes& lobes) {
  const FacetAlbedoTable& table = facet_albedo_table();
  if (bsdf.layered) {
    for (int i = 0; i < packet_size; ++i) {
      store(lobes, i, view_lobe(bsdf.at(i), table, lobes.layers[i]));
    }
    return;
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Bsdf b = bsdf.plain_at(i);
    const float cos_view = std::max(least_cosine, glm::dot(b.normal, b.view));
    ViewLobe lobe = view_weights(b, 1.0F, facet_albedo(table, cos_view, b.alpha));
    share_chances(lobe);
    store(lobes, i, lobe);
  }
}

RESTFRAME_CLONES void scattered_fraction(const BsdfLanes& bsdf, const ViewLobeLanes& lobes,
                                         const Vec3fLanes& direction, Vec3fLanes& fraction,
                                         Lanes<float>& density) {
  if (bsdf.layered) {
    for (int i = 0; i < packet_size; ++i) {
      const Fraction there =
          whole_fraction(bsdf.at(i), lobes.at(i), lobes.layers[i], direction.at(i));
      fraction.set(i, there.fraction);
      density[i] = there.density;
    }
    return;
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Fraction there = plain_fraction(bsdf.plain_at(i), lobes.at(i), direction.at(i));
    fraction.set(i, there.fraction);
    density[i] = there.density;
  }
}

}  // namespace restframe
