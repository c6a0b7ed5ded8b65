#include "tracer/path_walk.h"

#include <algorithm>
#include <cmath>

namespace restframe {
namespace {

constexpr std::uint32_t most_rounds = 1000;
constexpr int sure_scatterings = 3;  // before paths may end by chance

template <class T>
bool any(const Lanes<T>& active) {
  return std::any_of(std::begin(active.lane), std::end(active.lane), [](T a) { return a != 0; });
}

float largest(const Vec3f& v) {
  return std::max({v.x, v.y, v.z});
}

// Formulas may leave the range of what they stand for.
float fraction(float value) {
  return std::clamp(value, 0.0F, 1.0F);
}

// The triangle's own normal, on the side that the ray comes from.
Vec3f facet_towards_ray(const MetSurface& met) {
  const FramePart& part = met.frames.frame(met.hits.frame[met.lane]).part(met.hits.part[met.lane]);
  const Vec3f facet =
      glm::normalize(part.rest_from_facet_normal * met.hits.facet_normal.at(met.lane));
  return glm::dot(facet, met.hits.sight.at(met.lane)) > 0.0F ? -facet : facet;
}

}  // namespace

PathWalk::PathWalk(const PathStage& stage, const PacketId& id, TemporalEvaluator& evaluator,
                   RayPacket& rays, SurfaceDataLanes* data)
    : stage_(stage), id_(id), evaluator_(evaluator), rays_(rays), data_(data) {
  in_medium_.active.fill(0);
  if (data_ != nullptr) data_->fill({});
}

void PathWalk::run() {
  for (; round_ < most_rounds; ++round_) {
    if (!find_surfaces()) break;
    lit_.fill(0);
    for (int lane = 0; lane < packet_size; ++lane) {
      if (rays_.active[lane] != 0 || in_medium_.active[lane] != 0) step(lane);
    }
    if (any(lit_)) add_lights();
  }
}

void PathWalk::take_radiance(RadianceLanes& radiance) const {
  for (int lane = 0; lane < packet_size; ++lane) {
    radiance[lane] = Vec4f(states_[lane].radiance, states_[lane].coverage);
  }
}

// What the next surfaces are; false if no path goes on.
bool PathWalk::find_surfaces() {
  const bool outside = any(rays_.active);
  const bool inside = any(in_medium_.active);
  if (outside) stage_.frames.nearest(rays_, hits_);
  if (inside) stage_.frames.nearest(in_medium_, hits_);
  if (!inside) {
    surfaces_at(stage_.scene, stage_.frames, hits_, rays_.active, surfaces_);
    return outside;
  }
  Lanes<std::int32_t> active;
  for (int lane = 0; lane < packet_size; ++lane) {
    active[lane] = rays_.active[lane] | in_medium_.active[lane];
  }
  surfaces_at(stage_.scene, stage_.frames, hits_, active, surfaces_);
  return true;
}

// Objects of one velocity may be in several rest frames, by their sizes.
bool PathWalk::rests_together(int frame, int other) const {
  const auto velocity = [&](int index) {
    return stage_.frames.frame(index).coordinates().from_world.velocity();
  };
  return frame == other || velocity(frame) == velocity(other);
}

void PathWalk::step(int lane) {
  State& state = states_[lane];
  if (hits_.frame[lane] < 0) return miss(lane);
  stage_.frames.refine(hits_, lane);
  const MetSurface met{stage_.scene, stage_.frames, surfaces_, hits_, lane};
  const ObjectPlace& place = stage_.places[static_cast<std::size_t>(surfaces_.object[lane])];
  const double clock = clock_at(place, hits_, lane);
  const Vec4f texture = texel(met, met.material().base_color_texture);
  if (!state.media.empty() && !rests_together(state.media.top().frame, hits_.frame[lane])) {
    crossing_ = {state.media.top().object, surfaces_.object[lane]};
    in_medium_.active[lane] = 0;
    return;
  }
  const float stopped = coverage(met, texture.w, clock, evaluator_);
  if (random(lane, Dimension::opacity) >= stopped) return pass_straight(lane);
  if (data_ != nullptr && !(*data_)[lane].hit && state.scatterings == 0) {
    (*data_)[lane] = surface_data(met, place, rays_);
  }
  meet(lane, met, clock, texture);
}

void PathWalk::miss(int lane) {
  State& state = states_[lane];
  if (state.media.empty()) {
    for (const LightPlace& environment : stage_.environments) {
      state.radiance += state.throughput *
                        environment_radiance(environment, rays_.origin.at(lane), rays_.k.at(lane),
                                             stage_.scene.render.beaming, evaluator_);
      state.coverage = 1;
    }
  }
  rays_.active[lane] = 0;
  in_medium_.active[lane] = 0;
}

void PathWalk::pass_straight(int lane) {
  Lanes<double>& s_min = states_[lane].media.empty() ? rays_.s_min : in_medium_.s_min;
  s_min[lane] = stage_.frames.frame(hits_.frame[lane]).s_behind(hits_, lane);
}

// A surface that light does not just pass: it shines, and scatters.
void PathWalk::meet(int lane, const MetSurface& met, double clock, const Vec4f& texture) {
  State& state = states_[lane];
  state.coverage = 1;
  rays_.active[lane] = 0;
  in_medium_.active[lane] = 0;
  if (state.media.empty()) {
    state.omega = -hits_.rest_k_t[lane];
  } else {
    const float length = static_cast<float>(hits_.s[lane] * state.omega);
    state.throughput *= glm::exp(-length * state.media.top().absorbed);
  }
  Vec3f shines = emission(met, clock, evaluator_);
  const bool unlit = met.material().unlit;
  if (unlit) shines += base_color(met, texture, clock, evaluator_);
  state.radiance +=
      state.throughput * shines * emitter_factor(stage_.scene.render.beaming, 1.0 / state.omega);
  if (unlit || state.scatterings >= stage_.scene.render.depth) return;
  ++state.scatterings;
  set_vertex(lane, met, clock, texture);
  lit_[lane] = stage_.lights.empty() || !state.media.empty() ? 0 : -1;
  if (state.scatterings < stage_.scene.render.depth || stage_.has_emitters) {
    scatter_on(lane, met, clock);
  }
}

void PathWalk::set_vertex(int lane, const MetSurface& met, double clock, const Vec4f& texture) {
  const Material& material = met.material();
  const Vec4f finish = texel(met, material.metallic_roughness_texture);
  const float roughness = fraction(evaluator_(material.roughness, clock)) * finish.y;
  Vertex& vertex = vertices_[lane];
  Bsdf& bsdf = vertex.bsdf;
  bsdf.view = -hits_.sight.at(lane);
  bsdf.normal = surfaces_.normal.at(lane);
  bsdf.facet = facet_towards_ray(met);
  bsdf.base = glm::max(base_color(met, texture, clock, evaluator_), Vec3f(0));
  bsdf.metallic = fraction(evaluator_(material.metallic, clock)) * finish.z;
  bsdf.transmission = fraction(evaluator_(material.transmission, clock));
  bsdf.alpha = roughness * roughness;
  bsdf.eta = index_ratio(lane, met, clock);
  const RestFrame& frame = stage_.frames.frame(hits_.frame[lane]);
  vertex.lit = {frame.hit_event(hits_, lane), frame.coordinates().from_world, states_[lane].omega};
  vertex.throughput = states_[lane].throughput;
}

Medium PathWalk::medium_of(int lane, const MetSurface& met, double clock) {
  constexpr float darkest = 1e-6F;
  const Material& material = met.material();
  Medium medium;
  medium.frame = hits_.frame[lane];
  medium.object = surfaces_.object[lane];
  medium.material = surfaces_.material[lane];
  medium.ior = std::max(1.0F, evaluator_(material.ior, clock));
  const float distance = evaluator_(material.attenuation_distance, clock);
  if (distance > 0.0F) {
    const Vec3f left =
        glm::clamp(evaluator_(material.attenuation_color, clock), Vec3f(darkest), Vec3f(1));
    medium.absorbed = -glm::log(left) / distance * static_cast<float>(stage_.scene.light_speed);
  }
  return medium;
}

// From the side that the ray comes from to the other one.
float PathWalk::index_ratio(int lane, const MetSurface& met, double clock) {
  const MediumStack& media = states_[lane].media;
  const float own = std::max(1.0F, evaluator_(met.material().ior, clock));
  const bool leaves = surfaces_.back[lane] != 0 && can_transmit(met.material());
  if (!leaves) return own / media.ior();
  MediumStack outside = media;
  outside.leave(surfaces_.object[lane], surfaces_.material[lane]);
  return outside.ior() / (media.empty() ? own : media.ior());
}

void PathWalk::scatter_on(int lane, const MetSurface& met, double clock) {
  const auto scattered =
      scatter(vertices_[lane].bsdf, random(lane, Dimension::lobe),
              random(lane, Dimension::direction_u), random(lane, Dimension::direction_v));
  if (!scattered) return;
  State& state = states_[lane];
  state.throughput *= scattered->weight;
  if (!survives(lane)) return;
  if (scattered->through && surfaces_.back[lane] != 0) {
    state.media.leave(surfaces_.object[lane], surfaces_.material[lane]);
  } else if (scattered->through) {
    if (state.media.full()) return;
    state.media.enter(medium_of(lane, met, clock));
  }
  depart(lane, scattered->direction);
}

// Russian roulette: paths that hardly matter any more end by chance, the others stand for them.
bool PathWalk::survives(int lane) {
  State& state = states_[lane];
  const float weight = largest(state.throughput);
  if (!(weight > 0.0F)) return false;
  if (state.scatterings <= sure_scatterings) return true;
  const float chance = std::min(1.0F, weight);
  state.throughput /= chance;
  return random(lane, Dimension::survival) < chance;
}

// The frequency stays in the scatterer's rest frame.
void PathWalk::depart(int lane, const Vec3f& direction) {
  const State& state = states_[lane];
  const LitEvent& from = vertices_[lane].lit;
  const Vec3 x = state.omega * glm::normalize(Vec3(direction));
  const RestFrame& frame = stage_.frames.frame(hits_.frame[lane]);
  const double s_min = frame.s_clear(hits_, lane, from.event, x);
  const auto world_from_rest = from.rest_from_world.inverse();
  if (state.media.empty()) {
    rays_.origin.set(lane, from.event);
    rays_.k.set(lane, world_from_rest(WaveVector<in::Rest>{-state.omega, x}));
    rays_.s_min[lane] = s_min;
    rays_.active[lane] = -1;
    rays_.coherent = false;
    return;
  }
  const double index = static_cast<double>(state.media.ior());
  const auto step = world_from_rest(Displacement<in::Rest>{-index * state.omega, x});
  in_medium_.origin.set(lane, from.event);
  in_medium_.step.set(lane, {step.t, step.x});
  in_medium_.s_min[lane] = s_min;
  in_medium_.active[lane] = -1;
}

}  // namespace restframe
