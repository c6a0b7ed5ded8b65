// Where paths go from their vertices, by the laws of optics in the rest frame there.

#include <algorithm>

#include "tracer/path_walk.h"

namespace restframe {
namespace {

constexpr int sure_scatterings = 3;  // before paths may end by chance

float largest(const Vec3f& v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

Medium PathWalk::medium_of(int lane, const MetSurface& met, double clock) {
  constexpr float darkest = 1e-6F;
  const Material& material = met.material();
  Medium medium{};
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
  const float own = std::max(1.0F, evaluator_(met.material().ior, clock));
  const MediumStack& media = media_[lane];
  const bool leaves = surfaces_.back[lane] != 0 && can_transmit(met.material());
  if (!leaves) return own / media.ior();
  MediumStack outside = media;
  outside.leave(surfaces_.object[lane], surfaces_.material[lane]);
  return outside.ior() / (media.empty() ? own : media.ior());
}

void PathWalk::scatter_on(int lane) {
  const auto scattered =
      scatter(vertices_.bsdf.at(lane), random(lane, Dimension::lobe),
              random(lane, Dimension::direction_u), random(lane, Dimension::direction_v));
  if (!scattered) return;
  weigh(lane, scattered->weight);
  if (!survives(lane)) return;
  set_chosen(lane, in_medium(lane) || scattered->through ? 0.0F : scattered->density);
  if (scattered->through && surfaces_.back[lane] != 0) {
    media_[lane].leave(surfaces_.object[lane], surfaces_.material[lane]);
  } else if (scattered->through) {
    if (media_[lane].full()) return;
    media_[lane].enter(medium_of(lane, met_surface(lane), clock_[lane]));
  }
  depart(lane, scattered->direction);
}

// Russian roulette: paths that hardly matter any more end by chance, the others stand for them.
bool PathWalk::survives(int lane) {
  const Vec3f throughput = paths_.throughput.at(lane);
  const float weight = follows_lines() ? history_.most_left(lane) : largest(throughput);
  if (!(weight > 0.0F)) return false;
  if (paths_.scatterings[lane] <= sure_scatterings) return true;
  const float chance = std::min(1.0F, weight);
  paths_.throughput.set(lane, throughput / chance);
  if (follows_lines()) history_.scale(lane, 1.0F / chance);
  return random(lane, Dimension::survival) < chance;
}

// The frequency stays in the scatterer's rest frame.
void PathWalk::depart(int lane, const Vec3f& direction) {
  const Event<in::World> from = vertices_.at.event.at(lane);
  const double omega = paths_.omega[lane];
  const Vec3 x = omega * glm::normalize(Vec3(direction));
  const RestFrame& frame = stage_.frames.frame(hits_.frame[lane]);
  const double s_min = frame.s_clear(hits_, lane, from, x);
  const auto world_from_rest = frame.coordinates().from_world.inverse();
  if (media_[lane].empty()) {
    rays_.origin.set(lane, from);
    rays_.k.set(lane, world_from_rest(WaveVector<in::Rest>{-omega, x}));
    rays_.s_min[lane] = s_min;
    rays_.active[lane] = -1;
    rays_.coherent = false;
    return;
  }
  const double index = static_cast<double>(media_[lane].ior());
  const auto step = world_from_rest(Displacement<in::Rest>{-index * omega, x});
  in_medium_.origin.set(lane, from);
  in_medium_.step.set(lane, {step.t, step.x});
  in_medium_.s_min[lane] = s_min;
  in_medium_.active[lane] = -1;
}

}  // namespace restframe
