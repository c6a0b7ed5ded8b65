// Where paths go from their vertices, by the laws of optics in the rest frame there.

#include <algorithm>
#include <cmath>
#include <limits>

#include "frames/lane_groups.h"
#include "physics/clones.h"
#include "tracer/path_walk.h"

namespace restframe {
namespace {

constexpr int sure_scatterings = 3;  // before paths may end by chance ...
// ... and only those that are left with less of their light: ending others costs more in noise than it
// saves in time (measured in lattices under skies and in closed rooms).
constexpr float worth_following = 0.25F;
constexpr float widest_spread = 0.25F;  // radians

float largest(const Vec3f& v) {
  return std::max(std::max(v.x, v.y), v.z);
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
  const bool leaves = surfaces_.back[lane] != 0 && refracts(met.material());
  if (!leaves) return own / media.ior();
  MediumStack outside = media;
  outside.leave(surfaces_.object[lane], surfaces_.material[lane]);
  return outside.ior() / (media.empty() ? own : media.ior());
}

void PathWalk::scatter_on() {
  const int depth =
      stage_.has_emitters ? std::numeric_limits<int>::max() : stage_.scene.render.depth;
  Lanes<std::int32_t> going;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    going[i] = paths_.scatterings[i] < depth ? vertices_.active[i] : 0;
  }
  if (!any_active(going)) return;
  ScatteredLanes scattered;
  scatter(vertices_.bsdf, vertices_.lobes, going, scattering_numbers(), scattered);
  for (int lane = 0; parts_.are_wanted() && lane < packet_size; ++lane) {
    if (scattered.active[lane] != 0) note_scattering(lane, scattered);
  }
  weigh(scattered);
  end_by_chance(scattered.active);
  set_chosen(scattered);
  for (int lane = 0; stage_.has_media && lane < packet_size; ++lane) {
    const bool through = scattered.active[lane] != 0 && scattered.through[lane] != 0;
    if (through && !change_sides(lane)) scattered.active[lane] = 0;
  }
  for (int lane = 0; stage_.tables.has_textures() && lane < packet_size; ++lane) {
    if (scattered.active[lane] != 0) widen_cone(lane, scattered.density[lane]);
  }
  if (any_active(scattered.active)) depart(scattered);
}

Vec3fLanes PathWalk::scattering_numbers() {
  Vec3fLanes numbers;
  if (!vertices_.bsdf.matte) numbers.x = random_.lanes(Dimension::lobe, round_);
  numbers.z = random_.lanes(Dimension::direction_v, round_);
  numbers.y = random_.lanes(Dimension::direction_u, round_);
  return numbers;
}

void PathWalk::weigh(const ScatteredLanes& scattered) {
  if (stage_.spectra.shifts) {
    for (int lane = 0; lane < packet_size; ++lane) {
      if (scattered.active[lane] != 0) weigh(lane, scattered.weight.at(lane));
    }
    return;
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3f left = paths_.throughput.at(i) * scattered.weight.at(i);
    set_in(scattered.active, i, paths_.throughput, left);
  }
}

// Russian roulette: of paths that hardly matter any more some end, the others stand for them.
void PathWalk::end_by_chance(Lanes<std::int32_t>& going) {
  Lanes<float> weight;
  Lanes<std::int32_t> at_risk;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) weight[i] = largest(paths_.throughput.at(i));
  for (int i = 0; follows_lines() && i < packet_size; ++i) weight[i] = history_.most_left(i);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    going[i] = weight[i] > 0.0F ? going[i] : 0;
    const bool sure = paths_.scatterings[i] <= sure_scatterings;
    at_risk[i] = (sure | (weight[i] >= worth_following)) ? 0 : going[i];
  }
  if (!any_active(at_risk)) return;
  const Lanes<float>& luck = random_.lanes(Dimension::survival, round_);
  for (int lane = 0; lane < packet_size; ++lane) {
    if (at_risk[lane] == 0) continue;
    const float chance = weight[lane] / worth_following;
    paths_.throughput.set(lane, paths_.throughput.at(lane) / chance);
    if (follows_lines()) history_.scale(lane, 1.0F / chance);
    if (!(luck[lane] < chance)) going[lane] = 0;
  }
}

// False: the path ends.
bool PathWalk::change_sides(int lane) {
  MediumStack& media = media_[lane];
  if (surfaces_.back[lane] != 0) {
    media.leave(surfaces_.object[lane], surfaces_.material[lane]);
    return true;
  }
  if (media.full()) return false;
  media.enter(medium_of(lane, met_surface(lane), clock_[lane]));
  return true;
}

// The cone goes on as wide as it is here. Mirrors and clear glass spread it no further; a direction that
// was chosen among others stands for those near it: for a part of the solid angle that is its own
// among all samples of the pixel. Angles are of the rest frame, where lengths are omega times s.
void PathWalk::widen_cone(int lane, float density) {
  RayCone& cone = paths_.cone[lane];
  cone.width = cone.at(hits_.s[lane]);
  if (!(density > 0.0F)) return;
  const float share = density * static_cast<float>(stage_.scene.render.samples);
  const float spread = std::min(widest_spread, 0.5F / std::sqrt(share));
  cone.slope += spread * static_cast<float>(paths_.omega[lane]);
}

// The frequency stays in the scatterers' rest frames.
RESTFRAME_CLONES void PathWalk::depart(const ScatteredLanes& scattered) {
  Lanes<double> s_min;
  stage_.frames.find_clear(hits_, vertices_.at, scattered.direction, paths_.omega, scattered.active,
                           s_min);
  WaveVectorLanes<in::Rest> k;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3 direction(scattered.direction.at(i));
    const double omega = paths_.omega[i];
    const double scale = omega / std::sqrt(glm::dot(direction, direction));
    k.set(i, {-omega, scale * direction});
  }
  Lanes<std::int32_t> outside = scattered.active;
  for (int lane = 0; stage_.has_media && lane < packet_size; ++lane) {
    if (outside[lane] == 0 || !in_medium(lane)) continue;
    outside[lane] = 0;
    depart_within(lane, k.at(lane).x, s_min[lane]);
  }
  for_each_group(hits_.frame, outside, [&](int first, const Lanes<std::int32_t>& group) {
    WaveVectorLanes<in::World> k_there;
    transform(world_from_rest(first), k, k_there);
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) {
      set_in(group, i, rays_.k.t, k_there.t[i]);
      set_in(group, i, rays_.k.x, k_there.x.at(i));
      set_in(group, i, rays_.origin.t, vertices_.at.event.t[i]);
      set_in(group, i, rays_.origin.x, vertices_.at.event.x.at(i));
      set_in(group, i, rays_.s_min, s_min[i]);
      set_in(group, i, rays_.active, -1);
    }
    rays_.coherent = false;
  });
}

// x: the spatial part of the wave vector, rest-frame axes.
void PathWalk::depart_within(int lane, const Vec3& x, double s_min) {
  const double index = static_cast<double>(media_[lane].ior());
  const auto step = world_from_rest(lane)(Displacement<in::Rest>{-index * paths_.omega[lane], x});
  in_medium_.origin.set(lane, vertices_.at.event.at(lane));
  in_medium_.step.set(lane, {step.t, step.x});
  in_medium_.s_min[lane] = s_min;
  in_medium_.active[lane] = -1;
}

}  // namespace restframe
