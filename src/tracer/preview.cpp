#include "tracer/preview.h"

#include "physics/clones.h"
#include "scene/light_groups.h"
#include "tracer/cover_counts.h"
#include "tracer/footprint.h"
#include "tracer/shading_normal.h"

namespace restframe {
namespace {

// Below this much light from behind, what lies behind is left out.
constexpr float least_transmittance = 1e-4F;
constexpr std::uint32_t most_layers = 1000;

// Of surfaces that cover all that lies behind.
void count_covers(const FrameSet& frames, const RayPacket& rays, const HitPacket& hits,
                  const SurfaceLanes& surfaces, CoverCounts& covers) {
  for (int lane = 0; lane < packet_size; ++lane) {
    if (rays.active[lane] == 0 || hits.frame[lane] < 0) continue;
    count_cover(frames, hits, surfaces, lane, 1.0F, covers);
  }
}

}  // namespace

Preview::Preview(const Scene& scene, const FrameSet& frames)
    : scene_(scene),
      frames_(frames),
      tables_(scene),
      places_(object_places(scene, frames)),
      spectra_(scene),
      groups_(scene) {
  simple_.push_back({Vec4f(0), Vec4f(0), 1, 1});
  for (const Material& material : scene.materials) {
    plain_.push_back(plain(material));
    simple_.push_back(simple(plain_.back()));
  }
}

Preview::Simple Preview::simple(const Plain& plain) {
  if (!plain.always) return {};
  return {plain.lit, plain.unlit + plain.emission, 1, plain.double_sided ? 1 : 0};
}

Preview::Plain Preview::plain(const Material& m) {
  const bool changes = m.base_color.function != no_function || m.opacity.function != no_function ||
                       m.emission.function != no_function ||
                       m.emission_strength.function != no_function ||
                       has_own_spectrum(m.emission_temperature, m.emission_spectrum);
  const bool textured =
      m.base_color_texture.texture >= 0 || m.emission_texture.texture >= 0 || has_normal_map(m);
  Plain result;
  result.always = !changes && !textured && m.alpha_mode == AlphaMode::opaque;
  result.double_sided = m.double_sided || refracts(m);
  const Vec4f base(m.base_color.value, 0.0F);
  result.lit = m.unlit ? Vec4f(0) : base;
  result.unlit = m.unlit ? base : Vec4f(0);
  result.emission = Vec4f(m.emission.value * m.emission_strength.value, 1.0F);
  return result;
}

// Of a refined hit.
MetSurface Preview::met_surface(const Met& met) const {
  const RayCone cone{0, met.rays.has_spread ? met.rays.spread[met.lane] : 0.0F};
  return {
      scene_, frames_, met.surfaces, met.hits, met.lane, &tables_, cone.at(met.hits.s[met.lane])};
}

Vec4f Preview::shade_changing(const Met& met, TemporalEvaluator& evaluator) const {
  SurfaceLanes& surfaces = met.surfaces;
  frames_.refine(met.hits, met.lane);
  const MetSurface surface = met_surface(met);
  const double clock =
      clock_at(places_[static_cast<std::size_t>(surfaces.object[met.lane])], met.hits, met.lane);
  const Vec4f texture = texel(surface, surface.material().base_color_texture);
  const float alpha = coverage(surface, texture.w, clock, evaluator);
  if (alpha <= 0.0F) return Vec4f(0);
  if (has_normal_map(surface.material())) tilt_normal(surface, clock, evaluator, surfaces);
  const float light = surface.material().unlit ? 1.0F : surfaces.cosine[met.lane];
  const Vec3f lit = base_color(surface, texture, clock, evaluator) * light;
  const Vec3f glow = emission(surface, clock, evaluator);
  const Material& material = surface.material();
  if (!has_own_spectrum(material.emission_temperature, material.emission_spectrum)) {
    return alpha * Vec4f(as_seen(lit + glow, met), 1.0F);
  }
  return alpha * Vec4f(as_seen(lit, met) + own_spectrum(met, glow, clock, evaluator), 1.0F);
}

// D65 light of a colour where wavelengths shift.
Vec3f Preview::as_seen(const Vec3f& color, const Met& met) const {
  return spectra_.shifted ? (*spectra_.shifted)(color, doppler_at(met.hits, met.lane)) : color;
}

Vec3f Preview::own_spectrum(const Met& met, const Vec3f& filter, double clock,
                            TemporalEvaluator& evaluator) const {
  const auto index = static_cast<std::size_t>(met.surfaces.material[met.lane]);
  const EmitterSpectrum& spectrum = spectra_.all[index];
  const float kelvin = evaluator(scene_.materials[index].emission_temperature, clock);
  if (!spectra_.shifts) return spectrum.color(filter, kelvin);
  return spectrum.seen(spectra_.observer, filter, kelvin, doppler_at(met.hits, met.lane));
}

inline Vec4f Preview::shade(const Met& met, TemporalEvaluator& evaluator) const {
  const SurfaceLanes& surfaces = met.surfaces;
  const Plain& plain = plain_[static_cast<std::size_t>(surfaces.material[met.lane])];
  Vec4f shaded(0);
  if (!plain.always) {
    shaded = shade_changing(met, evaluator);
  } else if (surfaces.back[met.lane] == 0 || plain.double_sided) {
    shaded = (plain.lit * surfaces.cosine[met.lane] + plain.unlit) * surfaces.color_at(met.lane) +
             plain.emission;
    if (spectra_.shifts) shaded = Vec4f(as_seen(Vec3f(shaded), met), shaded.w);
  }
  if (scene_.render.beaming) {
    const float factor = emitter_factor(true, doppler_at(met.hits, met.lane));
    shaded *= Vec4f(factor, factor, factor, 1.0F);
  }
  return shaded;
}

// After shade(), which refines the hit. Times the part of the surface that is there.
Preview::Own Preview::own(const Met& met, float there, TemporalEvaluator& evaluator) const {
  const MetSurface surface = met_surface(met);
  const Material& material = surface.material();
  const double clock = clock_at(places_[static_cast<std::size_t>(met.surfaces.object[met.lane])],
                                met.hits, met.lane);
  const Vec4f texture = texel(surface, material.base_color_texture);
  const Vec3f base = base_color(surface, texture, clock, evaluator);
  const Vec3f glow = emission(surface, clock, evaluator);
  Vec3f shines = material.unlit ? base : Vec3f(0);
  if (has_own_spectrum(material.emission_temperature, material.emission_spectrum)) {
    shines = as_seen(shines, met) + own_spectrum(met, glow, clock, evaluator);
  } else {
    shines = as_seen(shines + glow, met);
  }
  const float factor = emitter_factor(scene_.render.beaming, doppler_at(met.hits, met.lane));
  return {shines * (there * factor), base * there};
}

// left: what surfaces in front of it leave of what `shaded` says.
void Preview::add_parts(const Met& met, float left, const Vec4f& shaded,
                        TemporalEvaluator& evaluator, SampleParts& parts) const {
  if (!(shaded.w > 0.0F)) return;
  const Own of_surface = own(met, shaded.w, evaluator);
  const Vec3f all = left * Vec3f(shaded), emission = left * of_surface.shines;
  parts.add(LightWay::emission, met.lane, emission);
  parts.add(LightWay::direct, met.lane, all - emission);
  parts.add_to_group(0, met.lane, all);
  parts.add(SampleParts::albedo, met.lane, left * of_surface.base);
}

RESTFRAME_CLONES bool Preview::shade_simple(const RayPacket& rays, const HitPacket& hits,
                                            const SurfaceLanes& surfaces,
                                            RadianceLanes& radiance) const {
  if (surfaces.colored || scene_.render.beaming || spectra_.shifts) return false;
  Lanes<std::int32_t> index, front;
  Lanes<float> cosine;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::int32_t material = surfaces.material[i];
    const std::int32_t back = surfaces.back[i];
    const float c = surfaces.cosine[i];
    const std::int32_t frame = hits.frame[i];
    const bool hit = (rays.active[i] != 0) & (frame >= 0);
    index[i] = hit ? material + 1 : 0;
    front[i] = hit ? 1 - back : 1;
    cosine[i] = hit ? c : 0.0F;
  }
  std::int32_t all = 1;
  for (int i = 0; i < packet_size; ++i) {
    const Simple& simple = simple_[static_cast<std::size_t>(index[i])];
    all &= simple.ends & (front[i] | simple.both_sides);
    radiance[i] = simple.lit * cosine[i] + simple.rest;
  }
  return all != 0;
}

