// What paths could also have met by chance: emitting surfaces and environments. Light of either is
// found in two ways, by choosing a point of it at a vertex, and by going on in a direction that the
// surface's scattering chooses. Both are weighed by how likely each is to find it (Veach's power
// heuristic, exponent 2), their densities taken per steradian in the rest frame of the vertex.

#include "frames/lane_groups.h"
#include "physics/clones.h"
#include "tracer/emitter_points.h"
#include "tracer/path_walk.h"

namespace restframe {
namespace {

// The weight of what was found with the density `own`.
float power_share(double own, double other) {
  const double ratio = other / own;
  return static_cast<float>(1.0 / (1.0 + ratio * ratio));
}

// Two random numbers' digits together, for choices among more than one of them can tell apart.
double finer(float number, float digits) {
  return static_cast<double>(number) + 0x1p-24 * static_cast<double>(digits);
}

}  // namespace

// Thin sheets are lit from both sides; of others lights are looked for above the facet alone.
Vec3f PathWalk::facing(int lane) const {
  const BsdfLanes& bsdf = vertices_.bsdf;
  const bool thin = bsdf.layered && bsdf.layers.thin[lane] != 0;
  return thin ? Vec3f(0) : bsdf.facet.at(lane);
}

// Of paths that are where they scatter still.
void PathWalk::set_chosen(const ScatteredLanes& scattered) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const float density = scattered.through[i] != 0 ? 0.0F : scattered.density[i];
    set_in(scattered.active, i, chosen_.density, density);
    set_in(scattered.active, i, chosen_.omega, paths_.omega[i]);
  }
  for (int lane = 0; inside_ && lane < packet_size; ++lane) {
    if (in_medium(lane)) chosen_.density[lane] = 0.0F;
  }
  if (stage_.emitters.empty()) return;
  for (int lane = 0; lane < packet_size; ++lane) {
    if (scattered.active[lane] == 0) continue;
    chosen_.frame[lane] = hits_.frame[lane];
    chosen_.facing.set(lane, facing(lane));
  }
}

// Of a path that has left its last vertex in a direction that lights are looked for in, too.
float PathWalk::share_of_chance(int lane, double light_density) const {
  const auto own = static_cast<double>(chosen_.density[lane]);
  if (stage_.search == LightSearch::by_choice && light_density > 0.0) return 0.0F;
  return own > 0.0 ? power_share(own, light_density) : 1.0F;
}

float PathWalk::share_of_sky(const Environment& sky, int lane) const {
  if (!sky.is_sampled || !(chosen_.density[lane] > 0.0F)) return 1.0F;
  const WaveVector<in::LightRest> there = sky.place.frame.from_world(rays_.k.at(lane));
  const double shift = chosen_.omega[lane] / -there.t;
  return share_of_chance(lane, sky_density(sky, sight_direction(there)) * shift * shift);
}

// The distance in the rest frame of the last vertex is s times the frequency there.
float PathWalk::share_of_emitter(int lane) const {
  const std::uint32_t part = hits_.part[lane], triangle = hits_.triangle[lane];
  const RestFrame& last = stage_.frames.frame(chosen_.frame[lane]);
  const Receiver receiver =
      stage_.emitters.receiver(hits_.frame[lane], rays_.origin.at(lane),
                               last.coordinates().from_world.velocity(), chosen_.facing.at(lane));
  const double chance = stage_.emitters.chance(hits_.frame[lane], part, triangle, receiver);
  if (!(chance > 0.0)) return 1.0F;
  const FramePart& placed = stage_.frames.frame(hits_.frame[lane]).part(part);
  const double per_area = chance / rest_triangle(stage_.scene, placed, triangle).area;
  const double length = hits_.s[lane] * chosen_.omega[lane];
  const float facing = std::abs(glm::dot(vertices_.at.facet.at(lane), hits_.sight.at(lane)));
  return share_of_chance(lane, per_area * length * length / static_cast<double>(facing));
}

void PathWalk::weigh_emission(ShineLanes& shines) const {
  if (stage_.emitters.empty()) return;
  for (int lane = 0; lane < packet_size; ++lane) {
    if (met_[lane] == 0 || !(chosen_.density[lane] > 0.0F)) continue;
    const Vec3f shining = shines.radiance.at(lane);
    const Vec3f own = shines.any_own ? shines.own.at(lane) : Vec3f(0);
    if (shining == Vec3f(0) && own == Vec3f(0)) continue;
    const float share = share_of_emitter(lane);
    shines.radiance.set(lane, shining * share);
    if (shines.any_own) shines.own.set(lane, own * share);
  }
}

// At each point's own clock, through what covers it.
void PathWalk::set_radiance(const EmitterPoints& points, const PointsSeen& seen,
                            IncidentLanes& from) {
  const bool beaming = stage_.scene.render.beaming;
  for (int lane = 0; lane < packet_size; ++lane) {
    if (from.active[lane] == 0) continue;
    const MetSurface met{stage_.scene, stage_.frames, points.surfaces,
                         points.hits,  lane,          &stage_.tables};
    const Vec3f radiance = shine(met, seen.rest_t[lane]);
    const float factor =
        emitter_factor(beaming, seen.doppler[lane]) / static_cast<float>(seen.density[lane]);
    from.irradiance.set(lane, radiance * factor);
    if (radiance == Vec3f(0)) from.active[lane] = 0;
    if (stage_.spectra.matters && from.active[lane] != 0) set_spectrum(met, seen, from);
    if (!parts_.are_wanted()) continue;
    from.group[lane] = stage_.group_of_material(points.surfaces.material[lane]);
  }
}

