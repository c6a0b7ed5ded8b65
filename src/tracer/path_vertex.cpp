// Vertices of 16 paths: what the surfaces are that the paths have met.

#include <algorithm>

#include "frames/lane_groups.h"
#include "physics/clones.h"
#include "tracer/path_walk.h"
#include "tracer/shading_normal.h"

namespace restframe {
namespace {

// Formulas may leave the range of what they stand for.
float fraction(float value) {
  return std::clamp(value, 0.0F, 1.0F);
}

bool is_layered(const Material& m) {
  const auto is_there = [](const TemporalNumber& n) {
    return n.value > 0.0F || n.function != no_function;
  };
  return can_transmit(m) || is_there(m.clearcoat) || m.sheen_color.value != Vec3f(0) ||
         m.sheen_color.function != no_function;
}

}  // namespace

PlainMaterial plain_material(const Material& m) {
  const auto constant = [](const auto& property) { return property.function == no_function; };
  const bool changes = !(constant(m.base_color) && constant(m.metallic) && constant(m.roughness) &&
                         constant(m.emission) && constant(m.emission_strength) && constant(m.ior) &&
                         constant(m.specular) && constant(m.specular_color)) ||
                       has_own_spectrum(m.emission_temperature, m.emission_spectrum);
  const bool textured = m.base_color_texture.texture >= 0 ||
                        m.metallic_roughness_texture.texture >= 0 ||
                        m.emission_texture.texture >= 0 || m.specular_texture.texture >= 0 ||
                        m.specular_color_texture.texture >= 0 || has_normal_map(m);
  PlainMaterial plain;
  plain.layered = is_layered(m);
  plain.always =
      !changes && !textured && !m.unlit && !plain.layered && m.alpha_mode == AlphaMode::opaque;
  plain.tilted = has_normal_map(m);
  plain.tilted_coat = m.clearcoat_normal_texture.texture >= 0;
  plain.double_sided = m.double_sided;
  plain.base = m.base_color.value;
  plain.emission = m.emission.value * m.emission_strength.value;
  plain.metallic = fraction(m.metallic.value);
  plain.alpha = fraction(m.roughness.value) * fraction(m.roughness.value);
  plain.ior = std::max(1.0F, m.ior.value);
  plain.specular = fraction(m.specular.value);
  plain.specular_color = glm::max(m.specular_color.value, Vec3f(0));
  return plain;
}

// Surfaces that light does not just pass: they shine, and scatter.
void PathWalk::meet() {
  arrive();
  if (stage_.spectra.shifts) find_local_spectra();
  ShineLanes shines;
  vertices_.active.fill(0);
  vertices_.bsdf.layered = false;
  vertices_.bsdf.matte = true;
  for_each_group(surfaces_.material, met_, [&](int first, const Lanes<std::int32_t>& group) {
    if (plain(first).always) return set_plain_material(plain(first), group, shines);
    for (int lane = 0; lane < packet_size; ++lane) {
      if (group[lane] != 0) set_changing_material(lane, shines);
    }
  });
  if (parts_.are_wanted()) note_albedos();
  if (shines.any || shines.any_own) weigh_emission(shines);
  if (shines.any) add_emission(shines);
  for (int lane = 0; shines.any_own && lane < packet_size; ++lane) {
    if (met_[lane] != 0) add_own_spectrum(lane, shines);
  }
  if (!any_active(vertices_.active)) return;
  set_geometry();
  view_lobes(vertices_.bsdf, vertices_.lobes);
  if (stage_.has_lights) add_lights();
  scatter_on();
}

RESTFRAME_CLONES void PathWalk::arrive() {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const bool met = met_[i] != 0;
    const std::int32_t outside = rays_.active[i];
    const bool from_outside = met & (outside != 0);
    blend(from_outside, paths_.omega[i], -hits_.rest_k_t[i]);
    blend(met, paths_.coverage[i], 1.0F);
    blend(met, rays_.active[i], 0);
    blend(met, in_medium_.active[i], 0);
  }
  for (int lane = 0; inside_ && lane < packet_size; ++lane) {
    if (met_[lane] != 0 && in_medium(lane)) absorb(lane);
  }
}

void PathWalk::absorb(int lane) {
  const float length = static_cast<float>(hits_.s[lane] * paths_.omega[lane]);
  weigh(lane, glm::exp(-length * media_[lane].top().absorbed));
}

RESTFRAME_CLONES void PathWalk::set_plain_material(const PlainMaterial& material,
                                                   const Lanes<std::int32_t>& group,
                                                   ShineLanes& shines) {
  const PlainMaterial plain = material;
  const int depth = stage_.scene.render.depth;
  BsdfLanes& bsdf = vertices_.bsdf;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::int32_t scatters = paths_.scatterings[i] < depth ? group[i] : 0;
    vertices_.active[i] |= scatters;
    paths_.scatterings[i] -= scatters;
    set_in(group, i, shines.radiance, plain.emission);
    set_in(group, i, bsdf.metallic, plain.metallic);
    set_in(group, i, bsdf.alpha, plain.alpha);
    set_in(group, i, bsdf.eta, plain.ior);
    set_in(group, i, bsdf.specular, plain.specular);
    set_in(group, i, bsdf.specular_color, plain.specular_color);
  }
  const bool colored = surfaces_.colored;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    set_in(group, i, bsdf.base, colored ? plain.base * Vec3f(surfaces_.color[i]) : plain.base);
  }
  bsdf.matte = bsdf.matte && plain.metallic == 0.0F && plain.specular == 0.0F;
  shines.any = shines.any || plain.emission != Vec3f(0);
  for (int lane = 0; inside_ && lane < packet_size; ++lane) {
    if (group[lane] != 0 && in_medium(lane)) bsdf.eta[lane] /= media_[lane].ior();
  }
}