SurfaceData Preview::data_of(const Met& met) const {
  frames_.refine(met.hits, met.lane);
  return surface_data(met_surface(met),
                      places_[static_cast<std::size_t>(met.surfaces.object[met.lane])], met.rays);
}

void Preview::trace(RayPacket& rays, const PacketId& id, TemporalEvaluator& evaluator,
                    RadianceLanes& radiance, const SampleLayers& layers) const {
  SurfaceDataLanes* const data = layers.data;
  for (int lane = 0; data != nullptr && lane < packet_size; ++lane) (*data)[lane].hit = false;
  SampleParts* const parts = layers.parts;
  if (parts != nullptr) parts->clear(groups_);
  HitPacket hits;
  SurfaceLanes surfaces;
  bool passing = true;
  for (std::uint32_t layer = 0; passing && layer < most_layers; ++layer) {
    frames_.nearest(rays, hits);
    surfaces_at(scene_, frames_, hits, rays.active, surfaces);
    if (layer == 0) {
      const bool only_light = data == nullptr && parts == nullptr;
      if (only_light && shade_simple(rays, hits, surfaces, radiance)) {
        if (layers.covers != nullptr) count_covers(frames_, rays, hits, surfaces, *layers.covers);
        return;
      }
      radiance.fill(Vec4f(0));
    }
    passing = false;
    for (int lane = 0; lane < packet_size; ++lane) {
      if (rays.active[lane] == 0) continue;
      rays.active[lane] = 0;
      if (hits.frame[lane] < 0) continue;
      const Met met{rays, surfaces, hits, lane};
      const Vec4f shaded = shade(met, evaluator);
      const float covered = radiance[lane].w;
      if (parts != nullptr) add_parts(met, 1.0F - covered, shaded, evaluator, *parts);
      radiance[lane] += (1.0F - radiance[lane].w) * shaded;  // behind what is in front
      if (data != nullptr && !(*data)[lane].hit &&
          random_unit(id, lane, Dimension::opacity, layer) < shaded.w) {
        (*data)[lane] = data_of(met);
      }
      if (1.0F - radiance[lane].w < least_transmittance) {
        radiance[lane].w = 1.0F;
      } else {
        rays.s_min[lane] = frames_.frame(hits.frame[lane]).s_behind(hits, lane);
        rays.active[lane] = -1;
        passing = true;
      }
      if (layers.covers == nullptr) continue;
      count_cover(frames_, hits, surfaces, lane, radiance[lane].w - covered, *layers.covers);
    }
  }
}

}  // namespace restframe