// Of what has a spectrum of its own, `radiance` was a colour of its light; nothing unlit has one here.
void PathWalk::set_spectrum(const MetSurface& met, const PointsSeen& seen, IncidentLanes& from) {
  const int lane = met.lane;
  const auto object = static_cast<std::size_t>(met.surfaces.object[lane]);
  const double clock = seen.rest_t[lane] + stage_.places[object].clock_at_anchor;
  from.omega[lane] = 1.0 / seen.doppler[lane];
  from.spectrum[lane] = stage_.spectra.of_material(met.surfaces.material[lane]);
  from.kelvin[lane] = evaluator_(met.material().emission_temperature, clock);
}

// What a surface emits to whoever sees it, times the part of it that is there.
Vec3f PathWalk::shine(const MetSurface& met, double rest_t) {
  const int lane = met.lane;
  const auto material = static_cast<std::size_t>(met.surfaces.material[lane]);
  const PlainMaterial& plain = stage_.plain[material];
  const bool seen = met.surfaces.back[lane] == 0 || plain.double_sided;
  if (plain.always) return seen ? plain.emission : Vec3f(0);
  const auto object = static_cast<std::size_t>(met.surfaces.object[lane]);
  const double clock = rest_t + stage_.places[object].clock_at_anchor;
  const Vec4f texture = texel(met, met.material().base_color_texture);
  const float there = coverage(met, texture.w, clock, evaluator_);
  if (there == 0.0F) return Vec3f(0);
  Vec3f radiance = emission(met, clock, evaluator_);
  if (plain.layered) radiance *= below_coat(met, met.surfaces.cosine[lane], clock, evaluator_);
  if (met.material().unlit) radiance += base_color(met, texture, clock, evaluator_);
  return there * radiance;
}

void PathWalk::add_emitters(const LitLanes& lit, const ViewLobeLanes& lobes) {
  const EmitterStage stage{stage_.scene, stage_.frames, stage_.emitters};
  PointNumbers numbers;
  for (int lane = 0; lane < packet_size; ++lane) {
    numbers.frame[lane] = random(lane, Dimension::emitter_frame);
    numbers.triangle[lane] = finer(random(lane, Dimension::emitter_triangle),
                                   random(lane, Dimension::emitter_triangle_digits));
    numbers.u[lane] = random(lane, Dimension::emitter_u);
    numbers.v[lane] = random(lane, Dimension::emitter_v);
  }
  Vec3fLanes towards;
  for (int lane = 0; lane < packet_size; ++lane) towards.set(lane, facing(lane));
  EmitterPoints points;
  choose_points(stage, vertices_.at.event, lit, towards, numbers, points);
  PointsSeen seen;
  IncidentLanes from;
  see_points(stage, vertices_.at.event, lit, points, seen, from);
  set_radiance(points, seen, from);
  for (int lane = 0; lane < packet_size; ++lane) {
    if (from.active[lane] == 0) continue;
    // A shadow ray ends before the triangle by what floats can not tell apart there.
    const RestFrame& frame = stage_.frames.frame(points.hits.frame[lane]);
    from.s_light[lane] -= frame.noise_at_end() * seen.doppler[lane];
  }
  add_sampled(from, seen.density, lit, lobes);
}

void PathWalk::add_sky(const Environment& sky, const LitLanes& lit, const ViewLobeLanes& lobes) {
  Lanes<float> u, v;
  for (int lane = 0; lane < packet_size; ++lane) {
    u[lane] = random(lane, Dimension::sky_u);
    v[lane] = random(lane, Dimension::sky_v);
  }
  IncidentLanes from;
  Lanes<double> density;
  incident_from_sky(sky, vertices_.at.event, lit,
                    {stage_.scene.light_speed, stage_.scene.render.beaming}, u, v, evaluator_, from,
                    density);
  if (stage_.spectra.matters) from.spectrum.fill(stage_.spectrum_of(sky.place));
  if (parts_.are_wanted()) from.group.fill(stage_.group_of(sky.place));
  add_sampled(from, density, lit, lobes);
}

// density: per steradian at the vertices, with which the lights' directions were chosen.
RESTFRAME_CLONES void PathWalk::add_sampled(IncidentLanes& from, const Lanes<double>& density,
                                            const LitLanes& lit, const ViewLobeLanes& lobes) {
  if (!any_active(from.active)) return;
  Vec3fLanes fraction;
  Lanes<float> by_chance;
  scattered_fraction(vertices_.bsdf, lobes, from.direction, fraction, by_chance);
  const double both = stage_.search == LightSearch::both ? 1.0 : 0.0;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double ratio = both * static_cast<double>(by_chance[i]) / density[i];
    const auto share = static_cast<float>(1.0 / (1.0 + ratio * ratio));
    from.irradiance.set(i, from.irradiance.at(i) * share);
  }
  darken_insides(from);
  add_arriving(from, lit, fraction, ShadowKind::as_paths_see);
}

}  // namespace restframe