void PathWalk::set_changing_material(int lane, ShineLanes& shines) {
  const bool scatters = paths_.scatterings[lane] < stage_.scene.render.depth;
  const MetSurface met = met_surface(lane);
  const Material& material = met.material();
  const double clock = clock_[lane];
  Vec3f emitted = emission(met, clock, evaluator_);
  if (plain(lane).layered) {
    const float cosine = glm::dot(vertices_.at.facet.at(lane), hits_.sight.at(lane));
    emitted *= below_coat(met, std::abs(cosine), clock, evaluator_);
  }
  const bool needs_base = material.unlit || scatters;
  const Vec3f base = needs_base ? base_color(met, texture_[lane], clock, evaluator_) : Vec3f(0);
  if (has_own_spectrum(material.emission_temperature, material.emission_spectrum)) {
    shines.set_own(lane, emitted, evaluator_(material.emission_temperature, clock));
    shines.set(lane, material.unlit ? base : Vec3f(0));
  } else {
    shines.set(lane, material.unlit ? emitted + base : emitted);
  }
  if (material.unlit || !scatters) return;
  ++paths_.scatterings[lane];
  vertices_.active[lane] = -1;
  vertices_.bsdf.matte = false;
  vertices_.bsdf.base.set(lane, base);
  set_finish(met, clock, evaluator_, vertices_.bsdf);
  vertices_.bsdf.eta[lane] = index_ratio(lane, met, clock);
  if (plain(lane).layered) vertices_.bsdf.set_layers(lane, layers(met, clock, evaluator_));
}

void PathWalk::add_emission(const ShineLanes& shines) {
  const bool beaming = stage_.scene.render.beaming;
  Vec3fLanes light = shines.radiance;
  if (stage_.spectra.shifts) {
    for (int lane = 0; lane < packet_size; ++lane) {
      if (met_[lane] == 0 || light.at(lane) == Vec3f(0)) continue;
      const double omega = paths_.omega[lane];
      const Vec3f color = light.at(lane) * emitter_factor(beaming, 1.0 / omega);
      const std::int32_t group = stage_.group_of_material(surfaces_.material[lane]);
      if (receive_direct(lane, color, omega, group)) {
        light.set(lane, Vec3f(0));
        continue;
      }
      light.set(lane, light_by_wavelength(lane, stage_.spectra.daylight, light.at(lane), 0.0F,
                                          paths_.omega[lane]));
    }
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const float factor = emitter_factor(beaming, 1.0 / paths_.omega[i]);
    const Vec3f sum = paths_.radiance.at(i) + paths_.throughput.at(i) * light.at(i) * factor;
    set_in(met_, i, paths_.radiance, sum);
  }
  for (int i = 0; parts_.are_wanted() && i < packet_size; ++i) {
    if (met_[i] == 0) continue;
    const float factor = emitter_factor(beaming, 1.0 / paths_.omega[i]);
    parts_.receive(i, stage_.group_of_material(surfaces_.material[i]),
                   paths_.throughput.at(i) * light.at(i) * factor);
  }
}

void PathWalk::add_own_spectrum(int lane, const ShineLanes& shines) {
  const double omega = paths_.omega[lane];
  const Vec3f color =
      shines.own.at(lane) * emitter_factor(stage_.scene.render.beaming, 1.0 / omega);
  if (color == Vec3f(0)) return;
  const auto material = static_cast<std::size_t>(surfaces_.material[lane]);
  const EmitterSpectrum& spectrum = stage_.spectra.all[material];
  const std::int32_t group = stage_.groups.of_material[material];
  receive(lane, light_by_wavelength(lane, spectrum, color, shines.kelvin[lane], omega), group);
  if (follows_lines()) receive_lines(lane, spectrum, color, omega, group);
}

RESTFRAME_CLONES void PathWalk::set_geometry() {
  BsdfLanes& bsdf = vertices_.bsdf;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    bsdf.view.set(i, -hits_.sight.at(i));
    bsdf.normal.set(i, surfaces_.normal.at(i));
    bsdf.facet.set(i, vertices_.at.facet.at(i));
    bsdf.base.set(i, glm::max(bsdf.base.at(i), Vec3f(0)));
  }
  for (int lane = 0; tilts_ && lane < packet_size; ++lane) {
    if (vertices_.active[lane] == 0 || !plain(lane).tilted) continue;
    bsdf.normal.set(
        lane, reflecting_normal(bsdf.view.at(lane), bsdf.facet.at(lane), bsdf.normal.at(lane)));
  }
  for (int lane = 0; bsdf.layered && lane < packet_size; ++lane) {
    if (vertices_.active[lane] == 0 || !plain(lane).tilted_coat) continue;
    Vec3fLanes& coat = bsdf.layers.coat_normal;
    coat.set(lane, reflecting_normal(bsdf.view.at(lane), bsdf.facet.at(lane), coat.at(lane)));
  }
}

}  // namespace restframe
