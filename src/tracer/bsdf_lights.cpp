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

void matte_lobes(const BsdfLanes& bsdf, ViewLobeLanes& lobes) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) store(lobes, i, matte_view_lobe(bsdf.base.at(i)));
}

void matte_fractions(const BsdfLanes& bsdf, const ViewLobeLanes& lobes, const Vec3fLanes& direction,
                     Vec3fLanes& fraction, Lanes<float>& density) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Fraction there = matte_fraction(bsdf.normal.at(i), bsdf.facet.at(i), lobes.diffuse.at(i),
                                          lobes.diffuses[i], direction.at(i));
    fraction.set(i, there.fraction);
    density[i] = there.density;
  }
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

Vec3f matte_fraction(const BsdfLanes& bsdf, const ViewLobeLanes& lobes, int lane,
                     const Vec3f& direction) {
  const float cos_light = glm::dot(bsdf.normal.at(lane), direction);
  if (!(cos_light > 0.0F && glm::dot(bsdf.facet.at(lane), direction) > 0.0F)) return Vec3f(0);
  const Vec3f diffuse = lobes.diffuse.at(lane) * cos_light;
  if (!bsdf.layered || !bsdf.layers.any(lane)) return diffuse;
  return diffuse +
         off_fibres(bsdf.at(lane), lobes.at(lane), lobes.layers[lane], direction).fraction;
}

RESTFRAME_CLONES void view_lobes(const BsdfLanes& bsdf, ViewLobeLanes& lobes) {
  if (bsdf.matte) return matte_lobes(bsdf, lobes);
  const FacetAlbedoTable& table = facet_albedo_table();
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    ViewLobe lobe = plain_view_lobe(bsdf.plain_at(i), table);
    share_chances(lobe);
    store(lobes, i, lobe);
  }
  for (int i = 0; bsdf.layered && i < packet_size; ++i) {
    if (bsdf.layers.any(i)) store(lobes, i, view_lobe(bsdf.at(i), table, lobes.layers[i]));
  }
}

RESTFRAME_CLONES void scattered_fraction(const BsdfLanes& bsdf, const ViewLobeLanes& lobes,
                                         const Vec3fLanes& direction, Vec3fLanes& fraction,
                                         Lanes<float>& density) {
  if (bsdf.matte) return matte_fractions(bsdf, lobes, direction, fraction, density);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Fraction there = plain_fraction(bsdf.plain_at(i), lobes.at(i), direction.at(i));
    fraction.set(i, there.fraction);
    density[i] = there.density;
  }
  for (int i = 0; bsdf.layered && i < packet_size; ++i) {
    if (!bsdf.layers.any(i)) continue;
    const Fraction more =
        layers_fraction(bsdf.at(i), lobes.at(i), lobes.layers[i], direction.at(i));
    fraction.set(i, fraction.at(i) + more.fraction);
    density[i] += more.density;
  }
}

}  // namespace restframe
